/* A right answer in plain C, with which wrong.diff begins. */

void three_eighths(double a[], double b[])
{
    double table[16] = {0,       0, 0, 0, 1. / 3, 0,  0, 0,
                        -1. / 3, 1, 0, 0, 1,      -1, 1, 0};
    int i;
    for (i = 0; i < 16; i++)
        a[i] = table[i];
    b[0] = b[3] = 0.125;
    b[1] = b[2] = 0.375;
}

void tableau_step(size_t stages, const double a[], const double b[],
                  size_t n, double t, double h, double y[])
{
    double k[8][12], z[12];
    size_t i, j, m;
    for (i = 0; i < stages; i++) {
        double c = 0;
        for (j = 0; j < i; j++)
            c += a[stages * i + j];
        for (m = 0; m < n; m++) {
            z[m] = y[m];
            for (j = 0; j < i; j++)
                z[m] += h * a[stages * i + j] * k[j][m];
        }
        slope(t + c * h, z, k[i]);
    }
    for (i = 0; i < stages; i++)
        for (m = 0; m < n; m++)
            y[m] += h * b[i] * k[i][m];
}
