/* A right answer in plain C, with which wrong.diff begins. */

double potential_energy(size_t n, const double mass[], const double x[],
                        double k2, double softening, double potential[])
{
    double sum = 0, dx, dy, dz, rr, u;
    size_t i, j;
    for (i = 0; i < n; i++) {
        potential[i] = 0;
        for (j = 0; j < n; j++) {
            if (i == j)
                continue;
            dx = x[j] - x[i];
            dy = x[n + j] - x[n + i];
            dz = x[2 * n + j] - x[2 * n + i];
            rr = dx * dx + dy * dy + dz * dz;
            u = -k2 / sqrt(rr + softening * softening);
            potential[i] += u * mass[j];
        }
        sum += mass[i] * potential[i];
    }
    return sum / 2;
}
