/* How the function of exercise 06b is called: see tests/remote.awk. */
/* output: mean_square x n */
/* output: mean_square y n */
/* output: mean_square accepted 1 */

extern double uniform(void);

/* The numbers that uniform() will give next, which are not used up by that:
   many cross at once. */
extern void uniform_ahead(double u[], size_t count);

double mean_square(size_t n, double radius, double dish, double step,
                   size_t tries, double x[n], double y[n],
                   size_t *accepted);
