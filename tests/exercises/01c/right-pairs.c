/* A right answer: on the ground, pair by pair, both velocities kept. */

double top_velocity(size_t n, const double masses[], double speed,
                    double restitution)
{
    double below = restitution * speed, above = below;
    size_t k;
    for (k = 0; k + 1 < n; k++) {
        double m = masses[k], next = masses[k + 1];
        double centre = (m * below - next * speed) / (m + next);
        above = centre + restitution * m / (m + next) * (below + speed);
        below = above;
    }
    return above;
}
