/* How the function of exercise 11a is called: see tests/remote.awk. */
/* output: part_spheres a 1 */
/* output: part_spheres b 1 */

struct sphere {
    double mass;
    double radius;
    double x[3];
};

double part_spheres(struct sphere *a, struct sphere *b);
