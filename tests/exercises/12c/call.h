/* How the function of exercise 12c is called: see tests/remote.awk. */
/* output: leave_out budget 1 */
/* output: leave_out bound 1 */

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound);
