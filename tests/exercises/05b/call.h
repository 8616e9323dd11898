/* How the function of exercise 05b is called: see tests/remote.awk. */
/* output: falling_pair_time height 1 */

struct thrown {
    double x, y, vx, vy, radius;
};

double falling_pair_time(double g, const struct thrown *a,
                         const struct thrown *b, double *height);
