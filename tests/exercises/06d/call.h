/* How the function of exercise 06d is called: see tests/remote.awk. */
/* output: push_chain x n */

size_t push_chain(size_t n, double sigma, double width, double height,
                  double x[n], const double y[n], size_t first,
                  double length);
