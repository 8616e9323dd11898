/* The series where it is short, and the cosine where it is not. */

bool leave_out(double push, double stretch, double time, double *budget,
               double *bound)
{
    double x = stretch * time, sum = 0.5, term = 0.5;
    if (x < 1.5)
        for (int k = 3; k < 25; k += 2) {
            term *= x / k * x / (k + 1);
            sum += term;
        }
    else
        sum = (cosh(x) - 1.0) / x / x;
    if (push == 0.0)
        sum = 1.0;
    *bound = sum * (time * push) * time;
    if (*bound > *budget)
        return false;
    *budget = *budget - *bound;
    return true;
}
