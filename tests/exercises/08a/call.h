/* How the function of exercise 08a is called: see tests/remote.awk. With
   the coordinates and the velocities comes the place behind them: the suite
   has put something there. */
/* output: drift_kick_drift x n suite */
/* output: drift_kick_drift v n suite */

#define PRESENT(n)

extern void acceleration(const double x[PRESENT(n)], double a[PRESENT(n)]);

void drift_kick_drift(size_t n, double x[n + 1], double v[n + 1], double dt,
                      size_t steps);
