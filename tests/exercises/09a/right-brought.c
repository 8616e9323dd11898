/* One body after the other is brought in from far away; the energy is the
   work that was done. */

double potential_energy(size_t n, const double mass[], const double x[],
                        double k2, double softening, double potential[])
{
    double work = 0.0, here;
    for (size_t i = n; i-- > 0;) {
        here = 0.0;
        for (size_t j = i + 1; j < n; j++) {
            double d[4] = {softening}, rr = 0.0;
            for (int k = 0; k < 3; k++)
                d[k + 1] = x[(size_t)k * n + j] - x[(size_t)k * n + i];
            for (int k = 0; k < 4; k++)
                rr += d[k] * d[k];
            here -= k2 * mass[j] * pow(rr, -0.5);
            potential[j] += -k2 * mass[i] * pow(rr, -0.5);
        }
        potential[i] = here;
        work += mass[i] * here;
    }
    return work;
}
