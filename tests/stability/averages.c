/* Where averages fail, "What does not settle": runs whose error bars are
   small and wrong, which have to be refused. */
#include "unit.h"

#include "scenes/gallery.h"
#include "library/asked.h"
#include "toolbox/random.h"

#include <stdlib.h>

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

/* Makes body i a disk. */
static void put(struct scene *s, size_t i, double mass, double radius,
                const double x[2], const double v[2])
{
    const size_t n = s->bodies;
    s->mass[i] = mass;
    s->radius[i] = radius;
    for (size_t k = 0; k < 2; ++k) {
        s->position[k * n + i] = x[k];
        s->velocity[k * n + i] = v[k];
    }
    s->freedom[2 * n + i] = 0;
}

/* Two points on a line from 0 to 1 m, thrown. Equal masses have nearly the
   same speed. */
static void make_pair(struct scene *s, double ratio, uint64_t seed)
{
    struct random r;
    random_seed(&r, seed);
    if (!scene_create(s, 2))
        exit(1);
    s->contact = true;
    s->wall[0] = SCENE_HARD;
    s->high[0] = 1;
    for (size_t i = 0; i < 2; ++i) {
        const double low = 0.5 * (double)i, u = random_between(&r, -1, 1);
        s->mass[i] = i == 0 ? 1 : ratio;
        s->position[i] = random_between(&r, low, low + 0.5);
        s->velocity[i] = ratio == 1 ? 1 + u / 100 : u;
        s->freedom[2 + i] = s->freedom[4 + i] = 0;
    }
}

/* The mean place of the first of two points over a time, from the parabola
   between collisions: no rows, and an engine of the test's own. */
static double mean_of_first(const struct scene *s, double until)
{
    double x[2] = {s->position[0], s->position[1]}, now = 0, sum = 0;
    double v[2] = {s->velocity[0], s->velocity[1]};
    const double a = s->mass[0], b = s->mass[1];
    while (now < until) {
        const double left = v[0] < 0 ? -x[0] / v[0] : INFINITY;
        const double right = v[1] > 0 ? (1 - x[1]) / v[1] : INFINITY;
        const double meet =
            v[0] > v[1] ? (x[1] - x[0]) / (v[0] - v[1]) : INFINITY;
        const double next = fmax(0, fmin(meet, fmin(left, right)));
        const double t = fmin(next, until - now);
        sum += x[0] * t + v[0] * t * t / 2;
        x[0] += v[0] * t;
        x[1] += v[1] * t;
        now += t;
        if (left <= next)
            v[0] = -v[0];
        else if (right <= next)
            v[1] = -v[1];
        else {
            const double mean = (a * v[0] + b * v[1]) / (a + b);
            v[0] = 2 * mean - v[0];
            v[1] = 2 * mean - v[1];
        }
    }
    return sum / until;
}

/* Two alone on a line: whatever their masses, what is answered is the mean
   of the run. Blocks believe in means that are many errors off. */
static void test_pairs(void)
{
    static const double ratios[] = {1.1, 1.618033988749895, 2, 3, 30, 1000};
    const double T = 5000;
    for (size_t k = 0; k < sizeof ratios / sizeof ratios[0]; ++k)
        for (uint64_t seed = 1; seed <= 5; ++seed) {
            struct scene s;
            make_pair(&s, ratios[k], seed);
            const double mean = mean_of_first(&s, T);
            for (double e = 0.05; e > 0.004; e /= 3) {
                const struct averages_found f = ask(&s, "x:0", T, e, NULL);
                UNIT_TRUE(taken(&f, "whole"));
                UNIT_TRUE(f.error <= e);
                UNIT_NEAR(f.value, mean, f.error);
            }
            scene_free(&s);
        }
}

/* Equal masses with speeds that differ by a hundredth: three standard
   errors at most, where blocks of a run are off by forty. */
static void test_beats(void)
{
    const double T = 5000;
    for (uint64_t seed = 1; seed <= 6; ++seed) {
        struct scene s;
        make_pair(&s, 1, seed);
        const struct averages_found f = ask(&s, "x:0", T, 0.01, NULL);
        UNIT_TRUE(taken(&f, "instants"));
        UNIT_TRUE(f.error <= 0.01);
        UNIT_NEAR(f.value, mean_of_first(&s, T), 1.5 * f.error);
        scene_free(&s);
    }
}

/* A ball at rest that nobody meets in time: throws that have all seen the
   same do not know that there is nothing else, to 3 in their number. */
static void test_unseen(void)
{
    struct scene s;
    make_pair(&s, 1, 1);
    s.velocity[0] = 0;
    s.velocity[1] = 1e-6;
    const struct averages_found f = ask(&s, "x:0", 100, 1e-3, NULL);
    UNIT_TRUE(taken(&f, "instants"));
    UNIT_NEAR(f.value, s.position[0], 1e-12);
    UNIT_TRUE(f.error <= 1e-3 && f.error * (double)f.samples >= 3);
    scene_free(&s);
}

/* A run whose end nobody pays for is refused early, and the time that is
   offered instead can be had. */
static void test_endless(void)
{
    struct scene s;
    make_pair(&s, 30, 1);
    const struct averages_found f = ask(&s, "x:0", 1e12, 0.01, NULL);
    const char *offer = strstr(f.refusal, "; ask for ");
    UNIT_TRUE(refused(&f) && offer);
    UNIT_TRUE(f.cost + f.deciding < 0.01);
    const double T = offer ? strtod(offer + 10, NULL) : 0;
    UNIT_TRUE(T > 1e4 && T < 1e9);
    struct averages_request q = {.scene = &s,
                                 .quantity = {.kind = AVERAGES_PLACE},
                                 .until = 1e12,
                                 .tolerance = 0.01,
                                 .reason = 0.02};
    struct averages_found g;
    UNIT_TRUE(averages_find(&g, &q) && refused(&g));
    offer = strstr(g.refusal, "; ask for ");
    q.until = offer ? strtod(offer + 10, NULL) : 0;
    UNIT_TRUE(averages_find(&g, &q) && taken(&g, "whole"));
    UNIT_TRUE(g.cost + g.deciding <= 0.02);
    scene_free(&s);
}

/* Two that meet the wall and each other at one instant: which comes first
   is a matter of the last bit, and the run another one after it. */
static void test_corner(void)
{
    struct scene s;
    make_pair(&s, 2, 1);
    s.position[0] = -(s.velocity[0] = -0.3);
    s.position[1] = -(s.velocity[1] = -0.6);
    struct averages_found f = ask(&s, "x:0", 1000, 0.01, NULL);
    const char *offer = strstr(f.refusal, "rounding decides");
    UNIT_TRUE(refused(&f) && offer);
    offer = offer ? strstr(offer, "ask for ") : NULL;
    const double e = offer ? strtod(offer + 8, NULL) : 1;
    UNIT_TRUE(e > 0.01 && e < 0.1);
    f = ask(&s, "x:0", 1000, e, NULL);
    UNIT_TRUE(taken(&f, "whole") && f.error <= e);
    UNIT_NEAR(f.value, mean_of_first(&s, 1000), f.error * f.scale);
    scene_free(&s);
}

/* An empty box with walls, for so many disks. */
static void make_box(struct scene *s, size_t n, double width, double height)
{
    if (!scene_create(s, n))
        exit(1);
    s->contact = true;
    s->wall[0] = s->wall[1] = SCENE_HARD;
    s->high[0] = width;
    s->high[1] = height;
}

/* Two disks on one line in a wide box, a third one aside, and nothing moves
   across. A chain goes everywhere, and knows the middle to a fiftieth; the
   motion never puts the first disk to the right of the second. */
static void test_chain(void)
{
    struct scene s;
    make_box(&s, 3, 1, 1);
    put(&s, 0, 1, 0.1, (double[]){0.25, 0.25}, (double[]){1, 0});
    put(&s, 1, 2, 0.1, (double[]){0.75, 0.25}, (double[]){0.3, 0});
    put(&s, 2, 2, 0.1, (double[]){0.75, 0.75}, (double[]){0.4, 0});
    const struct averages_found f = ask(&s, "x:0", 1e4, 0.02, "sampling");
    const struct averages_candidate *chain = candidate(&f, "sampling");
    UNIT_TRUE(refused(&f) && strstr(f.refusal, "where the chain goes"));
    UNIT_TRUE(chain->error < 0.02);
    UNIT_NEAR(chain->value, 0.5, 2 * chain->error);
    const struct averages_found g = ask(&s, "x:0", 1e4, 0.02, NULL);
    UNIT_TRUE(taken(&g, "events") && g.value < 0.35);
    scene_free(&s);
}

/* Two disks that fly up and down and drift to each other: for hundreds of
   seconds there is no collision, and no scatter; half the energy is never
   along x. */
static void test_columns(void)
{
    struct scene s;
    make_box(&s, 2, 1, 1);
    put(&s, 0, 1, 0.1, (double[]){0.25, 0.3}, (double[]){1e-3, 1});
    put(&s, 1, 2, 0.1, (double[]){0.75, 0.6}, (double[]){-1e-4, 0.7});
    const struct averages_found f = ask(&s, "pressure", 1e5, 0.01, NULL);
    UNIT_TRUE(!refused(&f));
    /* two disks in the end, whatever their masses: (12, eq:averages-two) */
    UNIT_NEAR(f.value, 1.0816704238714616, 1.5 * f.error * f.scale);
    scene_free(&s);
}

/* Two disks that hardly pass each other: blocks settle on either side, by
   eight errors from the middle. */
static void test_door(void)
{
    struct scene s;
    make_box(&s, 2, 1, 0.45);
    put(&s, 0, 1, 0.11, (double[]){0.3, 0.2}, (double[]){0.5, -0.4});
    put(&s, 1, 2, 0.11, (double[]){0.7, 0.2}, (double[]){0.2, 0.7});
    for (double e = 0.1; e > 0.02; e /= 3) {
        const struct averages_found f = ask(&s, "x:0", 3e4, e, NULL);
        UNIT_TRUE(refused(&f) || fabs(f.value - 0.5) <= 2 * f.error);
    }
    scene_free(&s);
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
    /* thirty years of it nobody pays for, and says so */
    const struct averages_found g = ask(&s, "x:20", 9.5e8, 0.01, NULL);
    UNIT_TRUE(refused(&g) && strstr(g.refusal, "too few to be sure of"));
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

/* Points thrown into a metre each, whose masses differ by a share. */
static void make_line(struct scene *s, size_t n, double share,
                      uint64_t seed)
{
    struct random r;
    random_seed(&r, seed);
    if (!scene_create(s, n))
        exit(1);
    s->contact = true;
    s->wall[0] = SCENE_HARD;
    s->high[0] = (double)n;
    for (size_t i = 0; i < n; ++i) {
        s->mass[i] = 1 + share * random_between(&r, -1, 1);
        s->position[i] = (double)i + random_between(&r, 0, 1);
        s->velocity[i] = random_between(&r, -1, 1);
        s->freedom[n + i] = s->freedom[2 * n + i] = 0;
    }
}

/* Eight masses that differ by a hundredth: a first look has the first body
   at 0.866(38) m, where the law of places has 0.889; a run of 30000 s has
   it at 0.935(12). A law that is a bet is not taken for the first look. */
static void test_bet(void)
{
    struct scene s;
    make_line(&s, 8, 0.01, 11);
    const struct averages_found f = ask(&s, "x:0", 3e4, 1e-3, NULL);
    UNIT_TRUE(refused(&f));
    UNIT_NEAR(candidate(&f, "order")->value, 8.0 / 9, 1e-12);
    UNIT_TRUE(candidate(&f, "order")->sure == AVERAGES_OUT);
    const struct averages_found g = ask(&s, "x:0", 3e4, 0.005, NULL);
    UNIT_TRUE(taken(&g, "events"));
    UNIT_NEAR(g.value, 0.935, 1.5 * (0.024 + g.error * g.scale));
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
            {"two alone on a line have the mean of their run", test_pairs},
            {"equal masses are looked at all over the time", test_beats},
            {"what throws have not seen is in their error", test_unseen},
            {"a run to the end is refused at its price", test_endless},
            {"a run that rounding decides is not believed", test_corner},
            {"a chain that goes where no motion goes is not believed",
             test_chain},
            {"disks that have not met are not believed", test_columns},
            {"disks that have not passed are not believed", test_door},
            {"two bodies have a pressure and no law of places",
             test_two_bodies},
            {"a law that a first look bears out may be wrong", test_bet},
            {"bodies of one speed are no springs", test_no_gas},
            {"steps are never taken for a pressure", test_steps},
            {0}});
}
