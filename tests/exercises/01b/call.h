/* How the function of exercise 01b is called: see tests/remote.awk. */
/* output: measure_collision mass_ratio 1 */
/* output: measure_collision restitution 1 */

bool measure_collision(double u1, double u2, double v1, double v2,
                       double *mass_ratio, double *restitution);
