/* How the function of exercise 04b is called: see tests/remote.awk. A sort
 * is four numbers. */
/* output: rain_force friction 1 */

struct sort {
    double m, v, left, right;
};

double rain_force(size_t n, const struct sort rain[n], double im, double V,
                  double *friction);
