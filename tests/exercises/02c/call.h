/* How the function of exercise 02c is called: see tests/remote.awk. */
/* output: positions_at x n */
/* output: positions_at v n */

void positions_at(size_t n, double length, const double x0[n],
                  const double v0[n], double t, double x[n], double v[n]);
