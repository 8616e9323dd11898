/* How the function of exercise 03c is called: see tests/remote.awk. */
/* output: none */

double velocity_below(int n, double u);
