/* A right answer: the error of an addition by six, whichever is larger. */

double sum_up(size_t n, const double part[])
{
    double s = 0, lost = 0;
    size_t i;
    for (i = 0; i < n; i++) {
        double b = part[i], t = s + b, of_b = t - s, of_s = t - of_b;
        lost += (s - of_s) + (b - of_b);
        s = t;
    }
    if (s - s != 0)
        return s;
    return s + lost;
}
