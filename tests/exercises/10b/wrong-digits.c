/* mistake: digits-lost */

#include "exercise.h"
#include <math.h>

struct oscillator {
    double mass;
    double damping;
    double stiffness;
    double x;
    double v;
};

double oscillate(const struct oscillator *o, double t, double *velocity)
{
    double g = o->damping / 2 / o->mass, k = o->stiffness / o->mass;
    double x = o->x, v = o->v, w, e, p, q;
    if (g * g < k) {
        w = sqrt(k - g * g);
        e = exp(-g * t);
        p = e * cos(w * t);
        q = e * sin(w * t) / w;
    } else {
        double r1, r2, a;
        w = sqrt(g * g - k);
        r2 = -g - w;
        r1 = k / r2;
        a = (v - r2 * x) / (r1 - r2);
        e = exp(r1 * t);
        p = exp(r2 * t);
        q = w > 0 ? 0 : e * t;
        if (w > 0) {
            *velocity = r1 * a * e + r2 * (x - a) * p;
            return a * e + (x - a) * p;
        }
    }
    *velocity = p * v - q * (g * v + k * x);
    return p * x + q * (v + g * x);
}
