/* How the functions of exercise 08b are called: see tests/remote.awk. With
   the numbers comes the place behind them: the suite has put something
   there. */
/* output: three_eighths a 16 */
/* output: three_eighths b 4 */
/* output: tableau_step y n suite */

#define PRESENT(n)

extern void slope(double t, const double y[PRESENT(n)],
                  double dy[PRESENT(n)]);

void three_eighths(double a[16], double b[4]);

void tableau_step(size_t stages, const double a[stages * stages],
                  const double b[stages], size_t n, double t, double h,
                  double y[n + 1]);
