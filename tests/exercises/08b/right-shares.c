/* Each slope is handed out to the later stages and to the end as soon as it
   is known; the last row of sums is the end. */

#include <string.h>

void three_eighths(double a[], double b[])
{
    memset(a, 0, 16 * sizeof *a);
    a[4] = 1. / 3;
    a[8] = -a[4];
    a[9] = a[12] = a[14] = 1;
    a[13] = -1;
    b[0] = b[3] = 1. / 8;
    b[1] = b[2] = 3. / 8;
}

void tableau_step(size_t stages, const double a[], const double b[],
                  size_t n, double t, double h, double y[])
{
    double sum[9][12] = {{0}}, c[9] = {0}, place[12], k[12];
    int s = (int)stages, i, j, m, count = (int)n;
    for (i = 0; i < s; i++)
        for (j = 0; j < i; j++)
            c[i] += a[s * i + j];
    for (j = 0; j < s; j++) {
        for (m = 0; m < count; m++)
            place[m] = sum[j][m] * h + y[m];
        slope(t + c[j] * h, place, k);
        for (m = 0; m < count; m++) {
            for (i = j + 1; i < s; i++)
                sum[i][m] += k[m] * a[s * i + j];
            sum[s][m] += k[m] * b[j];
        }
    }
    for (m = 0; m < count; m++)
        y[m] += sum[s][m] * h;
}
