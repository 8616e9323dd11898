/* mistake: masses-exchanged */

double top_velocity(size_t n, const double masses[], double speed,
                    double restitution)
{
    double w = restitution * speed;
    size_t k;
    for (k = 1; k < n; k++)
        w = -speed + (1 + restitution) * masses[k] /
                         (masses[k - 1] + masses[k]) * (w + speed);
    return w;
}
