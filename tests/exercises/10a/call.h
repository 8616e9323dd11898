/* How the function of exercise 10a is called: see tests/remote.awk. */
/* output: dashpot on_a 3 */
/* output: dashpot on_b 3 */

struct body {
    double x[3];
    double v[3];
};

double dashpot(double c, const struct body *a, const struct body *b,
               double on_a[3], double on_b[3]);
