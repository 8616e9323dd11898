/* How the function of exercise 08c is called: see tests/remote.awk. With
   the runs comes the place behind them: the suite has put something there.
 */
/* output: measure_order order 1 */

enum verdict { TOO_FEW, NOT_YET, MEASURED };

enum verdict measure_order(size_t n, const double h[n + 1],
                           const double error[n + 1], double rounding,
                           double *order);
