/* A right answer: the two collide, and the momentum of one has changed. */

double compressibility(int dimensions, const double box[3], size_t n,
                       double energy, double time, size_t count,
                       const struct collision collisions[],
                       double *pressure)
{
    double kt = 2 * energy / dimensions / (n - 1), sum = 0, v, ideal;
    size_t i;
    int k;
    for (i = 0; i < count; i++) {
        struct collision c = collisions[i];
        double part = c.mass[1] / (c.mass[0] + c.mass[1]);
        double rr = 0, rw = 0;
        for (k = 0; k < dimensions; k++) {
            double w = part * (c.first[k] - c.second[k]);
            rr += c.apart[k] * c.apart[k];
            rw += c.apart[k] * w;
        }
        for (k = 0; k < dimensions; k++) {
            double change = -2 * rw / rr * c.apart[k];
            sum -= c.mass[0] * change * c.apart[k];
        }
    }
    v = box[0] * box[1] * (dimensions == 3 ? box[2] : 1);
    ideal = n * kt / v;
    *pressure = ideal + sum / dimensions / v / time;
    return *pressure / ideal;
}
