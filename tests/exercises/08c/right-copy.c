/* The runs of use are copied out first; then one looks at the last ones. */

#include <stdlib.h>

struct run {
    double log_h, log_error;
};

static double order_of(const struct run *coarse)
{
    const struct run *fine = coarse + 1;
    return (fine->log_error - coarse->log_error) /
           (fine->log_h - coarse->log_h);
}

enum verdict measure_order(size_t n, const double h[], const double error[],
                           double rounding, double *order)
{
    struct run *run = malloc((n + 1) * sizeof *run);
    int count = 0;
    enum verdict verdict = TOO_FEW;
    if (!run)
        abort();
    for (size_t i = 0; i < n; ++i) {
        const int finite = error[i] - error[i] == 0.0;
        if (finite &&
            (error[i] > rounding * 1e3 || -error[i] > rounding * 1e3))
            run[count++] = (struct run){log(h[i]), log(fabs(error[i]))};
    }
    *order = count < 2 ? NAN : order_of(run + count - 2);
    if (count >= 2)
        verdict = *order >= 0.5 ? MEASURED : NOT_YET;
    if (count >= 3 && fabs(*order - order_of(run + count - 3)) > 0.2)
        verdict = NOT_YET;
    free(run);
    return verdict;
}
