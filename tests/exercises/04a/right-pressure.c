/* A right answer: the pressure of the textbooks, with an exponent gamma. */

static double pressed(double in_the_middle, double gamma, double part)
{
    return in_the_middle * exp(-gamma * log(2 * part));
}

void piston_slopes(int f, double length, double mass, double gas,
                   const double energy[2], const double state[2],
                   double slope[2])
{
    double gamma = (f + 2.0) / f, part = state[0] / length;
    double factor = 4 / (f * length);
    double force = factor * (pressed(energy[0], gamma, part) -
                             pressed(energy[1], gamma, 1 - part));
    slope[1] = 3 * force / (3 * mass + gas);
    slope[0] = state[1];
}
