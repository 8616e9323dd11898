/* From chapters/04-piston.nw: edit there, then run make tangle. */
/* checksum 1275280690 of the lines below */
/* Moves the piston in steps, and computes its period and frequency. */
#include "line/piston.h"

#include <math.h>

double piston_gas_energy(const struct piston_gas *gas, double length)
{
    const double ratio = gas->length / length;
    return gas->energy * (ratio * ratio);
}

double piston_potential(const struct piston *p, double x)
{
    return piston_gas_energy(&p->left, x) +
           piston_gas_energy(&p->right, p->length - x);
}

double piston_force(const struct piston *p, double x)
{
    const double rest = p->length - x;
    return 2 * piston_gas_energy(&p->left, x) / x -
           2 * piston_gas_energy(&p->right, rest) / rest;
}

double piston_inertia(const struct piston *p)
{
    return p->mass + (p->left.mass + p->right.mass) / 3;
}

double piston_energy(const struct piston *p, const struct piston_state *s)
{
    return piston_inertia(p) * s->v * s->v / 2 + piston_potential(p, s->x);
}

static bool is_inside(const struct piston *p, double x)
{
    return x > 0 && x < p->length;
}

bool piston_step(const struct piston *p, struct piston_state *s, double dt)
{
    const double middle = s->x + s->v * (dt / 2);
    const double a = piston_force(p, middle) / piston_inertia(p);
    const double v = s->v + a * dt;
    const double x = middle + v * (dt / 2);
    if (!is_inside(p, x))
        return false;
    *s = (struct piston_state){x, v};
    return true;
}

bool piston_step_rk4(const struct piston *p, struct piston_state *s,
                     double dt)
{
    static const double ahead[4] = {0, 0.5, 0.5, 1};
    static const double weight[4] = {1, 2, 2, 1};
    double v = 0, a = 0, dx = 0, dv = 0;
    for (int k = 0; k < 4; ++k) {
        const double x = s->x + ahead[k] * dt * v;
        v = s->v + ahead[k] * dt * a;
        if (!is_inside(p, x))
            return false;
        a = piston_force(p, x) / piston_inertia(p);
        dx += weight[k] / 6 * dt * v;
        dv += weight[k] / 6 * dt * a;
    }
    if (!is_inside(p, s->x + dx))
        return false;
    *s = (struct piston_state){s->x + dx, s->v + dv};
    return true;
}

/* Returns the constant K l^2 of a gas (J m^2). */
static double invariant(const struct piston_gas *gas)
{
    return piston_gas_energy(gas, 1);
}

double piston_rest(const struct piston *p)
{
    const double ratio = cbrt(invariant(&p->left) / invariant(&p->right));
    return p->length * (ratio / (1 + ratio));
}

double piston_frequency(const struct piston *p)
{
    const double x = piston_rest(p), rest = p->length - x;
    const double stiffness =
        6 * (piston_gas_energy(&p->left, x) / (x * x) +
             piston_gas_energy(&p->right, rest) / (rest * rest));
    return sqrt(stiffness / piston_inertia(p));
}

double piston_period(const struct piston *p, double energy, size_t points)
{
    const double pi = acos(-1), L = p->length;
    double a, b, sum = 0;
    if (!piston_turning_points(p, energy, &a, &b))
        return NAN;
    const double linear = a + b - 2 * L;
    const double constant = -invariant(&p->left) * L * L / (energy * a * b);
    for (size_t k = 0; k < points; ++k) {
        const double s = pi * ((double)k + 0.5) / (double)points;
        const double x = (a + b) / 2 - (b - a) / 2 * cos(s);
        sum += x * (L - x) / sqrt(-constant - x * (x + linear));
    }
    return sqrt(2 * piston_inertia(p) / energy) * pi * sum / (double)points;
}

/* Returns the length (in m) of the gas `near` when the piston turns
   round. */
static double turning_length(const struct piston_gas *near,
                             const struct piston_gas *far, double box,
                             double energy)
{
    const struct piston p = {1, box, *near, *far};
    const double rest = piston_rest(&p);
    double x, next = sqrt(invariant(near) / energy);
    do {
        x = next;
        next = x + (piston_potential(&p, x) - energy) / piston_force(&p, x);
    } while (next > x && next < rest);
    return x;
}

bool piston_turning_points(const struct piston *p, double energy,
                           double *low, double *high)
{
    if (!(energy >= piston_potential(p, piston_rest(p))))
        return false;
    *low = turning_length(&p->left, &p->right, p->length, energy);
    *high =
        p->length - turning_length(&p->right, &p->left, p->length, energy);
    return true;
}

/* Returns the force (in N) on the piston from a standing wave in a gas, if
   the velocity amplitude of the piston is 1 m/s. */
static double wave_force(const struct piston_gas *gas, double length,
                         double frequency)
{
    const double K = piston_gas_energy(gas, length);
    if (gas->mass == 0)
        return 6 * K / (length * length) / frequency;
    const double c = sqrt(6 * K / gas->mass);
    return gas->mass / length * c / tan(frequency * length / c);
}

/* Returns the lowest positive frequency (in 1/s) at which wave_force is
   infinite. */
static double wave_pole(const struct piston_gas *gas, double length)
{
    const double K = piston_gas_energy(gas, length);
    return acos(-1) * sqrt(6 * K / gas->mass) / length;
}

double piston_frequency_acoustic(const struct piston *p)
{
    struct piston bare = *p;
    bare.left.mass = bare.right.mass = 0;
    const double x = piston_rest(p), rest = p->length - x;
    double low = 0, high = piston_frequency(&bare);
    high = fmin(high,
                fmin(wave_pole(&p->left, x), wave_pole(&p->right, rest)));
    for (double middle = high / 2; middle > low && middle < high;
         middle = (low + high) / 2)
        if (middle * p->mass < wave_force(&p->left, x, middle) +
                                   wave_force(&p->right, rest, middle))
            low = middle;
        else
            high = middle;
    return low;
}
