/* How the function of exercise 01f is called: see tests/remote.awk. */
/* output: none */

double energy_at_stake(double u1, double u2, double im1, double im2);
