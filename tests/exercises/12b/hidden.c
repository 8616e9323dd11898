/* The hidden tests of exercise 12b, "Other units". */

#include "examiner/check.h"

struct world {
    double g, k, q;
};

typedef void stepper(struct world w, double h, double *x, double *v);

double apart(stepper *step, struct world w, double h, int n, double x,
             double v, double *end);

/* From the middle of a hill, where x runs away as exp(t): a wrong last
   digit has grown by the factor exp(T). */
static void on_a_hill(struct world w, double h, double *x, double *v)
{
    const double k = w.k + *x * *x * w.q;
    *v += (w.g - k * *x) * h;
    *x += *v * h;
}

static double end_of(stepper *step, struct world w, int n, double *far)
{
    double end = NAN;
    *far = apart(step, w, 0.1, n, 0.3, -0.29, &end);
    return end;
}

/* Rounding grows by exp(15 - 5) from 50 to 150 steps: 22000 times. The
   last digits are chance, and so is a factor of some tens. */
static void test_hill(void)
{
    double first = 0.0, last = 0.0;
    for (int i = 0; i < 10; ++i) {
        const struct world w = {check_draw(-0.1, 0.1),
                                check_draw(-1.1, -0.9), 0.0};
        double far;
        end_of(on_a_hill, w, 50, &far);
        first += far / 10;
        end_of(on_a_hill, w, 150, &far);
        last += far / 10;
    }
    CHECK_NEAR(
        log(last / first),
        .quantity = "logarithm of how much the distance grows",
        .input =
            "a hill with k near -1 /s^2, from 50 to 150 steps of 0.1 s",
        .expected = 10.0, .tolerance = 3.0,
        .because = "chance is a factor of 20 at most");
}

CHECK_TIMES(20, test_negative, i)
{
    const struct world w = {check_draw(-2.0, 2.0), check_draw(0.0, 2.0),
                            0.0};
    double far, end = end_of(on_a_hill, w, 100, &far);
    CHECK_NEAR(far, .quantity = "how far the two runs are apart",
               .unit = "m", .input = "a spring and a weight, drawn",
               .tolerance = 1e-11 * (1.0 + fabs(end)),
               .because = "far more than rounding can do");
}

const struct check_test check_hidden[] = {
    {"on a hill rounding grows", test_hill, 1, 0},
    {"springs with a weight come out the same", test_negative, 1, 0},
    {0}};
