/* How the function of exercise 09e is called: see tests/remote.awk. */
/* output: none */

double sum_up(size_t n, const double part[n]);
