/* A right answer in plain C, with which wrong.diff begins. */

void piston_slopes(int f, double length, double mass, double gas,
                   const double energy[2], const double state[2],
                   double slope[2])
{
    double h = length / 2, l = state[0], r = length - l;
    double m = mass + gas / 3, q = 2.0 / f, kl, kr;
    kl = energy[0] * pow(h / l, q);
    kr = energy[1] * pow(h / r, q);
    slope[0] = state[1];
    slope[1] = q * (kl / l - kr / r) / m;
}
