/* A right answer: speed of approach and distance, backwards. */

static double length(const double r[], int d)
{
    return d == 2 ? hypot(r[0], r[1]) : hypot(hypot(r[0], r[1]), r[2]);
}

static double along(const double v[], const double r[], int d)
{
    double s = length(r, d), sum = 0;
    while (d-- > 0)
        sum += v[d] * (r[d] / s);
    return sum;
}

double compressibility(int dimensions, const double box[3], size_t n,
                       double energy, double time, size_t count,
                       const struct collision collisions[],
                       double *pressure)
{
    double f = dimensions * (n - 1.0), kt = 2 * energy / f, z = 0;
    const struct collision *c = collisions + count;
    *pressure = n * kt / box[0] / box[1];
    if (dimensions > 2)
        *pressure /= box[2];
    while (c-- > collisions) {
        double m = c->mass[0] * c->mass[1] / (c->mass[0] + c->mass[1]);
        double u = along(c->first, c->apart, dimensions) -
                   along(c->second, c->apart, dimensions);
        z += length(c->apart, dimensions) * 2 * m * u;
    }
    z = z / (dimensions * n * kt * time) + 1;
    *pressure *= z;
    return z;
}
