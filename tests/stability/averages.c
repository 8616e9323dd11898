/* Where averages fail, "What does not settle": runs whose error bars are
   small and wrong, which have to be refused. */
#include "unit.h"

#include "averages.h"
#include "gallery.h"
#include "start.h"

#include <stdlib.h>

static struct averages_found ask(const struct scene *s, const char *name,
                                 double until, double tolerance,
                                 const char *model)
{
    struct averages_request q = {.scene = s,
                                 .until = until,
                                 .tolerance = tolerance,
                                 .reason = 5,
                                 .model = model};
    struct averages_found f = {.taken = 99};
    char message[AVERAGES_TEXT];
    UNIT_TRUE(averages_read(&q.quantity, name, s, message));
    UNIT_TRUE(averages_find(&f, &q));
    return f;
}

static bool refused(const struct averages_found *f)
{
    return f->taken == f->candidates && f->refusal[0] != '\0';
}

/* What a way has found; NAN if it was not tried. */
static const struct averages_candidate *candidate(
    const struct averages_found *f, const char *name)
{
    static const struct averages_candidate none = {
        .name = "", .value = NAN, .error = NAN};
    for (size_t k = 0; k < f->candidates; ++k)
        if (strcmp(f->candidate[k].name, name) == 0)
            return &f->candidate[k];
    return &none;
}

static void make_piston(struct scene *s, size_t bodies, double ratio)
{
    const struct start_wish wish = {.kind = START_ADIABATIC,
                                    .movers = bodies,
                                    .ratio = ratio,
                                    .seed = 1};
    struct start start;
    if (!start_fill(&start, &wish) || !scene_create(s, bodies))
        exit(1);
    s->contact = true;
    s->wall[0] = SCENE_HARD;
    s->high[0] = start.wall[1];
    for (size_t i = 0; i < bodies; ++i) {
        const double x = start.x[i], L = start.wall[1];
        s->mass[i] = start.mass[i];
        s->velocity[i] = start.v[i];
        s->position[i] = x <= L / 2 ? 0.7 * x : L - 1.3 * (L - x);
        s->freedom[bodies + i] = s->freedom[2 * bodies + i] = 0;
    }
    start_free(&start);
}

static void make_four(struct scene *s, double radius)
{
    if (gallery_make(s, gallery_find(hard_scenes, "four-disks"), NULL, 0))
        exit(1);
    for (size_t i = 0; i < 4; ++i) {
        s->radius[i] = radius;
        s->position[i] = i % 2 ? 0.75 : 0.25;
        s->position[4 + i] = i / 2 ? 0.75 : 0.25;
    }
}

/* Settled after 2048 s at 5 m, and on the way to 6 m all the same: a long
   run must not stop where a short one may. */
static void test_patience(void)
{
    struct scene s;
    make_piston(&s, 41, 600);
    const struct averages_found brief = ask(&s, "x:20", 2048, 0.01, NULL);
    UNIT_TRUE(!refused(&brief));
    UNIT_NEAR(brief.value, 4.97, 0.1); /* the mean of the run to 2048 s */
    const struct averages_found f = ask(&s, "x:20", 32768, 0.01, NULL);
    UNIT_TRUE(refused(&f) && strstr(f.refusal, "settle"));
    UNIT_TRUE(candidate(&f, "events")->error < 0.01);
    UNIT_TRUE(candidate(&f, "order")->sure == AVERAGES_OUT);
    UNIT_NEAR(candidate(&f, "order")->value, 6, 1e-12);
    scene_free(&s);
}

/* Twice as heavy: beside events the springs look well for two swings, and
   after 10000 s the mean has left theirs. */
static void test_drift(void)
{
    struct scene s;
    make_piston(&s, 41, 1200);
    const struct averages_found brief = ask(&s, "x:20", 1000, 0.01, NULL);
    UNIT_TRUE(!refused(&brief));
    UNIT_TRUE(candidate(&brief, "springs")->error < 0.01);
    const struct averages_found f = ask(&s, "x:20", 1e4, 0.01, NULL);
    UNIT_TRUE(refused(&f));
    UNIT_TRUE(candidate(&f, "events")->value -
                  candidate(&f, "springs")->value >
              0.1);
    scene_free(&s);
}

/* Disks in their corners: both ways have a mean of 0.27 and an error of
   less than a hundredth. */
static void test_corners(void)
{
    static const char *const ways[] = {"events", "sampling"};
    struct scene s;
    make_four(&s, 0.2);
    for (int k = 0; k < 2; ++k) {
        const struct averages_found f = ask(&s, "x:0", 2000, 0.02, ways[k]);
        const struct averages_candidate *c = candidate(&f, ways[k]);
        UNIT_TRUE(refused(&f) && strstr(f.refusal, "just alike"));
        UNIT_NEAR(c->value, 0.27, 0.01);
        UNIT_TRUE(c->error < 0.01);
    }
    struct averages_found f = ask(&s, "pressure", 1e5, 0.01, NULL);
    UNIT_TRUE(!refused(&f)); /* does not care which is which */
    scene_free(&s);
}

/* Equal masses on a line keep their speeds: no law is taken, and the mean
   of the cradle's first ball is nowhere near it. */
static void test_equal_masses(void)
{
    struct scene s;
    if (gallery_make(&s, gallery_find(hard_scenes, "cradle"), NULL, 0))
        exit(1);
    const struct averages_found f = ask(&s, "x:0", 1e4, 0.01, NULL);
    const struct averages_candidate *law = candidate(&f, "order");
    UNIT_TRUE(!refused(&f));
    UNIT_TRUE(law->sure == AVERAGES_OUT && strstr(law->text, "speeds"));
    UNIT_TRUE(f.value - law->value > 0.1 * f.scale);
    scene_free(&s);
}

/* Two bodies do not mix: their places have no law, their pressure has. */
static void test_two_bodies(void)
{
    struct scene s;
    if (gallery_make(&s, gallery_find(hard_scenes, "thermal"), "particles",
                     2))
        exit(1);
    struct averages_found f = ask(&s, "x:0", 1e4, 0.01, "order");
    UNIT_TRUE(refused(&f) && strstr(f.refusal, "do not mix"));
    f = ask(&s, "pressure", 1e4, 0.01, NULL);
    UNIT_TRUE(!refused(&f));
    scene_free(&s);
}

/* A gas whose bodies all fly the same way at one speed is no warm gas: it
   is seen beside events that the springs are wrong, however heavy the
   piston is, as chapter 4 says. */
static void test_no_gas(void)
{
    struct scene s;
    make_piston(&s, 41, 1200);
    const struct averages_found warm = ask(&s, "x:20", 256, 0.01, NULL);
    for (size_t i = 0; i < 41; ++i)
        s.velocity[i] = i == 20 ? 0 : 1;
    const struct averages_found f = ask(&s, "x:20", 256, 0.01, NULL);
    UNIT_TRUE(candidate(&warm, "springs")->error < 0.01);
    UNIT_TRUE(refused(&f));
    UNIT_TRUE(candidate(&f, "springs")->error > 0.01);
    scene_free(&s);
}

/* Steps have a bias that no sample mends: never taken. */
static void test_steps(void)
{
    struct scene s;
    make_four(&s, 0.15);
    const struct averages_found f = ask(&s, "pressure", 1e6, 0.02, NULL);
    UNIT_TRUE(!refused(&f));
    UNIT_TRUE(candidate(&f, "steps")->sure == AVERAGES_OUT);
    UNIT_TRUE(candidate(&f, "steps")->error > 1e-3);
    const struct averages_found g = ask(&s, "pressure", 1e6, 0.02, "steps");
    UNIT_TRUE(refused(&g));
    scene_free(&s);
}

int main(void)
{
    return unit_run(
        "averages_limits",
        (struct unit_test[]){
            {"a heavy piston that has settled has not", test_patience},
            {"springs that look well for two swings are left in time",
             test_drift},
            {"disks that keep their corners have no mean place",
             test_corners},
            {"equal masses on a line follow no law of places",
             test_equal_masses},
            {"two bodies have a pressure and no law of places",
             test_two_bodies},
            {"bodies of one speed are no springs", test_no_gas},
            {"steps are never taken for a pressure", test_steps},
            {0}});
}
