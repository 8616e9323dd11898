/* The collision map against exact values and against its algebra. */
#include "unit.h"

#include "line/collide.h"
#include "toolbox/quad.h"
#include "toolbox/random.h"

#include <float.h>

/* Exact collisions: velocities, inverse masses, and the velocities after,
   worked out as fractions by hand. */
static const struct {
    double u1, u2, im1, im2, v1, v2;
} golden[] = {
    {1, 0, 1, 1, 0, 1},
    {1, 0, 1.0 / 9, 1, 0.8, 1.8},
    {1, 0, 1, 0, -1, 0},
    {1, 0, 1, 0.25, -0.6, 0.4},
    {2, -1, 1.0 / 3, 0.5, -0.4, 2.6},
    {0, -1, 1, 0, -2, -1},
    {0, 1, 0, 1, 0, -1},
};
enum { GOLDEN = sizeof golden / sizeof golden[0] };

/* Three roundings of numbers up to 2(|u1|+|u2|) <= 6: 3 * 6 * eps/2. */
static const double golden_tolerance = 9 * DBL_EPSILON;

TEST(test_golden_values, "exact fractions in every form")
{
    for (int form = 0; form < COLLIDE_FORMS; ++form)
        for (int i = 0; i < GOLDEN; ++i) {
            double v1 = golden[i].u1, v2 = golden[i].u2;
            UNIT_TRUE(collide_by(form, &v1, &v2, golden[i].im1,
                                 golden[i].im2, 1));
            UNIT_NEAR(v1, golden[i].v1, golden_tolerance);
            UNIT_NEAR(v2, golden[i].v2, golden_tolerance);
        }
}

TEST(test_walls_are_exact, "a wall keeps its velocity to the last bit")
{
    SEEDED(r, 2);
    for (int i = 0; i < 1000; ++i) {
        const double u = random_normal(&r), wall = random_normal(&r);
        double v1 = u, v2 = 0;
        collide(&v1, &v2, random_uniform(&r) + 0.1, 0, 1);
        UNIT_EQUAL(v1, -u);
        UNIT_EQUAL(v2, 0);
        v1 = wall;
        v2 = u;
        collide(&v1, &v2, 0, random_uniform(&r) + 0.1, 1);
        UNIT_EQUAL(v1, wall);
    }
}

/* With equal masses q = r = d is exact when d is, as for multiples of
   2^-53 in [0,1). */
TEST(test_equal_masses_swap, "equal masses exchange velocities exactly")
{
    SEEDED(r, 3);
    for (int i = 0; i < 1000; ++i) {
        const double u1 = random_uniform(&r), u2 = random_uniform(&r);
        const double im = random_between(&r, 0.1, 10);
        double v1 = u1, v2 = u2;
        collide(&v1, &v2, im, im, 1);
        UNIT_EQUAL(v1, u2);
        UNIT_EQUAL(v2, u1);
    }
}

TEST(test_refusals, "what has no answer is refused and changes nothing")
{
    const double bad[][2] = {
        {0, 0},   {-1, 1},  {1, -1},       {-1, 2},       {2, -1},
        {NAN, 1}, {1, NAN}, {INFINITY, 1}, {1, INFINITY}, {1e308, 1e308}};
    const double zero[3] = {0, 0, 0}, endless[2] = {1, INFINITY};
    const double unknown[2] = {1, NAN};
    const double normal[4] = {1, 1, 1, 1};
    for (int form = 0; form < COLLIDE_FORMS; ++form)
        for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
            double v1 = 3, v2 = -4;
            double w1[3] = {3, 3, 3}, w2[3] = {4, 4, 4};
            UNIT_TRUE(!collide_by(form, &v1, &v2, bad[i][0], bad[i][1], 1));
            UNIT_TRUE(v1 == 3 && v2 == -4);
            UNIT_TRUE(!collide_along_by(form, 3, normal, w1, w2, bad[i][0],
                                        bad[i][1], 1));
            UNIT_TRUE(w1[0] == 3 && w2[2] == 4);
        }
    double w1[4] = {1, 2, 3, 4}, w2[4] = {0};
    UNIT_TRUE(!collide_along(3, zero, w1, w2, 1, 1, 1));
    UNIT_TRUE(!collide_along(2, endless, w1, w2, 1, 1, 1));
    UNIT_TRUE(!collide_along(2, unknown, w1, w2, 1, 1, 1));
    UNIT_TRUE(!collide_along(0, normal, w1, w2, 1, 1, 1));
    UNIT_TRUE(!collide_along(4, normal, w1, w2, 1, 1, 1));
    UNIT_TRUE(w1[0] == 1 && w2[0] == 0);
    double heavy = 1, light = 0;
    UNIT_TRUE(collide(&heavy, &light, 1e307, 1e307, 1));
    UNIT_TRUE(heavy == 0 && light == 1);
}

/* A tiny velocity along a tiny normal, and a large along a large one. */
TEST(test_extreme_units, "units may be extreme")
{
    double v1[2] = {1e-290, 0}, v2[2] = {0, 0};
    double w1[2] = {1e290, 0}, w2[2] = {0, 0};
    UNIT_TRUE(collide_along(2, (double[]){1e-99, 0}, v1, v2, 1, 1, 1));
    UNIT_NEAR(v1[0], 0, 8e-290 * DBL_EPSILON);
    UNIT_NEAR(v2[0], 1e-290, 8e-290 * DBL_EPSILON);
    UNIT_TRUE(collide_along(2, (double[]){1e150, 0}, w1, w2, 1, 0, 1));
    UNIT_NEAR(w1[0], -1e290, 8e290 * DBL_EPSILON);
    UNIT_EQUAL(w2[0], 0);
}

/* Every form agrees with collide_along for any normal: a few roundings of
   velocities below 2, and of projections up to |u| |n| / n.n below 4; the
   complement loses up to 16 times more at mass ratios to 8. */
TEST(test_every_form_along, "every form agrees along any normal")
{
    SEEDED(r, 9);
    for (int form = 0; form < COLLIDE_FORMS; ++form)
        for (size_t d = 1; d <= 3; ++d)
            for (int i = 0; i < 300; ++i) {
                double n[3], u[2][3], v[2][3], worst = 0;
                const double a = random_between(&r, 0.25, 2);
                const double b = random_between(&r, 0.25, 2);
                const double e = random_uniform(&r);
                const double size = random_between(&r, 0.5, 1.5);
                random_direction(&r, d, n);
                for (size_t k = 0; k < d; ++k) {
                    n[k] *= size;
                    u[0][k] = v[0][k] = random_between(&r, -1, 1);
                    u[1][k] = v[1][k] = random_between(&r, -1, 1);
                }
                collide_along(d, n, u[0], u[1], a, b, e);
                collide_along_by(form, d, n, v[0], v[1], a, b, e);
                for (size_t k = 0; k < d; ++k)
                    worst = fmax(worst, fmax(fabs(u[0][k] - v[0][k]),
                                             fabs(u[1][k] - v[1][k])));
                UNIT_NEAR(worst, 0, 64 * DBL_EPSILON);
            }
}

/* M has determinant -1, trace 0, eigenvectors (1,1) and (a,-b); twice is
   the identity. Each entry is good to 3 roundings of a number up to 2. */
TEST(test_matrix, "the map is a reflection")
{
    SEEDED(r, 4);
    for (int i = 0; i < 1000; ++i) {
        const double a = random_log_uniform(&r, 1e-3, 1e3), b = 1;
        double m[2][2] = {{1, 0}, {0, 1}}; /* rows: images of e1, e2 */
        double x = a, y = -b, c = 1, d = 1;
        collide(&m[0][0], &m[0][1], a, b, 1);
        collide(&m[1][0], &m[1][1], a, b, 1);
        UNIT_NEAR(m[0][0] + m[1][1], 0, 6 * DBL_EPSILON);
        UNIT_NEAR(m[0][0] * m[1][1] - m[0][1] * m[1][0], -1,
                  12 * DBL_EPSILON);
        collide(&c, &d, a, b, 1);
        UNIT_TRUE(c == 1 && d == 1);
        collide(&x, &y, a, b, 1);
        UNIT_NEAR(x, -a, 6 * DBL_EPSILON * (a + b));
        UNIT_NEAR(y, b, 6 * DBL_EPSILON * (a + b));
        x = 0.3;
        y = -0.7;
        collide(&x, &y, a, b, 1);
        collide(&x, &y, a, b, 1);
        UNIT_NEAR(x, 0.3, 12 * DBL_EPSILON);
        UNIT_NEAR(y, -0.7, 12 * DBL_EPSILON);
    }
}

/* v2 - v1 = e (u1 - u2), and the loss of energy is (1-e^2)/2 d^2/(a+b). */
TEST(test_restitution, "restitution takes the energy it should")
{
    SEEDED(r, 5);
    for (int form = 0; form < COLLIDE_FORMS; ++form)
        for (int i = 0; i < 300; ++i) {
            const double e = random_uniform(&r);
            const double a = random_between(&r, 0.1, 1);
            const double b = random_between(&r, 0.1, 1);
            const double u1 = random_uniform(&r), u2 = random_uniform(&r);
            const double d = u1 - u2;
            double v1 = u1, v2 = u2;
            collide_by(form, &v1, &v2, a, b, e);
            UNIT_NEAR(v2 - v1, e * d, 8 * DBL_EPSILON);
            UNIT_NEAR(v1 * v1 / a + v2 * v2 / b - u1 * u1 / a - u2 * u2 / b,
                      -(1 - e * e) * d * d / (a + b), 200 * DBL_EPSILON);
        }
}

/* Each form keeps energy to 8 eps and momentum to 4 eps of sum m|u| for
   mass ratios to 3: three roundings enter v, the energy doubles them. */
TEST(test_rounding_of_every_form,
     "every form keeps energy and momentum in one collision")
{
    SEEDED(r, 6);
    for (int form = 0; form < COLLIDE_FORMS; ++form) {
        double energy_worst = 0, momentum_worst = 0;
        for (int i = 0; i < 20000; ++i) {
            const double a = random_between(&r, 0.5, 1.5);
            const double b = a * random_log_uniform(&r, 1 / 3.0, 3);
            const double u1 = random_between(&r, -1, 1);
            const double u2 = random_between(&r, -1, 1);
            const quad m1 = 1 / (quad)a, m2 = 1 / (quad)b;
            double v1 = u1, v2 = u2;
            collide_by(form, &v1, &v2, a, b, 1);
            const quad before = m1 * u1 * u1 + m2 * u2 * u2;
            const quad after = m1 * v1 * v1 + m2 * v2 * v2;
            const quad scale = m1 * fabs(u1) + m2 * fabs(u2);
            const quad gain = m1 * v1 + m2 * v2 - m1 * u1 - m2 * u2;
            energy_worst = fmax(energy_worst,
                                fabs((double)((after - before) / before)));
            momentum_worst =
                fmax(momentum_worst, fabs((double)(gain / scale)));
        }
        UNIT_NEAR(energy_worst, 0, 8 * DBL_EPSILON);
        UNIT_NEAR(momentum_worst, 0,
                  (form == COLLIDE_COMPLEMENT ? 6 : 4) * DBL_EPSILON);
    }
}

TEST(test_one_dimension_is_the_same,
     "one dimension along a normal is one dimension")
{
    SEEDED(r, 7);
    const double right[1] = {1}, space[3] = {0, 1, 0};
    for (int i = 0; i < 1000; ++i) {
        const double a = random_uniform(&r), b = random_uniform(&r) + 0.1;
        const double e = random_uniform(&r);
        double v1 = random_normal(&r), v2 = random_normal(&r);
        double w1[1] = {v1}, w2[1] = {v2};
        double x1[3] = {5, v1, 6}, x2[3] = {-7, v2, 8};
        collide(&v1, &v2, a, b, e);
        UNIT_TRUE(collide_along(1, right, w1, w2, a, b, e));
        UNIT_TRUE(collide_along(3, space, x1, x2, a, b, e));
        UNIT_TRUE(w1[0] == v1 && w2[0] == v2);
        UNIT_TRUE(x1[0] == 5 && x1[1] == v1 && x1[2] == 6);
        UNIT_TRUE(x2[0] == -7 && x2[1] == v2 && x2[2] == 8);
    }
}

/* A heavy disk and a light one, normal (0.7, 0.7): exact fractions. */
TEST(test_two_disks, "two disks at forty-five degrees")
{
    const double normal[2] = {0.7, 0.7};
    double a[2] = {1, 0}, b[2] = {0, 0};
    double c[2] = {1, 0}, d[2] = {0, 0};
    UNIT_TRUE(collide_along(2, normal, a, b, 0.1, 1, 1));
    UNIT_LIST(a, 4 * DBL_EPSILON, 10.0 / 11, -1.0 / 11);
    UNIT_LIST(b, 4 * DBL_EPSILON, 10.0 / 11, 10.0 / 11);
    UNIT_TRUE(collide_along(2, normal, c, d, 0.1, 0.1, 1));
    UNIT_LIST(c, 4 * DBL_EPSILON, 0.5, -0.5);
    UNIT_LIST(d, 4 * DBL_EPSILON, 0.5, 0.5);
}

/* A power of two in front of the normal changes nothing, to the last bit,
   even where its square overflows or vanishes. */
TEST(test_any_length, "a normal may have any length")
{
    const int powers[] = {-1000, -600, -530, -520, -340, -40, -1,
                          1,     40,   340,  505,  600,  1000};
    SEEDED(r, 8);
    for (size_t k = 0; k < sizeof powers / sizeof powers[0]; ++k) {
        double n[3], m[3], u[2][3], v[2][3];
        random_direction(&r, 3, n);
        for (int i = 0; i < 3; ++i) {
            m[i] = ldexp(n[i], powers[k]);
            u[0][i] = v[0][i] = random_normal(&r);
            u[1][i] = v[1][i] = random_normal(&r);
        }
        UNIT_TRUE(collide_along(3, n, u[0], u[1], 0.3, 0.7, 0.9));
        UNIT_TRUE(collide_along(3, m, v[0], v[1], 0.3, 0.7, 0.9));
        UNIT_TRUE(memcmp(u, v, sizeof u) == 0);
    }
}

/* A normal of any length, and just half of a power of two, says the same;
   and a long one leaves room for fast bodies. */
TEST(test_scaled_normals, "normals of all lengths")
{
    for (int power = -1000; power <= 1000; power += 25) {
        const double normal[] = {0, ldexp(1, power), 0};
        double a[] = {0, 1, 0}, b[] = {0, -2, 0};
        UNIT_TRUE(collide_along(3, normal, a, b, 1, 1, 1));
        UNIT_NEAR(a[1], -2, 2e-15);
        UNIT_NEAR(b[1], 1, 2e-15);
    }
    const double normal[] = {1.05e10, 0, 0};
    double a[] = {1.75e298, 0, 0}, b[] = {0, 0, 0};
    UNIT_TRUE(collide_along(3, normal, a, b, 1, 1, 1));
    UNIT_NEAR(b[0], 1.75e298, 1e283);
    UNIT_NEAR(a[0], 0, 1e283);
    /* Of equal masses the second is the heavier, and gets its part rounded.
     */
    double v = 0x1p-1074, w = 0;
    UNIT_TRUE(collide(&v, &w, 1, 1, 0));
    UNIT_EQUAL(v, 0);
    UNIT_EQUAL(w, 0);
}
