/* A right answer: each ghost counts those to its left. */

/* From -length to length; negative on the way back. */
static double mirrored(double way, double length)
{
    return way - 2 * length * floor(way / (2 * length) + 0.5);
}

void positions_at(size_t n, double length, const double x0[],
                  const double v0[], double t, double x[], double v[])
{
    size_t i, j;
    for (i = 0; i < n; i++) {
        double own = mirrored(x0[i] + v0[i] * t, length);
        size_t place = 0;
        for (j = 0; j < n; j++)
            if (fabs(mirrored(x0[j] + v0[j] * t, length)) < fabs(own))
                place++;
        x[place] = fabs(own);
        v[place] = own < 0 ? -v0[i] : v0[i];
    }
}
