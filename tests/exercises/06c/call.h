/* How the function of exercise 06c is called: see tests/remote.awk. */
/* output: depletion overlap 1 */

double depletion(int dimensions, double R1, double R2, double small,
                 double density, double r, double *overlap);
