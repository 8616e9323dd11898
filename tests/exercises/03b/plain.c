/* A right answer in plain C, with which wrong.diff begins. */

double mean_and_error(size_t n, const double x[], double *error)
{
    size_t b, i, m = 32, length = n / m;
    double mean = 0, used = 0, s = 0;
    for (i = 0; i < n; i++)
        mean += x[i] / n;
    for (i = 0; i < m * length; i++)
        used += x[i] / (m * length);
    for (b = 0; b < m; b++) {
        double a = 0;
        for (i = b * length; i < (b + 1) * length; i++)
            a += x[i] / length;
        s += (a - used) * (a - used) / (m - 1);
    }
    *error = sqrt(s / m);
    return mean;
}
