/* How the function of exercise 01c is called: see tests/remote.awk. */
/* output: none */

double top_velocity(size_t n, const double masses[n], double speed,
                    double restitution);
