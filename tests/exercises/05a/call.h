/* How the function of exercise 05a is called: see tests/remote.awk. */
/* output: none */

double round_wall_time(double box, double radius, const double r[2],
                       const double v[2]);
