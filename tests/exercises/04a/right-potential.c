/* A right answer: the slope of the energy stored in the two gases. */

void piston_slopes(int f, double length, double mass, double gas,
                   const double energy[2], const double state[2],
                   double slope[2])
{
    double power = -2.0 / f, x = state[0], y = length - state[0];
    double left = energy[0] / pow(length / 2, power);
    double right = energy[1] / pow(length / 2, power);
    slope[0] = state[1];
    slope[1] = right * power * pow(y, power - 1);
    slope[1] -= left * power * pow(x, power - 1);
    slope[1] /= mass + gas / 3;
}
