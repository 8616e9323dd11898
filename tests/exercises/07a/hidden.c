/* The hidden tests of exercise 07a, "How fast is a disk?". */

#include "examiner/check.h"
#include "call.h"

static double below(int n, double mean, double v)
{
    double fourth = NAN;
    return speed_below(n, mean, v, &fourth);
}

static double fourth(int n, double mean, double v)
{
    double answer = NAN;
    (void)speed_below(n, mean, v, &answer);
    return answer;
}

static void check(double got, double expected, double tolerance,
                  const char *quantity, int n, double mean, double v)
{
    CHECK_NEAR(
        got, .quantity = quantity,
        .input = check_text(
            "n = %d disks, mean square %g m^2/s^2, v = %g m/s", n, mean, v),
        .expected = expected, .tolerance = tolerance,
        .because = "1e-12 of what is summed up");
}

/* For n disks the probability of a speed above v is a polynomial of the
   degree n - 1 in v^2. The integral of it is the mean of v^2, and that of 2
   v^2 times it the mean of v^4. Gauss with five points is exact up to the
   degree 9. The points and weights are those of the interval from -1 to 1,
   worked out from their roots. */
CHECK_TIMES(20, test_means, i)
{
    const double root = 2.0 * sqrt(10.0 / 7.0);
    const double x[] = {0.0, sqrt(5.0 - root) / 3.0,
                        sqrt(5.0 + root) / 3.0};
    const double w[] = {128.0 / 225.0, (322.0 + 13.0 * sqrt(70.0)) / 900.0,
                        (322.0 - 13.0 * sqrt(70.0)) / 900.0};
    const int n = check_draw_whole(2, 9);
    const double mean = check_draw(0.1, 9.0), half = 0.5 * n * mean;
    double second = 0.0, last = 0.0;
    for (int k = 0; k < 6; ++k) {
        const double s = half * (1.0 + (k % 2 ? x[k / 2] : -x[k / 2]));
        const double part = (k < 2 ? 0.5 : 1.0) * w[k / 2] * half *
                            (1.0 - below(n, mean, sqrt(s)));
        second += part;
        last += 2.0 * s * part;
    }
    const double v = check_draw(-3.0, 9.0);
    check(second, mean, 1e-12 * half,
          "mean of v^2, from your probabilities", n, mean, v);
    check(fourth(n, mean, v), last, 1e-12 * half * half,
          "*fourth, from your probabilities", n, mean, v);
}

/* In units in which speeds are large or small: two disks, of which every
   share is as likely as any other. */
CHECK_TIMES(30, test_units, i)
{
    const double unit = ldexp(1.0, check_draw_whole(-100, 100));
    const double mean = check_draw(0.5, 2.0), part = check_draw(0, 1);
    const double v = part * sqrt(2.0 * mean) * unit;
    const double squared = mean * unit * unit;
    check(below(2, squared, v), part * part, 1e-12 * part * part,
          "probability of a speed below v", 2, squared, v);
    check(fourth(2, squared, v) / squared, 4.0 / 3.0 * squared,
          1e-12 * squared, "*fourth over the mean square", 2, squared, v);
}

/* Faster than with all the energy, or slower than at rest; and one disk. */
CHECK_TIMES(30, test_out_of_reach, i)
{
    const int n = i % 3 ? check_draw_whole(2, 1000000) : 1;
    const double mean = check_draw(0.1, 9.0);
    const double fast = sqrt(n * mean) * check_draw(1.001, 9.0);
    const double slow = sqrt(mean) * check_draw(0.1, 0.999);
    check(below(n, mean, fast), 1.0, 0.0, "probability of a speed below v",
          n, mean, fast);
    check(below(n, mean, 1e200), 1.0, 0.0, "probability of a speed below v",
          n, mean, 1e200);
    check(below(n, mean, -fast), 0.0, 0.0, "probability of a speed below v",
          n, mean, -fast);
    if (n == 1)
        check(below(n, mean, slow), 0.0, 0.0,
              "probability of a speed below v", n, mean, slow);
}

const struct check_test check_hidden[] = {
    {"all means belong to one law", test_means, 2, 0},
    {"slow and fast units", test_units, 1, 0},
    {"speeds out of reach, and one disk", test_out_of_reach, 1, 0},
    {0}};
