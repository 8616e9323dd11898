/* How the function of exercise 09d is called: see tests/remote.awk. */
/* output: ellipses_and_kicks x n */
/* output: ellipses_and_kicks v n */

extern void drift(double sun, double dt, double x[3], double v[3]);

void ellipses_and_kicks(size_t n, const double gm[n], double sun, double dt,
                        double x[n][3], double v[n][3]);
