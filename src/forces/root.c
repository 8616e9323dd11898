/* From chapters/11-spheres.nw: edit there, then run make tangle. */
/* checksum 4257900286 of the lines below */
/* Finds the first root of a curve in Bernstein's form, by bisection. */
#include "forces/root.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* Divides a curve into halves: q becomes the first half, r the second. */
static void halve(double q[], double r[], size_t m)
{
    for (size_t level = 0; level <= m; ++level) {
        r[m - level] = q[m];
        size_t j = m;
        while (j > level) {
            q[j] = (q[j - 1] + q[j]) / 2;
            --j;
        }
    }
}

/* Returns whether a control point is below 0 by more than rounding. If none
   is, the curve is nowhere below 0 by more than rounding. */
static bool goes_below(const double q[], size_t m, double rounding)
{
    for (size_t j = 0; j <= m; ++j)
        if (q[j] < -rounding)
            return true;
    return false;
}

double root_first(const double q[], size_t m, double rounding, int halvings)
{
    double left[ROOT_DEGREE + 1], right[ROOT_DEGREE + 1];
    if (!goes_below(q, m, rounding))
        return INFINITY;
    if (halvings == 0)
        return 0.5;
    memcpy(left, q, (m + 1) * sizeof *q);
    halve(left, right, m);
    const double before = root_first(left, m, rounding, halvings - 1);
    if (before <= 1)
        return before / 2;
    return (1 + root_first(right, m, rounding, halvings - 1)) / 2;
}

/* Divides a polynomial in Bernstein's form by the time t. The polynomial
   must be 0 at t = 0. Returns the degree of the quotient. */
static size_t divide_by_time(double q[], size_t m)
{
    for (size_t j = 0; j < m; ++j)
        q[j] = q[j + 1] * (double)m / (double)(j + 1);
    return m - 1;
}

double root_next(double q[], size_t m, double slope, double rounding)
{
    for (size_t j = m + 1; j-- > 0;)
        q[j] -= q[0];
    m = divide_by_time(q, m);
    q[0] = slope;
    return root_first(q, m, rounding, ROOT_HALVINGS);
}
