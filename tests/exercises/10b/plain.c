/* A right answer in plain C, with which wrong.diff begins. */

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
        w = sqrt(g * g - k);
        e = exp(-k / (g + w) * t);
        p = e * (1 + exp(-2 * w * t)) / 2;
        q = w > 0 ? e * -expm1(-2 * w * t) / 2 / w : e * t;
    }
    *velocity = p * v - q * (g * v + k * x);
    return p * x + q * (v + g * x);
}
