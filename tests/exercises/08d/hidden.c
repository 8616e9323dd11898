/* The hidden tests of exercise 08d, "Find a stability limit". */

#include "examiner/check.h"

enum kind { RUNGE_KUTTA, LEAPFROG, THETA };

struct method {
    const char *text;
    enum kind kind;
    int order;
    double part, friction, omega, unit, lean;
};

/* In the suite: the student's limit, and a method with the right one. */
double limit_of(const struct method *m, double most);
double draw_method(struct method *m);

static void check(double got, double expected, const char *input)
{
    CHECK_NEAR(got, .quantity = "the largest stable step", .unit = "s",
               .input = input, .expected = expected,
               .tolerance = isinf(expected) ? 0.0 : 1e-9,
               .because = "10 times the width that was asked for");
}

/* Implicit by the part q: |lambda|^2 = (1 + (1-q)^2 z^2)/(1 + q^2 z^2) is
   above 1 at every step for q < 1/2, and at none for a larger q. */
CHECK_TIMES(20, test_implicit, i)
{
    const struct method m = {.text = "partly implicit",
                             .kind = THETA,
                             .part = i % 2 ? check_draw(0.0, 0.45)
                                           : check_draw(0.55, 1.0),
                             .omega = check_draw(0.3, 3.0),
                             .unit = check_draw(0.2, 5.0),
                             .lean = check_draw(-2.0, 2.0)};
    const double most = check_draw(0.5, 15.0);
    check(limit_of(&m, most), m.part < 0.5 ? 0.0 : INFINITY,
          check_text(
              "implicit by the part %g, omega = %g/s, steps up to %g s",
              m.part, m.omega, most));
}

/* A drawn method, and the same for an oscillator that is quicker or slower.
   The limit goes as the period. */
CHECK_TIMES(10, test_period, i)
{
    struct method m;
    const double limit = draw_method(&m);
    const double slower = check_draw(0.3, 4.0);
    const char *input =
        check_text("%s, omega = %g/s", m.text, m.omega / slower);
    m.omega /= slower;
    m.friction /= slower;
    check(limit_of(&m, 1.08 * slower * limit), slower * limit, input);
}

/* How far one looks does not matter as soon as the limit is seen. */
CHECK_TIMES(10, test_most, i)
{
    struct method m;
    const double limit = draw_method(&m);
    const double far = limit * check_draw(1.3, 6.0);
    const char *input = check_text(
        "%s, omega = %g/s, part %g, steps up to %g s and to %g s", m.text,
        m.omega, m.part, 1.1 * limit, far);
    check(limit_of(&m, far), limit_of(&m, 1.1 * limit), input);
}

const struct check_test check_hidden[] = {
    {"methods that are partly implicit", test_implicit, 2, 0},
    {"quick and slow oscillators", test_period, 1, 0},
    {"how far one looks", test_most, 1, 0},
    {0}};
