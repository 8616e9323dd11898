/* How the function of exercise 07a is called: see tests/remote.awk. */
/* output: speed_below fourth 1 */

double speed_below(int n, double mean_square, double v, double *fourth);
