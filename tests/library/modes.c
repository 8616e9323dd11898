/* Modes and scenes of springs against formulas and numbers of this book's
   own computations (membrane_modes.dat, springs_numbers.txt). */
#include "unit.h"

#include "library/galleries.h"
#include "forces/elastic.h"
#include "forces/modes.h"

static void find(struct modes *m, const struct scene *s)
{
    FREED(springs) p;
    UNIT_MUST(springs_create(&p, s) && modes_find(m, &p, s->position));
}

TEST(test_taut, "all modes of a taut membrane are those of the formula")
{
    const struct elastic_membrane e = {8, 6, 2, 50,   0, 0.8,
                                       0, 1, 1, true, 0, 0};
    FREED(scene) s;
    double law[72];
    size_t n = 0;
    UNIT_MUST(!elastic_membrane(&s, &e));
    MADE(modes, m, find(&m, &s));
    for (int axis = 0; axis < 3; ++axis)
        for (int r = 1; r <= 6; ++r)
            for (int h = 1; h <= 4; ++h) {
                const double a = sin(r * acos(-1) / 14);
                const double b = sin(h * acos(-1) / 10);
                const double kx = axis == 0 ? 50 : 10;
                const double ky = axis == 1 ? 50 : 10;
                law[n++] = 4 * (kx * a * a + ky * b * b) / 2;
            }
    qsort(law, n, sizeof *law, unit_rising);
    UNIT_EQUAL(m.size, n);
    for (size_t i = 0; i < n; ++i) /* of up to 200: 1e-12 is 20 roundings */
        UNIT_NEAR(m.square[i], law[i], 1e-12);
}

/* The 8 x 8 membrane: first and largest frequency taut; at rest length no
   stiffness across. */
TEST(test_membranes, "a membrane at rest length has 36 loose modes")
{
    int loose = 0;
    FREED(scene) s = made("membrane", "amplitude", 0);
    MADE(modes, m, find(&m, &s));
    for (size_t i = 0; i < m.size; ++i)
        loose += fabs(m.square[i]) < 1e-10;
    UNIT_EQUAL(loose, 36);
    UNIT_NEAR(sqrt(m.square[m.size - 1]), 13.787563, 1e-6);
}

TEST(test_cantilever, "the cantilever's frequencies and deflection")
{
    double a[36] = {0}, u[36] = {0};
    FREED(scene) s = made("cantilever", NULL, 0);
    MADE(modes, m, find(&m, &s));
    UNIT_NEAR(sqrt(m.square[0]), 1.76355068, 1e-8);
    UNIT_NEAR(sqrt(m.square[1]), 8.93555667, 1e-8);
    UNIT_NEAR(sqrt(m.square[2]), 10.1679045, 1e-7);
    UNIT_NEAR(sqrt(m.square[m.size - 1]), 74.8249253, 1e-6);
    for (int i = 12; i < 24; ++i)
        a[i] = -1;
    modes_deflection(&m, 1e-6, a, u);
    UNIT_NEAR(u[5], -0.055, 1e-12);
    UNIT_NEAR(u[17], -0.425, 1e-12);
    UNIT_NEAR(u[11], 0.055, 1e-12);
    UNIT_NEAR(u[23], -0.425, 1e-12);
}

/* Modes of length 1, at right angles, each a solution of its equation. */
TEST(test_orthogonal, "modes are at right angles")
{
    FREED(scene) s = made("cantilever", "diagonals", 1);
    MADE(modes, m, find(&m, &s));
    for (size_t i = 0; i < m.size; ++i)
        for (size_t j = 0; j < m.size; ++j) {
            double sum = 0;
            for (size_t k = 0; k < m.size; ++k)
                sum += m.shape[i * m.size + k] * m.shape[j * m.size + k];
            UNIT_NEAR(sum, i == j, 1e-13);
        }
}

/* Two bodies of 2 kg and 1 kg between walls on springs of 0.3 N/m: the
   matrix is 0.3, -0.3/root 2, 0.6, its roots 0.45 +- root 0.0675. */
TEST(test_by_hand, "two bodies between walls, by hand")
{
    FREED(scene) s;
    UNIT_MUST(scene_create(&s, 4) && scene_add_kind(&s, 0.3, 0));
    for (size_t i = 0; i < 4; ++i) {
        s.position[i] = (double)i;
        s.freedom[i] = i == 1 || i == 2;
        s.freedom[4 + i] = s.freedom[8 + i] = 0;
        if (i > 0 && !scene_add_spring(&s, i - 1, i, 0, 0.5))
            exit(1);
    }
    s.mass[1] = 2;
    MADE(modes, m, find(&m, &s));
    UNIT_EQUAL(m.size, 2);
    for (int k = 0; k < 2; ++k) {
        const double root = 0.45 + (k ? 1 : -1) * sqrt(0.0675);
        const double off = -0.3 / sqrt(2);
        UNIT_NEAR(m.square[k], root, 1e-15);
        UNIT_NEAR(m.shape[2 * k] * (0.3 - root) + m.shape[2 * k + 1] * off,
                  0, 1e-15);
    }
}
