/* How the function of exercise 03b is called: see tests/remote.awk. */
/* output: mean_and_error error 1 */

double mean_and_error(size_t n, const double x[n], double *error);
