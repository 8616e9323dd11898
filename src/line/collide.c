/* From chapters/01-collide.nw: edit there, then run make tangle. */
/* checksum 3826417927 of the lines below */
/* Collides bodies on a line or along a normal, by a choice of formulas. */
#include "line/collide.h"

#include <float.h>
#include <math.h>

/* Returns whether the result of the collision is defined. It is undefined
   for two walls, for negative inverse masses, and if their sum is
   infinite. */
static bool can_collide(double im1, double im2)
{
    const double sum = im1 + im2;
    return im1 >= 0 && im2 >= 0 && sum > 0 && sum <= DBL_MAX;
}

/* Splits `change`, the change of the relative velocity, into the decrease
   part[0] of v1 and the increase part[1] of v2 (1.12, eq:smaller). */
static void split(double change, double im1, double im2, double part[2])
{
    const bool heavier = im1 >= im2; /* index of the heavier body */
    const double smaller = (im1 < im2 ? im1 : im2) / (im1 + im2);
    part[heavier] = change * smaller;
    part[!heavier] = change - part[heavier];
}

bool collide(double *v1, double *v2, double im1, double im2,
             double restitution)
{
    double part[2];
    if (!can_collide(im1, im2))
        return false;
    split((1 + restitution) * (*v1 - *v2), im1, im2, part);
    *v1 -= part[0];
    *v2 += part[1];
    return true;
}

/* Copies the normal to n, and sets *nn to n.n. If this square would
   overflow or lose digits, n is scaled first. Returns false if the number
   of dimensions is not 1 to COLLIDE_DIMENSIONS, or if the normal is zero or
   not finite. */
static bool safe_normal(size_t dimensions, const double normal[],
                        double n[], double *nn)
{
    if (dimensions < 1 || dimensions > COLLIDE_DIMENSIONS)
        return false;
    *nn = 0;
    for (size_t i = 0; i < dimensions; ++i) {
        n[i] = normal[i];
        *nn += n[i] * n[i];
    }
    if (*nn > 1e-20 && *nn < 1e20)
        return true;
    double largest = 0;
    int exponent;
    for (size_t i = 0; i < dimensions; ++i)
        largest = fmax(largest, fabs(n[i]));
    if (!(largest > 0 && largest <= DBL_MAX))
        return false;
    frexp(largest, &exponent);
    *nn = 0;
    for (size_t i = 0; i < dimensions; ++i) {
        n[i] = ldexp(n[i], -exponent);
        *nn += n[i] * n[i];
    }
    return *nn >= 0.25;
}

bool collide_along(size_t dimensions, const double normal[], double v1[],
                   double v2[], double im1, double im2, double restitution)
{
    double n[COLLIDE_DIMENSIONS], nn, approach = 0, part[2];
    if (!can_collide(im1, im2) || !safe_normal(dimensions, normal, n, &nn))
        return false;
    for (size_t i = 0; i < dimensions; ++i)
        approach += (v1[i] - v2[i]) * n[i];
    split((1 + restitution) * (approach / nn), im1, im2, part);
    for (size_t i = 0; i < dimensions; ++i) {
        v1[i] -= part[0] * n[i];
        v2[i] += part[1] * n[i];
    }
    return true;
}

const char *const collide_form_names[COLLIDE_FORMS + 1] = {
    "cm", "difference", "impulse", "complement", "smaller", NULL};

bool collide_by(enum collide_form form, double *v1, double *v2, double im1,
                double im2, double restitution)
{
    const double u1 = *v1, u2 = *v2, sum = im1 + im2;
    const double change = (1 + restitution) * (u1 - u2);
    if (form == COLLIDE_SMALLER || !can_collide(im1, im2))
        return collide(v1, v2, im1, im2, restitution);
    if (form == COLLIDE_CM) {
        const double c = (im2 * u1 + im1 * u2) / sum;
        *v1 = c - restitution * (u1 - c);
        *v2 = c - restitution * (u2 - c);
    } else if (form == COLLIDE_IMPULSE) {
        const double impulse = change / sum;
        *v1 = u1 - impulse * im1;
        *v2 = u2 + impulse * im2;
    } else {
        double fraction1 = im1 / sum, fraction2 = im2 / sum;
        if (form == COLLIDE_COMPLEMENT && im1 >= im2)
            fraction2 = 1 - fraction1;
        else if (form == COLLIDE_COMPLEMENT)
            fraction1 = 1 - fraction2;
        *v1 = u1 - fraction1 * change;
        *v2 = u2 + fraction2 * change;
    }
    return true;
}

bool collide_along_by(enum collide_form form, size_t dimensions,
                      const double normal[], double v1[], double v2[],
                      double im1, double im2, double restitution)
{
    double n[COLLIDE_DIMENSIONS], nn, along1 = 0, along2 = 0, w1, w2;
    if (form == COLLIDE_SMALLER || !can_collide(im1, im2) ||
        !safe_normal(dimensions, normal, n, &nn))
        return collide_along(dimensions, normal, v1, v2, im1, im2,
                             restitution);
    for (size_t i = 0; i < dimensions; ++i) {
        along1 += v1[i] * n[i] / nn;
        along2 += v2[i] * n[i] / nn;
    }
    w1 = along1;
    w2 = along2;
    collide_by(form, &w1, &w2, im1, im2, restitution);
    for (size_t i = 0; i < dimensions; ++i) {
        v1[i] += (w1 - along1) * n[i];
        v2[i] += (w2 - along2) * n[i];
    }
    return true;
}
