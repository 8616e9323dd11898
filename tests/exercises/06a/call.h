/* How the function of exercise 06a is called: see tests/remote.awk. */
/* output: throw_disks x n */
/* output: throw_disks y n */

extern double uniform(void);

/* The numbers that uniform() will give next, which are not used up by that:
   many cross at once. */
extern void uniform_ahead(double u[], size_t count);

size_t throw_disks(size_t n, const double radius[n], double width,
                   double height, double x[n], double y[n]);
