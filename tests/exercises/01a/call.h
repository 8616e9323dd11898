/* How the function of exercise 01a is called: see tests/remote.awk. */
/* output: velocities_after v 2 */

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2]);
