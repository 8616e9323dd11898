/* How the function of exercise 09c is called: see tests/remote.awk. */
/* output: none */

double eccentric_anomaly(double e, double mean);
