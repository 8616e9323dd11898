/* Where the chooser draws its lines: overlaps at the start, and pairs that
   the tolerance does not see because of one body far away. */
#include "enough/choose.h"
#include "unit.h"

#include <stdlib.h>

static struct choose_choice chosen(const struct scene *s, double tolerance)
{
    const struct choose_request q = {.scene = s,
                                     .program = "choose",
                                     .until = s->time + 0.5,
                                     .every = 0.25,
                                     .tolerance = tolerance,
                                     .reason = 1};
    struct choose_choice c;
    UNIT_TRUE(choose(&c, &q));
    return c;
}

/* Two balls on a line of 5 m, from wall to wall, that overlap by 1.5 mm:
   3e-4 of the scale. A tolerance below that has to know what becomes of it.
 */
static void test_overlap(void)
{
    static const double share[] = {0.999, 1.001, 0.6, 1.5};
    for (size_t k = 0; k < 4; ++k) {
        struct scene s;
        UNIT_TRUE(scene_create(&s, 2));
        s.contact = true;
        s.wall[0] = SCENE_HARD;
        s.low[0] = -2;
        s.high[0] = 3;
        s.radius[0] = s.radius[1] = 0.5;
        s.position[1] = 0.9985;
        s.velocity[1] = 0.3;
        for (size_t c = 2; c < 6; ++c)
            s.freedom[c] = 0;
        struct choose_choice c = chosen(&s, 3e-4 * share[k]);
        const bool refused = strstr(c.refusal, "overlap") != NULL;
        UNIT_TRUE(refused == (share[k] < 1));
        choose_free(&c);
        scene_free(&s);
    }
}

/* Two bodies 1 mm apart, and a third one 100 m away, by which errors are
   judged: from a tolerance of 1e-5 on nobody could tell the two apart.
   Without a third one, or with one that is near, they have a scale of their
   own. */
static void test_hidden(void)
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
            struct scene s;
            UNIT_TRUE(scene_create(&s, 3));
            const size_t a = far == 0, b = far == 2 ? 1 : 2;
            s.position[a] = 0;
            s.position[b] = 0.001;
            s.position[far] = known[k].far;
            s.velocity[3] = 0.1;
            struct choose_choice c = chosen(&s, known[k].tolerance);
            if (known[k].hidden) {
                UNIT_NEAR(c.hidden.apart, 0.001, 1e-15);
                UNIT_NEAR(c.hidden.without, 0.001, 1e-15);
                UNIT_EQUAL((double)c.hidden.far, (double)far);
                UNIT_EQUAL((double)(c.hidden.a + c.hidden.b),
                           (double)(a + b));
            } else {
                UNIT_EQUAL(c.hidden.apart, 0);
            }
            choose_free(&c);
            scene_free(&s);
        }
}

int main(void)
{
    return unit_run(
        "choose_limits",
        (struct unit_test[]){{"overlaps at the start", test_overlap},
                             {"a pair that is hidden", test_hidden},
                             {0}});
}
