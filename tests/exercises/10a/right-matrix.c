/* A right answer: the matrix that keeps the part along the axis. */

double dashpot(double c, const struct body *a, const struct body *b,
               double on_a[3], double on_b[3])
{
    double p[3][3], d[3], u[3], r2, power = 0;
    int i, j;
    for (i = 0; i < 3; i++) {
        on_a[i] = on_b[i] = 0;
        u[i] = a->v[i];
        u[i] -= b->v[i];
        d[i] = a->x[i];
        d[i] -= b->x[i];
    }
    r2 = pow(d[0], 2) + pow(d[1], 2) + pow(d[2], 2);
    if (!(r2 > 0))
        return 0;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++)
            p[i][j] = d[i] * d[j] / r2;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++) {
            on_a[i] -= c * p[i][j] * u[j];
            on_b[i] += c * p[i][j] * u[j];
            power += c * u[i] * p[i][j] * u[j];
        }
    return fabs(power);
}
