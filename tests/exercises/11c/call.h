/* How the function of exercise 11c is called: see tests/remote.awk. A
 * sphere is eight numbers. */
/* output: go_back a 1 */
/* output: go_back b 1 */

struct sphere {
    double im, r, x[3], v[3];
};

double go_back(struct sphere *a, struct sphere *b, double dt);
