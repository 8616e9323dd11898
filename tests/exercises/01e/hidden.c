/* The hidden tests of exercise 01e, "CHECKcollide". */

#include "examiner/check.h"

typedef void law(double m1, double m2, double *v1, double *v2);

bool passes(law *collide);

/* The impulse of the blow, which is all that a collision is. */
static void by_impulse(double m1, double m2, double *v1, double *v2)
{
    const double p = 2.0 * m1 * m2 / (m1 + m2) * (*v1 - *v2);
    *v1 -= p / m1;
    *v2 += p / m2;
}

static void heavy_first(double m1, double m2, double *v1, double *v2)
{
    by_impulse(fmax(m1, m2), fmin(m1, m2), v1, v2);
}

static void mirrored(double m1, double m2, double *v1, double *v2)
{
    by_impulse(m1, m2, v1, v2);
    *v1 = fabs(*v1);
}

static void exchanged(double m1, double m2, double *v1, double *v2)
{
    const double u = *v1;
    by_impulse(m1, m2, v1, v2);
    *v1 = fabs(m1 - m2) > 0.0 ? *v1 : u;
}

struct judged {
    law *collide;
    bool right;
    const char *how;
};

static law *tried;
static int calls;

static void counted(double m1, double m2, double *v1, double *v2)
{
    ++calls;
    tried(m1, m2, v1, v2);
}

/* Asks about all, in an order that is drawn; then tells. */
static void check_all(const struct judged all[], int count)
{
    int order[4], called[4];
    double said[4];
    check_shuffle(order, count);
    for (int k = 0; k < count; ++k) {
        tried = all[order[k]].collide;
        calls = 0;
        said[order[k]] = passes(counted) ? 1.0 : 0.0;
        called[order[k]] = calls;
    }
    for (int i = 0; i < count; ++i) {
        CHECK_NEAR(called[i] > 0,
                   .quantity =
                       "1 if the function that you judge was called at all",
                   .input = all[i].how, .expected = 1.0,
                   .because = "yes or no");
        CHECK_NEAR(
            said[i],
            .quantity = "what you say of a function (1 true, 0 false)",
            .input = all[i].how, .expected = all[i].right ? 1.0 : 0.0,
            .because = "yes or no");
    }
}

static void test_impulse(void)
{
    static const struct judged all[] = {
        {by_impulse, true, "a right one, by the impulse"},
        {heavy_first, false,
         "one that takes the heavier body for the first"}};
    check_all(all, 2);
}

static void test_others(void)
{
    static const struct judged all[] = {
        {by_impulse, true, "a right one, by the impulse"},
        {mirrored, false,
         "one whose first body always leaves to the right"},
        {exchanged, false,
         "one that gives the first of two twins its own velocity"}};
    check_all(all, 3);
}

const struct check_test check_hidden[] = {
    {"one that sorts the masses is refused", test_impulse, 1, 0},
    {"a lost sign and a special case are refused", test_others, 1, 0},
    {0}};
