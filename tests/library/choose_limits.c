/* Where the chooser draws its lines: overlaps at the start, pairs that the
   tolerance does not see because of one body far away, and tolerances near
   the floor of rounding. */
#include "choosing/choose.h"
#include "library/plans.h"
#include "library/galleries.h"
#include "unit.h"

static struct choose_choice chosen(const struct scene *s, double tolerance)
{
    const struct choose_request q = {.scene = s,
                                     .program = "choose",
                                     .until = s->time + 0.5,
                                     .every = 0.25,
                                     .tolerance = tolerance,
                                     .budget = 1};
    struct choose_choice c;
    UNIT_TRUE(choose(&c, &q));
    return c;
}

/* Two balls on a line of 5 m, from wall to wall, that overlap by 1.5 mm:
   3e-4 of the scale. A tolerance below that has to know what becomes of it.
 */
TEST(test_overlap, "overlaps at the start")
{
    static const double share[] = {0.999, 1.001, 0.6, 1.5};
    for (size_t k = 0; k < 4; ++k) {
        CREATED(scene, s, 2);
        s.contact = true;
        WALLS(s, 0, SCENE_HARD, -2, 3);
        s.radius[0] = s.radius[1] = 0.5;
        s.position[1] = 0.9985;
        s.velocity[1] = 0.3;
        for (size_t c = 2; c < 6; ++c)
            s.freedom[c] = 0;
        CHOICE c = chosen(&s, 3e-4 * share[k]);
        const bool refused = strstr(c.refusal, "overlap") != NULL;
        UNIT_TRUE(refused == (share[k] < 1));
    }
}

/* Two bodies 1 mm apart, and a third one 100 m away, by which errors are
   judged: from a tolerance of 1e-5 on nobody could tell the two apart.
   Without a third one, or with one that is near, they have a scale of their
   own. */
TEST(test_hidden, "a pair that is hidden")
{
    static const struct {
        double far, tolerance;
        bool hidden;
    } known[] = {{100, 1.01e-5, true},  {100, 0.99e-5, false},
                 {100, 1e-3, true},     {-50, 2.02e-5, true},
                 {-50, 1.98e-5, false}, {0.00995, 0.5, false},
                 {0.01005, 0.5, true}};
    for (size_t k = 0; k < sizeof known / sizeof known[0]; ++k)
        for (size_t far = 0; far < 3; ++far) {
            CREATED(scene, s, 3);
            const size_t a = far == 0, b = far == 2 ? 1 : 2;
            s.position[a] = 0;
            s.position[b] = 0.001;
            s.position[far] = known[k].far;
            s.velocity[3] = 0.1;
            CHOICE c = chosen(&s, known[k].tolerance);
            if (known[k].hidden) {
                UNIT_NEAR(c.hidden.distance, 0.001, 1e-15);
                UNIT_NEAR(c.hidden.without, 0.001, 1e-15);
                UNIT_EQUAL(c.hidden.far, far);
                UNIT_EQUAL(c.hidden.a + c.hidden.b, a + b);
            } else {
                UNIT_EQUAL(c.hidden.distance, 0);
            }
        }
}

static struct choose_choice carried(const char *name, double until,
                                    size_t rows, double tolerance)
{
    FREED(scene) s = made(name, NULL, 0);
    struct choose_choice c;
    const struct choose_request q = {.scene = &s,
                                     .program = "choose",
                                     .until = s.time + until,
                                     .every = until / (double)rows,
                                     .tolerance = tolerance,
                                     .budget = 10};
    UNIT_TRUE(choose(&c, &q));
    return c;
}

/* Four disks seen so often that their twins first differ by a little more
   than half of the tolerance, and a row later by less than twice as much:
   the horizon is found at once, not after another seven thousand rows. */
TEST(test_parting, "twins that part slowly")
{
    CHOICE c = carried("four-disks", 400, 8000, 1e-3);
    UNIT_TRUE(!c.run.value);
    UNIT_NEAR(c.horizon, 5.35, 0.1);
    UNIT_TRUE(c.spent < 1e-3);
}

/* Near the floor of rounding twins of the reference are asked after a run
   was taken. If they leave that not enough, another one is taken; if they
   differ by too much, none: then the bound of the reference alone is more
   than half of the tolerance. */
TEST(test_floor, "near the floor of rounding")
{
    unsigned seen = 0;
    for (double e = 1e-13; e > 1e-14; e /= 1.1) {
        CHOICE c = carried("figure-eight", 2, 4, e);
        UNIT_TRUE(c.run.value != NULL);
        UNIT_TRUE(c.candidate[c.taken].error <= e && c.doubt <= e / 2);
        UNIT_TRUE(c.candidate[c.taken].error > c.doubt);
        seen += c.doubt > e / 20; /* by twins */
    }
    UNIT_TRUE(seen > 20);
    for (double e = 4e-12; e > 1.3e-12; e /= 1.4) {
        CHOICE c = carried("pythagorean", 9, 4, e);
        UNIT_TRUE(!c.run.value && c.doubt > e / 2);
        UNIT_EQUAL(c.horizon, 4.5);
        UNIT_TRUE(strstr(c.refusal, "horizon") == c.refusal);
    }
}
