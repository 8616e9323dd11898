/* The hidden tests of 09a, "The potential of the softened force". */

#include "examiner/check.h"

enum { MOST = 64 };

struct bodies {
    const char *text;
    size_t n;
    double k2, softening;
    double mass[MOST], x[3 * MOST];
};

/* In the suite: what the student's function says, and drawn bodies. */
double answer_of(const struct bodies *b, size_t i);
struct bodies draw_bodies(size_t n);

static void check(double got, double expected, double tolerance,
                  const char *quantity, const struct bodies *b)
{
    CHECK_NEAR(got, .quantity = quantity,
               .input =
                   check_text("%s; k2 = %g m^3/(kg s^2), softening %g m",
                              b->text, b->k2, b->softening),
               .expected = expected, .tolerance = tolerance,
               .because = "some epsilons of all pairs");
}

/* The bodies in another order, and the axes too. */
CHECK_TIMES(10, test_order, i)
{
    const size_t n = (size_t)check_draw_whole(2, MOST);
    const size_t turn = (size_t)check_draw_whole(1, (int)n - 1);
    const struct bodies b = draw_bodies(n);
    struct bodies other = b;
    for (size_t j = 0; j < n; ++j) {
        const size_t to = (j + turn) % n;
        other.mass[to] = b.mass[j];
        for (size_t k = 0; k < 3; ++k)
            other.x[(k + 1) % 3 * n + to] = b.x[k * n + j];
    }
    const double energy = answer_of(&b, n), one = answer_of(&b, 0);
    check(answer_of(&other, n), energy, 1e-13 * fabs(energy),
          "the energy, with the bodies in another order", &b);
    check(answer_of(&other, turn), one, 1e-13 * fabs(one),
          "the potential of the same body", &b);
}

/* The energy of all is half the sum of mass times potential; and without
   the last body it is less by what that one brought. */
CHECK_TIMES(10, test_brought, i)
{
    const size_t n = (size_t)check_draw_whole(2, 20);
    const struct bodies b = draw_bodies(n);
    struct bodies fewer = b;
    double sum = 0.0;
    fewer.n = n - 1;
    for (size_t k = 0; k < 3; ++k)
        for (size_t j = 0; j + 1 < n; ++j)
            fewer.x[k * (n - 1) + j] = b.x[k * n + j];
    for (size_t j = 0; j < n; ++j)
        sum += b.mass[j] * answer_of(&b, j);
    const double energy = answer_of(&b, n);
    check(0.5 * sum, energy, 1e-13 * fabs(energy),
          "half the sum of mass times potential", &b);
    check(answer_of(&fewer, n - 1) + b.mass[n - 1] * answer_of(&b, n - 1),
          energy, 1e-13 * fabs(energy),
          "the energy without the last body, and the work to bring it", &b);
}

/* Lengths and masses in other units. */
CHECK_TIMES(10, test_units, i)
{
    const size_t n = (size_t)check_draw_whole(2, 20);
    const struct bodies b = draw_bodies(n);
    const double m = ldexp(1.0, check_draw_whole(-60, 60));
    const double kg = ldexp(1.0, check_draw_whole(-60, 60));
    struct bodies other = b;
    for (size_t j = 0; j < n; ++j)
        other.mass[j] *= kg;
    for (size_t j = 0; j < 3 * n; ++j)
        other.x[j] *= m;
    other.softening *= m;
    const double energy = answer_of(&b, n), one = answer_of(&b, 0);
    check(answer_of(&other, n) / (kg / m) / kg, energy,
          1e-14 * fabs(energy), "the energy, in other units", &b);
    check(answer_of(&other, 0) / (kg / m), one, 1e-14 * fabs(one),
          "potential[0], in other units", &b);
}

const struct check_test check_hidden[] = {
    {"bodies in another order", test_order, 2, 0},
    {"bodies are brought in", test_brought, 1, 0},
    {"metres or light years", test_units, 1, 0},
    {0}};
