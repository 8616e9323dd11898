/* mistake: never-downwards */

double top_velocity(size_t n, const double masses[], double speed,
                    double restitution)
{
    double w = (1 + restitution) * speed;
    size_t k;
    for (k = 1; k < n; k++) {
        double share = masses[k - 1] / (masses[k - 1] + masses[k]);
        w *= (1 + restitution) * share;
    }
    return fmax(0, w - speed);
}
