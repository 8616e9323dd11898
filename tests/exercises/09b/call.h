/* How the functions of exercise 09b are called: see tests/remote.awk. */
/* output: binary_speeds v1 1 */
/* output: binary_speeds v2 1 */

void binary_speeds(double k2, double m1, double m2, double d, double *v1,
                   double *v2);

double choreography_speed(double k2, size_t n, double mass, double radius);
