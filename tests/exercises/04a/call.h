/* How the function of exercise 04a is called: see tests/remote.awk. */
/* output: piston_slopes slope 2 */

void piston_slopes(int f, double length, double mass, double gas,
                   const double energy[2], const double state[2],
                   double slope[2]);
