/* How the function of exercise 02a is called: see tests/remote.awk. */
/* output: next_meeting left 1 */

double next_meeting(size_t n, double length, const double x[n],
                    const double v[n], size_t *left);
