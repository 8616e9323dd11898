/* Where methods and springs fail: each method a thousandth below and above
   its step limit, on the stiff double pendulum and on the taut membrane;
   Euler's method, at any step; RK4, which damps in silence; the truss that
   is a mechanism. */
#include "unit.h"

#include "forces/elastic.h"
#include "forces/modes.h"
#include "forces/springs.h"

static void make(struct scene *s, const char *name, const char *key,
                 double value)
{
    UNIT_MUST(
        !gallery_make(s, gallery_find(elastic_scenes, name), key, value));
}

/* At rest: the hanging pendulum, or a taut membrane. */
static void make_at_rest(struct scene *s, bool pendulum)
{
    const struct elastic_membrane taut = {8, 8, 1, 50,   0, 0.8,
                                          0, 1, 1, true, 0, 0};
    if (!pendulum) {
        UNIT_MUST(!elastic_membrane(s, &taut));
        return;
    }
    make(s, "double-pendulum", NULL, 0);
    s->position[1] = s->position[2] = 0;
    s->position[7] = -3.6 / 5000;
    s->position[8] = s->position[7] - 1 - 0.36;
}

/* How far the fastest mode, disturbed by 1e-9 m, has gone after so many
   steps of omega dt = phase. */
static double excursion(const char *method, bool pendulum, double phase,
                        uint64_t steps)
{
    FREED(scene) s, rest;
    FREED(springs) p;
    FREED(modes) m;
    FREED(stepping) t;
    double far = 0;
    make_at_rest(&s, pendulum);
    UNIT_MUST(scene_copy(&rest, &s) && springs_create(&p, &s) &&
              modes_find(&m, &p, s.position));
    const double fastest = sqrt(m.square[m.size - 1]);
    for (size_t i = 0; i < m.size; ++i)
        s.position[m.coordinate[i]] +=
            1e-9 * m.shape[(m.size - 1) * m.size + i];
    UNIT_NEAR(fastest, pendulum ? 70.74605996 : 15.103518, 1e-6);
    UNIT_MUST(stepping_begin(&t, stepping_find(method), springs_forces(&p),
                             phase / fastest, s.position, s.velocity));
    for (uint64_t k = 0; k < steps && far < 1e-3; k += 100) {
        if (stepping_run(&t, 100) != STEPPING_DONE)
            far = 1;
        for (size_t i = 0; i < 3 * s.bodies; ++i) {
            const double off = fabs(s.position[i] - rest.position[i]);
            far = off <= far ? far : isfinite(off) ? off : 1;
        }
    }
    return far;
}

/* The limits of chapter 8: 2, 2 sqrt 2, 1.5734, 2.2691, 2.9894. */
static void try_limits(bool pendulum)
{
    static const struct {
        const char *method;
        double limit;
    } row[] = {{"leapfrog", 2},
               {"symplectic-euler", 2},
               {"rk4", 2.8284271247461903},
               {"yoshida4", 1.57340194743},
               {"yoshida6", 2.2690579964},
               {"pefrl", 2.98944954591}};
    for (size_t i = 0; i < sizeof row / sizeof *row; ++i) {
        const char *m = row[i].method;
        /* above, a disturbance grows by more than exp(0.002) a step */
        UNIT_TRUE(excursion(m, pendulum, 0.999 * row[i].limit, 4000) <
                  1e-6);
        UNIT_TRUE(excursion(m, pendulum, 1.001 * row[i].limit, 20000) >
                  1e-4);
    }
}

TEST(test_pendulum, "the stiff pendulum's step limits, from both sides")
{
    try_limits(true);
    UNIT_NEAR(2 / 70.74605996, 0.02827, 1e-6);
    UNIT_TRUE(excursion("implicit-midpoint", true, 15, 400) < 1e-6);
    UNIT_TRUE(excursion("gauss4", true, 15, 400) < 1e-6);
}

TEST(test_membrane, "the membrane's step limits, from both sides")
{
    try_limits(false);
}

/* Euler's method multiplies the stiff amplitude by sqrt(1 + (w h)^2) in a
   step; the pendulum is lost at 9.2, 4.6, 2.3 s, as the step doubles. */
TEST(test_euler, "Euler's method loses the pendulum at any step")
{
    const double dt[] = {5e-4, 1e-3, 2e-3}, lost[] = {9.2, 4.6, 2.3};
    for (int k = 0; k < 3; ++k) {
        FREED(springs) p;
        FREED(stepping) t;
        MADE(scene, s, make(&s, "double-pendulum", NULL, 0));
        UNIT_MUST(springs_create(&p, &s) &&
                  stepping_begin(&t, stepping_find("euler"),
                                 springs_forces(&p), dt[k], s.position,
                                 s.velocity));
        while (stepping_time(&t) < 20 && fabs(s.position[7]) < 10 &&
               stepping_run(&t, 10) == STEPPING_DONE)
            ;
        UNIT_NEAR(stepping_time(&t) / lost[k], 1, 0.15);
    }
}

/* The upper spring's stretch, from 9 s to 10 s: the largest change from one
   row to the next, 0.025 s apart. */
static double ripple(const char *method, int steps)
{
    FREED(springs) p;
    FREED(stepping) t;
    double most = 0, before = 0;
    MADE(scene, s, make(&s, "double-pendulum", NULL, 0));
    UNIT_MUST(springs_create(&p, &s) &&
              stepping_begin(&t, stepping_find(method), springs_forces(&p),
                             0.025 / steps, s.position, s.velocity));
    for (int i = 1; i <= 400; ++i) {
        stepping_run(&t, (uint64_t)steps);
        const double now = hypot(s.position[1], s.position[7] - 1);
        if (i > 360)
            most = fmax(most, fabs(now - before));
        before = now;
    }
    return most;
}

/* RK4 at 0.025 s, below its limit: no complaint, and no stiff oscillation;
   the leapfrog keeps it at the same step. */
TEST(test_silent, "RK4 damps the stiff spring in silence")
{
    UNIT_TRUE(ripple("yoshida4", 50) > 2e-4);
    UNIT_TRUE(ripple("leapfrog", 1) > 2e-4);
    UNIT_TRUE(ripple("rk4", 1) < 6e-5);
}

/* Without diagonals: five modes without stiffness, one a cell; with one
   diagonal a cell none. Let go, the mechanism falls to the wall. */
TEST(test_mechanism, "a truss without diagonals is a mechanism")
{
    for (int diagonals = 0; diagonals < 3; ++diagonals) {
        FREED(springs) p;
        FREED(modes) m;
        FREED(stepping) t;
        int loose = 0;
        MADE(scene, s, make(&s, "cantilever", "diagonals", diagonals));
        s.damping = 2;
        UNIT_MUST(springs_create(&p, &s) &&
                  modes_find(&m, &p, s.position) &&
                  stepping_begin(&t, stepping_find("leapfrog"),
                                 springs_forces(&p), 0.01, s.position,
                                 s.velocity));
        for (size_t i = 0; i < m.size; ++i)
            loose += fabs(m.square[i]) < 1e-9;
        UNIT_EQUAL(loose, diagonals == 0 ? 5 : 0);
        stepping_run(&t, 10000);
        if (diagonals == 0)
            UNIT_TRUE(s.position[5] < 0.1 && s.position[17] < -5);
        else
            UNIT_TRUE(s.position[17] > -0.6);
    }
}
