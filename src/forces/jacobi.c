/* From chapters/09-gravity.nw: edit there, then run make tangle. */
/* checksum 1868560840 of the lines below */
/* Moves bodies along ellipses, and computes the perturbing forces. */
#include "forces/jacobi.h"

#include "forces/kepler.h"
#include "toolbox/aligned.h"

#include <math.h>
#include <stdlib.h>

/* Source: (9.9, eq:jacobi). */
void jacobi_enter(const struct jacobi *j, const double x[], double q[])
{
    const size_t n = j->bodies;
    for (size_t k = 0; k < 3 * n; k += n) {
        double centre = x[k];
        for (size_t i = 1; i < n; ++i) {
            q[k + i] = x[k + i] - centre;
            centre += j->fraction[i] * q[k + i];
        }
        q[k] = centre;
    }
}

void jacobi_leave(const struct jacobi *j, const double q[], double x[])
{
    const size_t n = j->bodies;
    for (size_t k = 0; k < 3 * n; k += n) {
        double centre = q[k];
        for (size_t i = n; i-- > 1;) {
            centre -= j->fraction[i] * q[k + i];
            x[k + i] = centre + q[k + i];
        }
        x[k] = centre;
    }
}

static void move_body(const struct jacobi *j, size_t i, double dt,
                      double q[], double w[])
{
    const size_t n = j->bodies;
    double x[3] = {q[0], q[n], q[2 * n]}, v[3] = {w[0], w[n], w[2 * n]};
    kepler_move(j->mu[i], dt, x, v);
    for (size_t k = 0; k < 3; ++k) {
        q[k * n] = x[k];
        w[k * n] = v[k];
    }
}

void jacobi_flow(void *what, double dt, double x[], double v[])
{
    const struct jacobi *j = what;
    const size_t n = j->bodies;
    double *const q = j->work, *const w = j->work + 3 * n;
    jacobi_enter(j, x, q);
    jacobi_enter(j, v, w);
    for (size_t k = 0; k < 3 * n; k += n)
        q[k] += dt * w[k];
    for (size_t i = 1; i < n; ++i)
        move_body(j, i, dt, q + i, w + i);
    jacobi_leave(j, q, x);
    jacobi_leave(j, w, v);
}

/* Replaces the vector q[0], q[n], q[2 n] by mu q / |q|^3. */
static void turn_into_pull(double q[], size_t n, double mu)
{
    const double s = q[0] * q[0] + q[n] * q[n] + q[2 * n] * q[2 * n];
    const double w = mu > 0 ? mu / (s * sqrt(s)) : 0;
    q[0] *= w;
    q[n] *= w;
    q[2 * n] *= w;
}

static void add_pair(const struct jacobi *j, size_t i, size_t k,
                     const double x[], double a[])
{
    const size_t n = j->bodies;
    const double d[] = {x[k] - x[i], x[n + k] - x[n + i],
                        x[2 * n + k] - x[2 * n + i]};
    const double s = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const double w = j->k2 / (s * sqrt(s));
    const double to_i = w * j->mass[k], to_k = w * j->mass[i];
    for (size_t c = 0; c < 3; ++c) {
        a[c * n + i] += to_i * d[c];
        a[c * n + k] -= to_k * d[c];
    }
}

static void accelerate(void *what, const double x[], const double v[],
                       double a[])
{
    const struct jacobi *j = what;
    const size_t n = j->bodies;
    double *const q = j->work;
    (void)v;
    jacobi_enter(j, x, q);
    for (size_t i = 0; i < n; ++i)
        turn_into_pull(q + i, n, i > 1 ? j->mu[i] : 0);
    jacobi_leave(j, q, a);
    for (size_t i = 0; i < n; ++i)
        for (size_t k = i > 0 ? i + 1 : 2; k < n; ++k)
            add_pair(j, i, k, x, a);
}

bool jacobi_create(struct jacobi *j, size_t bodies, const double mass[],
                   double k2)
{
    double *const room = aligned_doubles(8 * bodies);
    double sum = 0;
    if (!room)
        return false;
    *j = (struct jacobi){.bodies = bodies, .k2 = k2, .mass = mass};
    j->fraction = room;
    j->mu = room + bodies;
    j->work = room + 2 * bodies;
    for (size_t i = 0; i < bodies; ++i) {
        sum += mass[i];
        j->fraction[i] = mass[i] / sum;
        j->mu[i] = k2 * sum;
    }
    return true;
}

void jacobi_free(struct jacobi *j)
{
    free(j->fraction);
    *j = (struct jacobi){0};
}

struct stepping_forces jacobi_forces(struct jacobi *j)
{
    return (struct stepping_forces){3 * j->bodies, false, accelerate, j};
}
