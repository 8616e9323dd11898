/* The scenes of springs: what is where, what is held, and the motion of the
   paper's membrane and of the beam against this book's own numbers
   (springs_numbers.txt). */
#include "unit.h"

#include "library/galleries.h"
#include "forces/elastic.h"
#include "forces/springs.h"

static void begin(struct springs *p, struct stepping *t, struct scene *s,
                  const char *method, double dt)
{
    UNIT_MUST(springs_create(p, s) &&
              stepping_begin(t, stepping_find(method), springs_forces(p),
                             dt, s->position, s->velocity));
}

TEST(test_pendulum, "the double pendulum hangs where it should")
{
    FREED(scene) s = made("double-pendulum", NULL, 0);
    /* the sines of the series and those of the C library are both right to
       a rounding, of numbers below 1 */
    const double sine = sin(0.6), cosine = cos(0.6);
    UNIT_NEAR(s.position[1], sine, 2.3e-16);
    UNIT_NEAR(s.position[7], 1 - cosine, 2.3e-16);
    UNIT_NEAR(s.position[2], 2 * sine, 4.5e-16);
    UNIT_NEAR(s.position[8], 1 - 2 * cosine, 4.5e-16);
    UNIT_EQUAL(s.spring[0].rest, 1);
    UNIT_EQUAL(s.freedom[1], 1);
    UNIT_EQUAL(s.freedom[4], 0);
    UNIT_EQUAL(s.freedom[0], 0);
}

TEST(test_membrane, "a membrane is symmetric to the last bit")
{
    FREED(scene) s = made("membrane", "s", 2);
    const double *z = s.position + 128;
    for (size_t y = 0; y < 8; ++y)
        for (size_t x = 0; x < 8; ++x) {
            const size_t i = y * 8 + x;
            const bool rim = x == 0 || y == 0 || x == 7 || y == 7;
            UNIT_EQUAL(z[i], z[y * 8 + 7 - x]);
            UNIT_EQUAL(z[i], -z[(7 - y) * 8 + x]);
            UNIT_EQUAL(s.freedom[i], !rim);
            UNIT_EQUAL(rim ? z[i] : 0, 0);
            UNIT_NEAR(z[i],
                      0.1 * sin(acos(-1) * (double)x / 7) *
                          sin(2 * acos(-1) * (double)y / 7),
                      1e-16);
        }
    UNIT_EQUAL(s.springs, 112);
}

/* The paper's membrane, along z only: its first mode at 1, 2, 5, 10 s. */
TEST(test_naive, "the paper's membrane moves as computed elsewhere")
{
    const double expected[][2] = {{1, .9358708481},
                                  {2, .7680008832},
                                  {5, .0381770696},
                                  {10, -.9797675654}};
    const struct elastic_membrane m = {8,   8, 1, 50,    0, 1,
                                       0.1, 1, 1, false, 0, 0};
    FREED(scene) s;
    FREED(stepping) t;
    UNIT_MUST(!elastic_membrane(&s, &m));
    MADE(springs, p, begin(&p, &t, &s, "kahan-li8", 0.02));
    for (int k = 0; k < 4; ++k) {
        double sum = 0;
        stepping_run(&t, (uint64_t)(expected[k][0] / 0.02 + 0.5) - t.steps);
        for (size_t i = 0; i < 64; ++i)
            sum += s.position[128 + i] *
                   sin(acos(-1) * (double)(i % 8) / 7) *
                   sin(acos(-1) * (double)(i / 8) / 7);
        UNIT_NEAR(4 * sum / 49 / 0.1, expected[k][1], 1e-9);
    }
}

/* Two rows of five, six uprights, and the diagonals of five cells; those
   that go up to the left begin one body further right. */
TEST(test_truss, "a truss has the diagonals it was asked for")
{
    for (int diagonals = 0; diagonals < 3; ++diagonals) {
        int left = 0;
        FREED(scene) s = made("cantilever", "diagonals", diagonals);
        for (size_t i = 0; i < s.springs; ++i)
            left += s.spring[i].b - s.spring[i].a == 5;
        UNIT_EQUAL(s.springs, 16 + 5 * diagonals);
        UNIT_EQUAL(left, diagonals == 2 ? 5 : 0);
    }
}
