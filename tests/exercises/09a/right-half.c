/* Every body looks at all others; half of the sum is the energy. */

double potential_energy(size_t n, const double mass[], const double x[],
                        double k2, double softening, double potential[])
{
    const double *y = x + n, *z = y + n;
    double twice = 0;
    size_t i, j;
    for (i = 0; i < n; i++) {
        double sum = 0;
        for (j = 0; j < n; j++)
            if (j != i)
                sum += mass[j] / hypot(hypot(x[i] - x[j], y[i] - y[j]),
                                       hypot(z[i] - z[j], softening));
        potential[i] = -k2 * sum;
        twice += mass[i] * potential[i];
    }
    return twice / 2;
}
