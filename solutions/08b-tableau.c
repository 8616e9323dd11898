/* Exercise 08b, worked: one more row in the tableau.

   The table first. The sentence about each stage is its row: a third of the
   first slope; minus a third of the first and all of the second; the first,
   minus the second, plus the third. The rows have the sums 0, 1/3, 2/3 and
   1: the times of the stages, which therefore need not be stored. In C 1/3
   is 0, a whole number, and the compiler does not say a word; 1.0/3.0 is
   meant.

   Then the step. All stages start from the OLD y, so y must not be touched
   before the last slope is known, and each stage needs all slopes before
   it: they are kept. A stage i adds up row i only as far as the diagonal,
   for an explicit method knows nothing further.

   Is it of order 4? For a linear law of one number, y' = lambda y, any four
   stages of order 4 give the same step, 1 + z + z^2/2 + z^3/6 + z^4/24 with
   z = h lambda. The table shows in other laws only. For y' = f(t) it is
   Newton's rule of three eighths, exact for polynomials of third degree as
   Simpson's rule is, with a remainder 4/9 as large. Nobody has found a law
   of nature for which that is worth a slope at two thirds; the classical
   method won because its zeros were easier to compute by hand.

   Another way: hold the sums instead of the slopes. As soon as k_j is
   known, its share is added to every later stage, and to the end. */

#include "exercise.h"
#include <stddef.h>

enum { MOST_STAGES = 8, MOST = 12 };

void slope(double t, const double y[], double dy[]);

void three_eighths(double a[], double b[])
{
    const double third = 1.0 / 3.0;
    const double row[4][4] = {{0.0, 0.0, 0.0, 0.0},
                              {third, 0.0, 0.0, 0.0},
                              {-third, 1.0, 0.0, 0.0},
                              {1.0, -1.0, 1.0, 0.0}};
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j)
            a[4 * i + j] = row[i][j];
        b[i] = i == 0 || i == 3 ? 0.125 : 0.375;
    }
}

/* One number: y and h times the sum of the first `count` slopes with their
   weights. */
static double led_by(size_t count, const double weight[],
                     double slopes[][MOST], size_t k, double h, double y)
{
    double sum = 0.0;
    while (count-- > 0)
        sum += weight[count] * slopes[count][k];
    return y + h * sum;
}

void tableau_step(size_t stages, const double a[], const double b[],
                  size_t n, double t, double h, double y[])
{
    double slopes[MOST_STAGES][MOST], there[MOST];
    size_t known = 0;
    for (const double *row = a; known < stages; row += stages) {
        double node = 0.0;
        for (size_t j = known; j > 0; --j)
            node += row[j - 1];
        for (size_t k = n; k-- > 0;)
            there[k] = led_by(known, row, slopes, k, h, y[k]);
        slope(t + node * h, there, slopes[known++]);
    }
    for (size_t k = n; k-- > 0;)
        y[k] = led_by(stages, b, slopes, k, h, y[k]);
}
