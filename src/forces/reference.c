/* Integrates a system by the GNU Scientific Library, if it is installed. */
#include "forces/reference.h"

#include "forces/largest.h"

#ifdef WITH_GSL
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_TRIES = 1000000 }; /* largest number of steps in a call */

const bool reference_available = true;

struct reference_parts {
    gsl_odeiv2_step *step;
    gsl_odeiv2_evolve *evolve;
    double *y, *scale; /* [2 * size] */
};

/* Computes dy/dt for the library, which needs first-order equations. y
   contains x and then v. */
static int slopes(double t, const double y[], double dy[], void *what)
{
    struct reference *const r = what;
    const size_t n = r->forces.size;
    (void)t;
    memcpy(dy, y + n, n * sizeof *dy);
    r->forces.accelerate(r->forces.what, y, y + n, dy + n);
    ++r->evaluations;
    return GSL_SUCCESS;
}

bool reference_begin(struct reference *r, struct stepping_forces f,
                     double tolerance)
{
    const size_t n = 2 * f.size;
    struct reference_parts *const p = calloc(1, sizeof *p);
    *r =
        (struct reference){.forces = f, .tolerance = tolerance, .parts = p};
    if (!p)
        return false;
    gsl_set_error_handler_off();
    p->step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, n);
    p->evolve = gsl_odeiv2_evolve_alloc(n);
    p->y = malloc(n * sizeof *p->y);
    p->scale = malloc(n * sizeof *p->scale);
    if (p->step && p->evolve && p->y && p->scale)
        return true;
    reference_free(r);
    return false;
}

void reference_free(struct reference *r)
{
    struct reference_parts *const p = r->parts;
    if (p) {
        if (p->step)
            gsl_odeiv2_step_free(p->step);
        if (p->evolve)
            gsl_odeiv2_evolve_free(p->evolve);
        free(p->y);
        free(p->scale);
    }
    free(p);
    *r = (struct reference){0};
}

/* Returns the largest of n absolute values, or `otherwise` if it is 0. */
static double largest_or(const double y[], size_t n, double otherwise)
{
    const double most = largest(y, n);
    return most > 0 ? most : otherwise;
}

/* Returns a control object of the library that measures errors relative to
   the largest coordinate and the largest velocity, since a single
   coordinate may be zero. If all bodies are at rest, the velocity after dt
   is used. */
static gsl_odeiv2_control *control_errors(struct reference *r, double dt)
{
    struct reference_parts *const p = r->parts;
    const size_t n = r->forces.size;
    slopes(0, p->y, p->scale, r);
    const double a = largest(p->scale + n, n);
    const double v = largest_or(p->y + n, n, a > 0 ? a * fabs(dt) : 1);
    const double x = largest_or(p->y, n, v * fabs(dt));
    for (size_t i = 0; i < n; ++i) {
        p->scale[i] = x;
        p->scale[n + i] = v;
    }
    return gsl_odeiv2_control_scaled_new(r->tolerance, 0, 0, 0, p->scale,
                                         2 * n);
}

/* Returns whether n numbers are finite. The library does not check this. */
static bool are_finite(const double y[], size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; ++i)
        sum += 0 * y[i];
    return sum == 0;
}

/* Begins each call with a step of dt, whatever the earlier steps were. A
   run can therefore be resumed between any two calls. */
bool reference_step(struct reference *r, double dt, double x[], double v[])
{
    struct reference_parts *const p = r->parts;
    const size_t n = r->forces.size;
    gsl_odeiv2_system system = {slopes, NULL, 2 * n, r};
    double t = 0, h = dt;
    bool well = true;
    memcpy(p->y, x, n * sizeof *x);
    memcpy(p->y + n, v, n * sizeof *v);
    gsl_odeiv2_control *const control = control_errors(r, dt);
    gsl_odeiv2_evolve_reset(p->evolve);
    gsl_odeiv2_step_reset(p->step);
    for (long tries = 0; control && well && t != dt; ++tries)
        well = tries < MOST_TRIES &&
               gsl_odeiv2_evolve_apply(p->evolve, control, p->step, &system,
                                       &t, dt, &h, p->y) == GSL_SUCCESS;
    if (control)
        gsl_odeiv2_control_free(control);
    memcpy(x, p->y, n * sizeof *x);
    memcpy(v, p->y + n, n * sizeof *v);
    return control && well && are_finite(p->y, 2 * n);
}

#else
const bool reference_available = false;

bool reference_begin(struct reference *r, struct stepping_forces f,
                     double tolerance)
{
    *r = (struct reference){.forces = f, .tolerance = tolerance};
    return false;
}

bool reference_step(struct reference *r, double dt, double x[], double v[])
{
    (void)r, (void)dt, (void)x, (void)v;
    return false;
}

void reference_free(struct reference *r)
{
    *r = (struct reference){0};
}

#endif
