/* A right answer in plain C, with which wrong.diff begins. */

enum verdict measure_order(size_t n, const double h[], const double error[],
                           double rounding, double *order)
{
    size_t i, u[1000], c = 0;
    double p, q;
    for (i = 0; i < n; i++)
        if (isfinite(error[i]) && fabs(error[i]) > 1000 * rounding)
            u[c++] = i;
    *order = NAN;
    if (c < 2)
        return TOO_FEW;
    p = log(fabs(error[u[c - 2]] / error[u[c - 1]])) /
        log(h[u[c - 2]] / h[u[c - 1]]);
    *order = p;
    if (p < 0.5)
        return NOT_YET;
    if (c < 3)
        return MEASURED;
    q = log(fabs(error[u[c - 3]] / error[u[c - 2]])) /
        log(h[u[c - 3]] / h[u[c - 2]]);
    return fabs(p - q) > 0.2 ? NOT_YET : MEASURED;
}
