/* From the largest step on; the last two slopes are kept. */

enum verdict measure_order(size_t n, const double h[], const double error[],
                           double rounding, double *order)
{
    double x = 0, y = 0, now = NAN, before = NAN;
    int runs = 0;
    size_t i;
    for (i = 0; i < n; i++) {
        double e = error[i] < 0 ? -error[i] : error[i];
        if (!(e > 1000 * rounding) || e > 1.7e308)
            continue;
        if (runs++ > 0) {
            before = now;
            now = (log10(e) - y) / (log10(h[i]) - x);
        }
        x = log10(h[i]);
        y = log10(e);
    }
    *order = now;
    if (runs < 2)
        return TOO_FEW;
    if (now < 0.5 || before > now + 0.2 || before < now - 0.2)
        return NOT_YET;
    return MEASURED;
}
