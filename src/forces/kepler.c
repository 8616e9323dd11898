/* From chapters/09-gravity.nw: edit there, then run make tangle. */
/* checksum 4183817133 of the lines below */
/* Solves Kepler's equation and moves a body along its ellipse. */
#include "forces/kepler.h"

#include <math.h>

static double dot(const double a[], const double b[])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void kepler_shape(double mu, const double x[], const double v[],
                  double *axis, double *eccentricity)
{
    const double r = sqrt(dot(x, x)), along = dot(x, v);
    const double inverse = 2 / r - dot(v, v) / mu;
    const double cosine = 1 - r * inverse;             /* e cos E */
    const double sine2 = along * along / mu * inverse; /* (e sin E)^2 */
    *axis = 1 / inverse;
    *eccentricity = sqrt(fmax(cosine * cosine + sine2, 0));
}

double kepler_anomaly(double eccentricity, double mean_anomaly)
{
    const double e = eccentricity, pi = KEPLER_PI;
    const double turns = floor(mean_anomaly / (2 * pi) + 0.5);
    const double m = mean_anomaly - turns * 2 * pi, size = fabs(m);
    double next = fmin(fmin(size + e, size / (1 - e)), pi), anomaly;
    do {
        double c, s;
        anomaly = next;
        kepler_turn(anomaly, &c, &s);
        next = anomaly - (anomaly - e * s - size) / (1 - e * c);
    } while (next < anomaly);
    return copysign(anomaly, m) + turns * 2 * pi;
}

/* Returns sin(x) / x for |x| <= pi / 4, where s = x^2. */
static double sine_series(double s)
{
    double sum = 1;
    for (int n = 16; n > 0; n -= 2)
        sum = 1 - s / (n * (n + 1)) * sum;
    return sum;
}

/* Returns cos(x) for |x| <= pi / 4, where s = x^2. */
static double cosine_series(double s)
{
    double sum = 1;
    for (int n = 17; n > 0; n -= 2)
        sum = 1 - s / (n * (n + 1)) * sum;
    return sum;
}

void kepler_turn(double angle, double *cosine, double *sine)
{
    /* pi / 2 in three parts; the first two have 33 bits */
    const double part[] = {0x1.921fb544p0, 0x1.0b4611a6p-34,
                           0x1.3198a2e037073p-69};
    const double quarters = floor(angle / (KEPLER_PI / 2) + 0.5);
    double x = angle;
    for (int k = 0; k < 3; ++k)
        x -= quarters * part[k];
    const double c = cosine_series(x * x), s = x * sine_series(x * x);
    const int quarter = (int)(quarters - 4 * floor(quarters / 4));
    *cosine = quarter == 0 ? c : quarter == 1 ? -s : quarter == 2 ? -c : s;
    *sine = quarter == 0 ? s : quarter == 1 ? c : quarter == 2 ? -s : -c;
}

/* Rotates x by an angle in the plane of the axes `from` and `to`. The minus
   sign has its own variable because gcc 12 with -march=native otherwise
   uses a fused multiply-add despite -ffp-contract=off, so that the bits of
   the scenes would depend on the build. */
static void turn(double x[], int from, int to, double angle)
{
    double c, s;
    kepler_turn(angle, &c, &s);
    const double a = x[from], b = x[to], back = -s;
    x[from] = c * a + back * b;
    x[to] = s * a + c * b;
}

void kepler_place(double mu, const struct kepler_elements *o, double x[],
                  double v[])
{
    const double a = o->axis, e = o->eccentricity;
    const double flat = sqrt((1 - e) * (1 + e));
    double c, s;
    kepler_turn(kepler_anomaly(e, o->mean_anomaly), &c, &s);
    const double speed = sqrt(mu / a) / (1 - e * c);
    x[0] = a * (c - e), x[1] = a * flat * s, x[2] = 0;
    v[0] = -speed * s, v[1] = speed * flat * c, v[2] = 0;
    double *both[] = {x, v};
    for (int k = 0; k < 2; ++k) {
        turn(both[k], 0, 1, o->perihelion);
        turn(both[k], 1, 2, o->inclination);
        turn(both[k], 0, 1, o->node);
    }
}

/* Returns a guess for the change of the eccentric anomaly while the mean
   anomaly changes by m: the first two terms of a series. p and q are e cos
   E and e sin E at the start. The error is of the order of m^3. */
static double first_guess(double p, double q, double m)
{
    const double g = m / (1 - p);
    return g - q / (1 - p) * g * g / 2;
}

/* Computes the cosine and the sine of the change of the eccentric anomaly.
   p, q and m are those of first_guess. */
static void change(double p, double q, double m, double *cosine,
                   double *sine)
{
    const double e = sqrt(p * p + q * q);
    double low = m - 2 * e, high = m + 2 * e;
    double d = fmin(fmax(first_guess(p, q, m), low), high), step = 1;
    for (int n = 0; n < 100 && !(fabs(step) < 1e-9); ++n) {
        kepler_turn(d, cosine, sine);
        const double c = *cosine, s = *sine;
        const double f = d - p * s + q * (1 - c) - m;
        *(f > 0 ? &high : &low) = d;
        double next = d - f / (1 - p * c + q * s);
        if (!(next >= low && next <= high))
            next = (low + high) / 2;
        step = next - d;
        d = next;
    }
    const double c = *cosine;
    *cosine -= step * *sine;
    *sine += step * c;
}

void kepler_move(double mu, double t, double x[], double v[])
{
    const double r = sqrt(dot(x, x)), a = 1 / (2 / r - dot(v, v) / mu);
    const double n = sqrt(mu / a) / a, pi = KEPLER_PI;
    if (!(n > 0)) {
        x[0] = NAN;
        return;
    }
    const double p = 1 - r / a, q = dot(x, v) / sqrt(mu * a);
    const double m = n * t - 2 * pi * floor(n * t / (2 * pi) + 0.5);
    double c, s;
    change(p, q, m, &c, &s);
    const double after = a * (1 - p * c + q * s);
    const double f = 1 - a / r * (1 - c);
    const double g = (s - p * s + q * (1 - c)) / n;
    const double df = -sqrt(mu * a) * s / (r * after);
    const double dg = 1 - a / after * (1 - c);
    for (int k = 0; k < 3; ++k) {
        const double x0 = x[k], v0 = v[k];
        x[k] = f * x0 + g * v0;
        v[k] = df * x0 + dg * v0;
    }
}
