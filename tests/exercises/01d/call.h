/* How the function of exercise 01d is called: see tests/remote.awk. */
/* output: none */

double impact_parameter(double r1, double r2, double im1, double im2,
                        double deflection);
