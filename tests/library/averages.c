/* Averages: laws, events and chains against numbers known from elsewhere,
   the stop at the tolerance, and refusals. */
#include "unit.h"

#include "library/galleries.h"
#include "choosing/models.h"
#include "library/asked.h"
#include "scenes/gallery.h"
#include "toolbox/random.h"

/* So many rods of different masses and radii between walls. */
static void make_rods(struct scene *s, size_t n, double first, double last)
{
    SEEDED(r, 5);
    UNIT_MUST(scene_create(s, n));
    s->contact = true;
    WALLS(*s, 0, SCENE_HARD, 1, 11);
    for (size_t i = 0; i < n; ++i) {
        s->mass[i] = 1 + (double)(i * i) / 4;
        s->radius[i] = 0.05 * (double)(1 + i % 3);
        s->position[i] =
            first + (last - first) * ((double)i + 0.5) / (double)n;
        s->velocity[i] = random_between(&r, -1, 1);
        s->freedom[n + i] = s->freedom[2 * n + i] = 0;
    }
}

/* The next collision of rods: gap i is left of body i; returns its time. */
static double next_gap(const struct scene *s, size_t *gap)
{
    const size_t n = s->bodies;
    double soonest = INFINITY;
    for (size_t i = 0; i <= n; ++i) {
        const double left =
            i > 0 ? s->position[i - 1] + s->radius[i - 1] : s->low[0];
        const double right =
            i < n ? s->position[i] - s->radius[i] : s->high[0];
        const double closing =
            (i > 0 ? s->velocity[i - 1] : 0) - (i < n ? s->velocity[i] : 0);
        const double t = closing > 0 ? (right - left) / closing : INFINITY;
        if (t < soonest) {
            soonest = t;
            *gap = i;
        }
    }
    return soonest < 0 ? 0 : soonest;
}

/* Lets the rods fly for a time and returns the impulse that both walls
   have given: an engine of the test's own. */
static double fly(struct scene *s, double until)
{
    const size_t n = s->bodies;
    double now = 0, impulse = 0;
    for (;;) {
        size_t i = 0;
        const double t = next_gap(s, &i);
        if (now + t > until)
            return impulse;
        now += t;
        for (size_t k = 0; k < n; ++k)
            s->position[k] += s->velocity[k] * t;
        if (i == 0 || i == n) {
            double *v = &s->velocity[i == 0 ? 0 : n - 1];
            impulse += 2 * s->mass[i == 0 ? 0 : n - 1] * fabs(*v);
            *v = -*v;
        } else {
            double *a = &s->velocity[i - 1], *b = &s->velocity[i];
            const double ma = s->mass[i - 1], mb = s->mass[i];
            const double mean = (ma * *a + mb * *b) / (ma + mb);
            *a = 2 * mean - *a;
            *b = 2 * mean - *b;
        }
    }
}

TEST(test_conserved, "what is conserved is its mean")
{
    MADE(scene, s, make_rods(&s, 4, 2, 10));
    double K = 0;
    for (size_t i = 0; i < 4; ++i)
        K += s.mass[i] * s.velocity[i] * s.velocity[i] / 2;
    struct averages_found f = ask(&s, "kinetic", 1, 1e-9, NULL);
    UNIT_TRUE(taken(&f, "conserved"));
    UNIT_NEAR(f.value, K, 1e-14 * K);
    UNIT_EQUAL(f.error, 0);
    f = ask(&s, "temperature", 1, 1e-9, NULL);
    UNIT_NEAR(f.value, 2 * K / 4, 1e-14 * K);
}

/* In a box without walls a drift is no heat, but energy it is. */
TEST(test_drift, "in a periodic box a drift is no heat")
{
    CREATED(scene, s, 3);
    s.contact = true;
    for (size_t i = 0; i < 3; ++i) {
        s.radius[i] = 0.1;
        s.mass[i] = 1 + (double)i;
        s.position[i] = s.position[3 + i] = 1 + (double)i;
        s.velocity[i] = i == 0 ? 3 : i == 1 ? 0 : -1; /* momentum 0 */
        s.freedom[6 + i] = 0;
    }
    for (size_t k = 0; k < 2; ++k) {
        s.wall[k] = SCENE_PERIODIC;
        s.high[k] = 6;
    }
    struct averages_found f = ask(&s, "temperature", 1, 1e-9, NULL);
    UNIT_NEAR(f.value, 2 * 6.0 / 6, 1e-15);
    for (size_t i = 0; i < 3; ++i)
        s.velocity[i] += 100;
    f = ask(&s, "temperature", 1, 1e-9, NULL);
    UNIT_NEAR(f.value, 2 * 6.0 / 6, 1e-12); /* 100 eps for each speed */
    f = ask(&s, "kinetic", 1, 1e-9, NULL);
    UNIT_NEAR(f.value, 6 + 3 * 100 * 100, 1e-10);
}

/* Every run, of two bodies or of many, shows Tonks's force to within the
   bound (eq:averages-bound): checked on an engine of the test's own. A time
   that is too short for the tolerance is refused. */
TEST(test_tonks, "every run shows Tonks's law to within its bound")
{
    for (size_t n = 1; n <= 6; ++n) {
        double K = 0, M = 0, radii = 0;
        const double T = 200;
        MADE(scene, s, make_rods(&s, n, 2, 10));
        for (size_t i = 0; i < n; ++i) {
            K += s.mass[i] * s.velocity[i] * s.velocity[i] / 2;
            M += s.mass[i];
            radii += s.radius[i];
        }
        const double free = 10 - 2 * radii,
                     room = 10 - s.radius[0] - s.radius[n - 1];
        const double bound = free * sqrt(M / (2 * K)) / T;
        const struct averages_found f =
            ask(&s, "pressure", T, 1.01 * bound, NULL);
        UNIT_TRUE(taken(&f, "tonks"));
        UNIT_EQUAL(f.sure, AVERAGES_BOUND);
        UNIT_NEAR(f.value, room / free, 1e-13);
        UNIT_NEAR(f.error, bound, 1e-13 * bound);
        const double force = fly(&s, T) / (2 * T);
        UNIT_NEAR(force * room / (2 * K), f.value, f.error * f.scale);
        const struct averages_found brief =
            ask(&s, "pressure", T, 0.99 * bound, NULL);
        UNIT_TRUE(refused(&brief) && strstr(brief.refusal, "ask for"));
    }
}

/* Two disks: 1.24017 in the end, as chapter 6 has it, and the middle of the
   box. But a mean over a short time is not known so well, whatever the law
   says, and none is given. */
TEST(test_two_disks, "two disks are near their law if there is time")
{
    FREED(scene) s = made("four-disks", "particles", 2);
    struct averages_found f = ask(&s, "pressure", 1e6, 0.004, NULL);
    UNIT_TRUE(taken(&f, "events") && f.error <= 0.004);
    UNIT_NEAR(f.value, 1.2401672, 1.5 * f.error * f.scale);
    UNIT_TRUE(refused((f = ask(&s, "pressure", 1e4, 1e-4, NULL), &f)));
    UNIT_TRUE(refused((f = ask(&s, "pressure", 10, 1e-3, NULL), &f)));
    UNIT_TRUE(refused((f = ask(&s, "y:1", 10, 1e-3, NULL), &f)));
    f = ask(&s, "y:1", 1e5, 0.02, NULL);
    UNIT_TRUE(taken(&f, "events"));
    UNIT_NEAR(f.value, 0.5, 1.5 * f.error);
}

/* Four disks: Z = 1.88926(13), from a Markov chain of 1e7 sweeps, by
   (5.8, eq:wall-virial). Twice the error is four standard errors. */
TEST(test_four_disks, "four disks have the pressure of the reference")
{
    FREED(scene) s = made("four-disks", NULL, 0);
    struct averages_found f = ask(&s, "pressure", 1e6, 0.01, "events");
    UNIT_TRUE(taken(&f, "events") && f.error <= 0.01 && f.error > 0.001);
    UNIT_NEAR(f.value, 1.88926, 2 * f.error * f.value);
    UNIT_TRUE(f.time > 100 && f.time < 1e5);
    f = ask(&s, "x:2", 1e6, 0.02, NULL);
    UNIT_TRUE(taken(&f, "events"));
    UNIT_NEAR(f.value, 0.5, 2 * f.error);
}

/* In a periodic box the centre of mass makes no pressure: 0.7 m/s more for
   all make no difference. The pressure of these two is that of the second
   virial coefficient to within a few per cent: (N - 1)/N of 2 pi r^2 N / V
   and higher terms. */
TEST(test_periodic, "in a periodic box the centre makes no pressure")
{
    FREED(scene) s = made("four-disks", "radius", 0.05);
    s.wall[0] = s.wall[1] = SCENE_PERIODIC;
    const struct averages_found a =
        ask(&s, "pressure", 1e5, 0.005, "events");
    for (size_t i = 0; i < 4; ++i)
        s.velocity[i] += 0.7;
    const struct averages_found b =
        ask(&s, "pressure", 1e5, 0.005, "events");
    UNIT_TRUE(!refused(&a) && !refused(&b));
    UNIT_NEAR(a.value, b.value, 1.5 * (a.error + b.error) * a.value);
    UNIT_NEAR(a.value, 1 + 3.14159265 * 0.0025 * 2 * 3, 0.02);
}

/* No more time than the tolerance needs, and more for more digits. */
TEST(test_stop, "no more is simulated than the tolerance needs")
{
    FREED(scene) s = made("four-disks", NULL, 0);
    const struct averages_found a =
        ask(&s, "pressure", 1e7, 0.02, "events");
    const struct averages_found b =
        ask(&s, "pressure", 1e7, 0.005, "events");
    UNIT_TRUE(!refused(&a) && !refused(&b));
    UNIT_TRUE(4 * a.time < b.time); /* sixteen times, were it exact */
    UNIT_TRUE(b.time < 1e5);
    UNIT_TRUE(4 * a.cost < b.cost);
}

/* An error of just the tolerance is small enough: who asks for the error
   of the first look gets that look again. */
TEST(test_just_enough, "an error of just the tolerance will do")
{
    FREED(scene) s = made("four-disks", NULL, 0);
    const struct averages_found a = ask(&s, "pressure", 1e7, 0.5, "events");
    const struct averages_found b =
        ask(&s, "pressure", 1e7, a.error, "events");
    UNIT_TRUE(!refused(&a) && a.error > 0);
    UNIT_TRUE(!refused(&b));
    UNIT_EQUAL(b.error, a.error);
    UNIT_EQUAL(b.time, a.time);
}

TEST(test_same_bits, "the same question has the same bits")
{
    FREED(scene) s = made("four-disks", NULL, 0);
    const struct averages_found a = ask(&s, "x:0", 1e5, 0.03, NULL);
    const struct averages_found b = ask(&s, "x:0", 1e5, 0.03, NULL);
    UNIT_EQUAL(a.value, b.value);
    UNIT_EQUAL(a.error, b.error);
    UNIT_EQUAL(a.time, b.time);
    UNIT_EQUAL(a.cost, b.cost);
}

/* Places on a line come to k/(n+1) of the free length, and the radii; but
   how near a mean over a time is to that, the run has to say. */
TEST(test_order, "places on a line come to their law, with an error")
{
    MADE(scene, s, make_rods(&s, 6, 2, 10));
    const double free = 10 - 2 * (0.05 + 0.1 + 0.15) * 2;
    const double law = 1 + 2 * (0.05 + 0.1) + 0.15 + free * 3 / 7;
    struct averages_found f = ask(&s, "x:2", 1e6, 0.01, NULL);
    UNIT_TRUE(taken(&f, "events") && f.error <= 0.01);
    UNIT_NEAR(f.value, law, f.error * f.scale);
    f = ask(&s, "x:2", 1e4, 1e-4, NULL);
    UNIT_TRUE(refused(&f));
    f = ask(&s, "x:2", 1e6, 0.01, "order");
    UNIT_TRUE(refused(&f) && strstr(f.refusal, "'order' is no way"));
}

/* Six rods that begin in a tenth of the box: the beginning does not
   count. */
TEST(test_squeezed, "a squeezed start does not count")
{
    MADE(scene, s, make_rods(&s, 6, 1, 3.4));
    const double law = 1 + 2 * (0.05 + 0.1) + 0.15 + 8.8 * 3 / 7;
    const struct averages_found f = ask(&s, "x:2", 1e6, 0.01, "events");
    UNIT_TRUE(taken(&f, "events"));
    UNIT_NEAR(f.value, law, 2 * f.error * 10);
}

TEST(test_radii, "radii move the places only")
{
    MADE(scene, s, make_rods(&s, 6, 2, 10));
    for (size_t i = 0; i < 6; ++i)
        s.radius[i] = 0;
    const struct averages_found points = ask(&s, "x:2", 1e6, 0.02, NULL);
    for (size_t i = 0; i < 6; ++i) {
        s.radius[i] = 0.25; /* a power of two: sums are exact */
        s.position[i] += 0.25 * (double)(2 * i + 1);
    }
    s.high[0] += 0.5 * 6;
    const struct averages_found rods = ask(&s, "x:2", 1e6, 0.02, NULL);
    UNIT_TRUE(taken(&points, "events") && taken(&rods, "events"));
    UNIT_NEAR(rods.value, points.value + 0.25 * 5,
              points.error * points.scale + rods.error * rods.scale);
}

/* A gas that begins in two fifths of its box, on a lattice: the pressure
   is that of the gas, 1.6207(5) by `disks`, chapter 7. */
TEST(test_burst, "a gas let out of a corner has its own pressure")
{
    const struct gallery_scene *g = gallery_find(hard_scenes, "gas");
    double value[GALLERY_KEYS];
    FREED(scene) s;
    gallery_usual(g, value);
    value[gallery_key(g, "width")] = 3;
    value[gallery_key(g, "lattice")] = 1;
    UNIT_MUST(!g->build(&s, value));
    s.high[0] = 7.5;
    const struct averages_found f = ask(&s, "pressure", 1e4, 0.01, NULL);
    UNIT_TRUE(taken(&f, "events"));
    UNIT_NEAR(f.value, 1.6207, 2 * f.error * f.value);
}

TEST(test_read, "names are read, and others refused")
{
    struct averages_quantity q;
    char message[AVERAGES_TEXT], symbol[32];
    FREED(scene) s = made("four-disks", NULL, 0);
    UNIT_TRUE(averages_read(&q, "y:3", &s, message));
    UNIT_EQUAL(q.body, 3);
    UNIT_EQUAL(q.axis, 1);
    UNIT_SAYS(averages_name(&q, symbol), "length");
    UNIT_SAYS(symbol, "y:3");
    UNIT_TRUE(averages_read(&q, "pressure", &s, message));
    UNIT_SAYS(averages_name(&q, symbol), "");
    static const char *const wrong[] = {"x:4",  "x:",   "x",      "z:1",
                                        "x:1,", "x:-1", "energy", ""};
    for (size_t k = 0; k < sizeof wrong / sizeof wrong[0]; ++k)
        UNIT_TRUE(!averages_read(&q, wrong[k], &s, message) &&
                  strstr(message, "pressure"));
}

static bool says(const struct scene *s, const char *name, const char *why)
{
    const struct averages_found f = ask(s, name, 10, 0.01, NULL);
    return refused(&f) && strstr(f.refusal, why);
}

TEST(test_refusals, "scenes without an average are refused")
{
    FREED(scene) s = made("four-disks", NULL, 0);
    s.restitution = 0.9;
    UNIT_TRUE(says(&s, "pressure", "loses energy"));
    s.restitution = 1;
    s.gravity[1] = -1;
    UNIT_TRUE(says(&s, "pressure", "no force"));
    s.gravity[1] = 0;
    s.k2 = 1;
    UNIT_TRUE(says(&s, "pressure", "no force"));
    s.k2 = 0;
    s.damping = 1;
    UNIT_TRUE(says(&s, "pressure", "no force"));
    s.damping = 0;
    s.wall[1] = SCENE_OPEN;
    UNIT_TRUE(says(&s, "pressure", "not closed"));
    s.wall[0] = s.wall[1] = SCENE_PERIODIC;
    UNIT_TRUE(says(&s, "x:0", "periodic"));
    s.wall[0] = s.wall[1] = SCENE_HARD;
    UNIT_TRUE(says(&s, "x:0", "does not settle"));
    UNIT_MUST(scene_add_kind(&s, 1, 0) && scene_add_spring(&s, 0, 1, 0, 1));
    UNIT_TRUE(says(&s, "pressure", "no force"));
    s.springs = 0;
    for (size_t i = 0; i < 8; ++i)
        s.velocity[i] = 0;
    UNIT_TRUE(says(&s, "pressure", "othing moves") ||
              says(&s, "pressure", "no force"));
    scene_free(&s);
    s = made("galperin", NULL, 0);
    UNIT_TRUE(says(&s, "x:1", "held"));
}

TEST(test_short, "too short a time is refused with a better one")
{
    FREED(scene) s = made("four-disks", NULL, 0);
    const struct averages_found f =
        ask(&s, "pressure", 1000, 1e-3, "events");
    UNIT_TRUE(refused(&f) && strstr(f.refusal, "need not"));
}

/* What is much too expensive is refused for little work: for a second by
   the price list, of a minute that is reasonable. */
TEST(test_dear, "what is much too expensive is refused at little cost")
{
    static const struct {
        const char *scene, *name;
        double tolerance;
    } asked[] = {{"gas", "pressure", 1e-5},
                 {"gas", "x:5", 0.005},
                 {"four-disks", "x:0", 1e-5},
                 {"four-disks", "pressure", 1e-6}};
    for (size_t k = 0; k < sizeof asked / sizeof asked[0]; ++k) {
        FREED(scene) s = made(asked[k].scene, NULL, 0);
        struct averages_request q = {.scene = &s,
                                     .until = 1e9,
                                     .tolerance = asked[k].tolerance,
                                     .budget = AVERAGES_BUDGET};
        struct averages_found f;
        char message[AVERAGES_TEXT];
        UNIT_TRUE(averages_read(&q.quantity, asked[k].name, &s, message));
        UNIT_TRUE(averages_find(&f, &q));
        UNIT_TRUE(refused(&f) && (strstr(f.refusal, "price list") ||
                                  strstr(f.refusal, "need not")));
        UNIT_TRUE(f.cost < 1);
    }
}

static struct scene locked(void)
{
    struct scene s;
    s = made("four-disks", NULL, 0);
    for (size_t i = 0; i < 4; ++i) {
        s.radius[i] = 0.22;
        s.position[i] = i % 2 ? 0.75 : 0.25;
        s.position[4 + i] = i / 2 ? 0.75 : 0.25;
    }
    return s;
}

/* Disks that cannot pass each other, and all the time in the world: that
   they keep their places is known long before the price is paid. */
TEST(test_locked, "disks that are locked in are refused at little cost")
{
    FREED(scene) s = locked();
    const struct averages_found f = ask(&s, "x:0", 1e9, 0.1, NULL);
    UNIT_TRUE(refused(&f) && strstr(f.refusal, "far from where"));
    UNIT_TRUE(f.cost < 0.5); /* of 5 */
}

TEST(test_offer, "the tolerance that is offered can be had")
{
    FREED(scene) s = made("four-disks", NULL, 0);
    struct averages_request q = {
        .scene = &s, .until = 1e9, .tolerance = 1e-5, .budget = 0.2};
    struct averages_found f;
    UNIT_TRUE(averages_find(&f, &q));
    const char *offer = refused(&f) ? strstr(f.refusal, "; ") : NULL;
    UNIT_TRUE(offer && strstr(offer, " fits"));
    q.tolerance = offer ? strtod(offer + 2, NULL) : 1;
    UNIT_TRUE(q.tolerance > 1e-5 && q.tolerance < 0.1);
    UNIT_TRUE(averages_find(&f, &q));
    UNIT_TRUE(!refused(&f) && f.error <= q.tolerance);
    UNIT_TRUE(f.cost < 0.3);
}

/* The mean over all of a time, from nearly this start. */
static double mean_of_run(const struct scene *start, double T, bool place)
{
    const struct models_plan plan = {
        .model = models_find(start->freedom[start->bodies] > 0 ? "disks"
                                                               : "line")};
    struct models_run r;
    FREED(scene) s;
    const char *why;
    double sum = 0, energy = 0;
    const int rows = 20000;
    UNIT_MUST(scene_copy(&s, start));
    for (size_t c = 0; c < 2 * s.bodies; ++c) {
        s.velocity[c] *= 1 + 1e-12 * (double)(c + 1);
        energy += s.mass[c % s.bodies] * s.velocity[c] * s.velocity[c] / 2;
    }
    UNIT_MUST(models_begin(&r, &plan, &s, T / rows, &why));
    for (int k = 0; k < rows && models_row(&r) == MODELS_DONE; ++k)
        sum += r.scene.position[0];
    const double Z = 1 + r.virial / (2 * energy * T);
    models_end(&r);
    return place ? sum / rows : Z;
}

/* Disks of one mass or of many, or a line, thrown. */
static void throw_scene(struct scene *s, size_t n, bool line, uint64_t seed)
{
    SEEDED(r, seed);
    UNIT_MUST(scene_create(s, n));
    s->contact = true;
    s->wall[0] = SCENE_HARD;
    s->wall[1] = line ? SCENE_OPEN : SCENE_HARD;
    s->high[0] = s->high[1] = 1;
    for (size_t i = 0; i < n; ++i) {
        s->mass[i] =
            line ? random_between(&r, 0.4, 1.6) : 1 + (double)(n % 4);
        s->radius[i] = line ? 0 : 0.3 / (double)n;
        s->position[i] = line ? ((double)i + 0.5) / (double)n
                              : 0.25 + 0.5 * (double)(i % 2);
        s->position[n + i] = line ? 0 : 0.25 + 0.5 * (double)(i / 2);
        s->velocity[i] = random_between(&r, -1, 1);
        s->velocity[n + i] = line ? 0 : random_between(&r, -1, 1);
        s->freedom[n + i] = !line;
        s->freedom[2 * n + i] = 0;
    }
}

/* Means over a time against runs of all that time, of many starts: not
   more than one in twenty is further off than its error, and on average a
   quarter of the square of the error at most. */
TEST(test_honest, "errors hold nineteen times out of twenty")
{
    static const struct {
        const char *name;
        size_t bodies;
        bool line;
        double until, tolerance;
    } asked[] = {{"pressure", 2, false, 1e3, 0.05},
                 {"pressure", 2, false, 2e4, 0.02},
                 {"pressure", 4, false, 3e3, 0.02},
                 {"x:0", 4, false, 1e4, 0.04},
                 {"x:0", 6, true, 1e4, 0.02}};
    double given = 0, beyond = 0, squares = 0;
    for (size_t k = 0; k < sizeof asked / sizeof asked[0]; ++k)
        for (uint64_t seed = 1; seed <= 40; ++seed) {
            FREED(scene) s;
            throw_scene(&s, asked[k].bodies, asked[k].line, seed);
            const struct averages_found f =
                ask(&s, asked[k].name, asked[k].until, asked[k].tolerance,
                    NULL);
            const double mean =
                mean_of_run(&s, asked[k].until, asked[k].name[0] == 'x');
            const double off = fabs(f.value - mean) / f.scale;
            if (refused(&f))
                continue;
            UNIT_TRUE(f.error <= asked[k].tolerance);
            given += 1;
            beyond += off > f.error;
            squares += off * off / (f.error * f.error);
        }
    UNIT_TRUE(given >= 120);
    UNIT_TRUE(beyond <= 0.05 * given);
    UNIT_TRUE(squares <= 0.25 * given);
}

/* Where events have seen all of the time, what they found and what is asked
   for are two means over it that know nothing of each other: the error has
   to cover their difference, whose variance is twice that of one. The
   scatter of one is that of 200 starts which differ by 1e-12, found within
   5 %. */
TEST(test_scatter, "errors cover what two runs differ by")
{
    enum { STARTS = 200 };
    const double T = 300;
    double sum = 0, squares = 0;
    FREED(scene) s = made("four-disks", NULL, 0);
    for (int k = 0; k < STARTS; ++k) {
        FREED(scene) t;
        UNIT_MUST(scene_copy(&t, &s));
        for (size_t c = 0; c < 8; ++c)
            t.velocity[c] *= 1 + 1e-12 * (double)(k * 8) * (double)(c + 1);
        const double Z = mean_of_run(&t, T, false);
        sum += Z;
        squares += Z * Z;
    }
    const double Z = sum / STARTS, variance = squares / STARTS - Z * Z;
    const double two = 2 * sqrt(2 * variance) / Z; /* standard errors */
    const double sure = two * (1 - 3 / sqrt(2.0 * STARTS));
    UNIT_TRUE(sure > 0.017);
    struct averages_found f = ask(&s, "pressure", T, 0.017, NULL);
    UNIT_TRUE(refused(&f));
    f = ask(&s, "pressure", T, 0.03, NULL);
    UNIT_TRUE(taken(&f, "events") && f.error > sure);
    UNIT_TRUE(f.time > 0.9 * T);
}

/* Two disks in a periodic box: one of them, seen from the other, is a point
   outside a disk of twice the radius, whose gas has the pressure
   energy/area. So Z = 1 + A/(2(1 - A)), A being the area of that
   disk: 1.50533 here. */
TEST(test_periodic_two, "two disks in a periodic box")
{
    CREATED(scene, s, 2);
    s.contact = true;
    for (size_t i = 0; i < 2; ++i) {
        s.wall[i] = SCENE_PERIODIC;
        s.high[i] = 1;
        s.radius[i] = 0.2;
        s.position[i] = 0.25 + 0.5 * (double)i;
        s.position[2 + i] = 0.3 + 0.37 * (double)i;
        s.velocity[i] = 1 - 1.3 * (double)i;
        s.velocity[2 + i] = 0.2 + 0.9 * (double)i;
        s.freedom[4 + i] = 0;
    }
    const double A = 3.14159265358979 * 0.4 * 0.4;
    const struct averages_found f = ask(&s, "pressure", 1e5, 0.01, NULL);
    UNIT_TRUE(taken(&f, "events"));
    UNIT_NEAR(f.value, 1 + A / (2 * (1 - A)), 2 * f.error * f.scale);
}
