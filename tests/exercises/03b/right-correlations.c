/* A right answer: the correlations, summed with weights that fall to zero
   at two hundredths of the series. */

double mean_and_error(size_t n, const double x[], double *error)
{
    double mean = 0, sum = 0;
    size_t i, t, most = n / 50;
    for (i = 0; i < n; i++)
        mean += x[i] / n;
    for (t = 0; t < most; t++) {
        double c = 0;
        for (i = t; i < n; i++)
            c += (x[i] - mean) * (x[i - t] - mean);
        sum += (t == 0 ? 1 : 2) * (1 - (double)t / most) * c / n;
    }
    *error = sqrt(sum / n / (1 - (double)most / n));
    return mean;
}
