/* How the function of exercise 09a is called: see tests/remote.awk. With
 * the potentials comes the place behind them: the suite has put something
 * there. */
/* output: potential_energy potential n */

double potential_energy(size_t n, const double mass[n],
                        const double x[3 * n], double k2, double softening,
                        double potential[n + 1]);
