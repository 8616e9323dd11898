/* A right answer in plain C, with which wrong.diff begins. */

double compressibility(int dimensions, const double box[3], size_t n,
                       double energy, double time, size_t count,
                       const struct collision collisions[],
                       double *pressure)
{
    double kt = 2 * energy / (dimensions * (n - 1.0)), sum = 0, volume = 1,
           z;
    size_t i;
    int k;
    for (i = 0; i < count; i++) {
        const struct collision *c = &collisions[i];
        double m0 = c->mass[0], m1 = c->mass[1], rr = 0, u = 0, s;
        for (k = 0; k < dimensions; k++) {
            double w = c->first[k] - c->second[k];
            rr += c->apart[k] * c->apart[k];
            u += w * c->apart[k];
        }
        s = sqrt(rr);
        u = u / s;
        sum += s * 2 * m0 * m1 / (m0 + m1) * u;
    }
    for (k = 0; k < dimensions; k++)
        volume *= box[k];
    z = 1 + sum / (dimensions * n * kt * time);
    *pressure = z * n * kt / volume;
    return z;
}
