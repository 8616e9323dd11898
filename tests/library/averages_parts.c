/* What averages are made of, each part by itself against what is found by
   hand: scales and laws, how often a run is looked at, when it has settled,
   how much longer it has to go on, and what is said if that is too long. */
#include "unit.h"

#include <choosing/averages.c> /* of src: most of its parts are private */

#include "library/heap.h"
#include "toolbox/random.h"

static struct averages_request request;
static struct averages_found found;

/* Rods of 1, 2 and 5 kg between walls at 1 and 11 m, from left to right the
   second, the third and the first. */
static struct scene rods(void)
{
    struct scene s;
    UNIT_TRUE(scene_create(&s, 3));
    s.contact = true;
    for (size_t i = 0; i < 3; ++i) {
        s.mass[i] = (const double[]){1, 2, 5}[i];
        s.radius[i] = (const double[]){0.25, 0.5, 0.75}[i];
        s.position[i] = (const double[]){9, 3, 6}[i];
        s.velocity[i] = (const double[]){4, -2, 2}[i];
        s.freedom[3 + i] = s.freedom[6 + i] = 0;
    }
    WALLS(s, 0, SCENE_HARD, 1, 11);
    return s;
}

/* A search in a scene, which has nothing against it. */
static struct search begin(const struct scene *s, enum averages_kind kind,
                           size_t body, size_t axis)
{
    request = (struct averages_request){
        .scene = s, .until = 100, .tolerance = 0.01, .budget = 60};
    request.quantity = (struct averages_quantity){kind, body, axis};
    found = (struct averages_found){.sure = AVERAGES_OUT};
    struct search h = {.q = &request, .f = &found, .s = s};
    UNIT_TRUE(survey(&h) == NULL);
    return h;
}

/* Energy 8 + 4 + 10 J, free length 10 - 3 m. In the end the gaps are alike:
   7/4 m each. */
TEST(test_line, "rods on a line")
{
    FREED(scene) s = rods();
    struct search h = begin(&s, AVERAGES_PLACE, 0, 0);
    UNIT_TRUE(h.n == 3 && h.axis == 0 && h.dimensions == 1 && !h.periodic);
    UNIT_TRUE(h.energy == 22 && h.mass == 8 && h.radii == 1.5 && !h.equal);
    UNIT_EQUAL(settled_place(&h, 1), 1 + 1.75 + 0.5);
    UNIT_EQUAL(settled_place(&h, 2), 1 + 1.75 + 1 + 1.75 + 0.75);
    UNIT_EQUAL(settled_place(&h, 0), 11 - 1.75 - 0.25);
    UNIT_EQUAL(scale_of(&h, 3), 10);
    /* sqrt(kT/m) = sqrt(44/3), 16 times in 10 m, 100 s. */
    UNIT_EQUAL(samples_of(&h), ceil(160 * sqrt(44 / 3.0)));
    request.quantity.body = 2;
    UNIT_EQUAL(samples_of(&h), ceil(160 * sqrt(44 / 15.0)));
    request.until = 1;
    UNIT_EQUAL(samples_of(&h), 256);
    struct measurement w = {.h = &h};
    choose_witnesses(&w);
    UNIT_TRUE(w.places == 3 && w.body[0] == 2 && w.body[1] == 0 &&
              w.body[2] == 1);
    UNIT_NEAR(relaxation(&h, s.velocity),
              (16 * 16 + 8 * 8 + 20 * 20) / (44.0 * 44) * 5 / 3, 1e-15);
    request.quantity.axis = 1;
    UNIT_SAYS(survey(&h), "nothing moves along this axis");
}

/* Tonks: (10 - 0.5 - 0.25)/7, off by at most 7 sqrt(8/44)/t. */
TEST(test_tonks, "Tonks's law")
{
    FREED(scene) s = rods();
    struct search h = begin(&s, AVERAGES_PRESSURE, 0, 0);
    UNIT_EQUAL(scale_of(&h, 3), 3);
    UNIT_EQUAL(scale_of(&h, -3), 3);
    UNIT_EQUAL(scale_of(&h, 0.5), 1);
    request.tolerance = 0.03;
    answer_tonks(&h);
    UNIT_EQUAL(found.sure, AVERAGES_BOUND);
    UNIT_NEAR(found.value, 9.25 / 7, 1e-15);
    UNIT_NEAR(found.error, 7 * sqrt(8 / 44.0) / 100, 1e-15);
    UNIT_TRUE(found.refusal[0] == '\0');
    request.tolerance = 0.0298; /* it is 0.029848 */
    answer_tonks(&h);
    UNIT_SAYS(found.refusal,
              "a run of 100 s may be off by 0.03 from the law that "
              "long runs obey; ask for that, or for 110 s");
}

TEST(test_rounded_up, "two digits, upwards")
{
    static const double known[][2] = {
        {0.0298, 0.03}, {0.0291, 0.03}, {0.02901, 0.03}, {1.01, 1.1},
        {100.2, 110},   {99.2, 100},    {3.5, 3.5}};
    for (size_t k = 0; k < sizeof known / sizeof *known; ++k)
        UNIT_NEAR(round_up(known[k][0]), known[k][1], 1e-13 * known[k][1]);
}

/* Disks of 1, 1 and 3 kg in a box of 4 by 9 m. */
static struct scene disks(enum scene_wall wall)
{
    struct scene s;
    UNIT_TRUE(scene_create(&s, 3));
    s.contact = true;
    for (size_t i = 0; i < 3; ++i) {
        s.mass[i] = i < 2 ? 1 : 3;
        s.radius[i] = 0.25;
        s.position[i] = 1 + (double)i;
        s.position[3 + i] = 1 + (double)i;
        s.velocity[i] = (const double[]){3, 1, 1}[i];
        s.velocity[3 + i] = (const double[]){-4, 0, 2}[i];
        s.freedom[6 + i] = 0;
    }
    for (size_t k = 0; k < 2; ++k) {
        s.wall[k] = wall;
        s.low[k] = -1;
        s.high[k] = k == 0 ? 3 : 8;
    }
    return s;
}

/* Along x 9 + 1 + 3 J, along y 16 + 12, twice; of that the centre has, with
   7 and 2 kg m/s, 49/5 and 4/5. */
TEST(test_plane, "disks in the plane")
{
    FREED(scene) s = disks(SCENE_HARD);
    struct search h = begin(&s, AVERAGES_PRESSURE, 0, 0);
    UNIT_TRUE(h.dimensions == 2 && h.box[0] == 4 && h.box[1] == 9);
    UNIT_EQUAL(h.energy, 20.5);
    UNIT_NEAR(relaxation(&h, s.velocity), 13 / 20.5, 1e-15);
    /* A quarter of sqrt(36/3) m at sqrt(kT/m), kT = 41/6, m = 5/3. */
    request.until = 1000;
    UNIT_EQUAL(samples_of(&h),
               ceil(1000 / (sqrt(12) / 4) * sqrt(41 / 6.0 / (5 / 3.0))));
    struct measurement w = {.h = &h};
    choose_witnesses(&w);
    UNIT_EQUAL(w.places, 0);
    h = begin(&s, AVERAGES_PLACE, 1, 1);
    UNIT_EQUAL(scale_of(&h, 7), 9);
    UNIT_EQUAL(settled_place(&h, 1), 3.5);
    UNIT_EQUAL(samples_of(&h), ceil(100 / (9.0 / 16) * sqrt(41 / 6.0)));
    choose_witnesses(&w); /* those that are like it */
    UNIT_TRUE(w.places == 2 && w.body[0] == 1 && w.body[1] == 0);
    h = begin(&s, AVERAGES_KINETIC, 0, 0);
    UNIT_EQUAL(scale_of(&h, 7), 7);
    answer_conserved(&h);
    UNIT_EQUAL(found.sure, AVERAGES_EXACT);
    UNIT_EQUAL(found.value, 20.5);
    h = begin(&s, AVERAGES_TEMPERATURE, 0, 0);
    answer_conserved(&h);
    UNIT_NEAR(found.value, 41 / 6.0, 1e-15);
    scene_free(&s);
    s = disks(SCENE_PERIODIC);
    h = begin(&s, AVERAGES_TEMPERATURE, 0, 0);
    UNIT_NEAR(h.energy, 20.5 - 5.3, 1e-14);
    UNIT_NEAR(relaxation(&h, s.velocity), (13 - 9.8) / (20.5 - 5.3), 1e-14);
    answer_conserved(&h);
    UNIT_NEAR(found.value, 2 * (20.5 - 5.3) / 6, 1e-14);
    h = begin(&s, AVERAGES_KINETIC, 0, 0);
    answer_conserved(&h);
    UNIT_EQUAL(found.value, 20.5);
}

/* A watch that has seen a share of all samples, for an error by hand. */
static struct measurement watch_of(const struct search *h, double share)
{
    struct measurement w = {
        .h = h, .most = 64 / share, .first = 3, .mean = 2};
    w.blocks.count = 32;
    w.blocks.per = 2;
    w.se = 0.01;
    w.interval = 0.5;
    return w;
}

/* A quarter of what was seen counts with its own mean, the rest of the time
   with that of the three quarters; the error has what was not seen, too:
   (1 - q)^2 + 3 q^2 + 3 s/4 for q = s/4. */
TEST(test_concluded, "what a run says of all the time")
{
    FREED(scene) s = rods();
    struct search h = begin(&s, AVERAGES_PRESSURE, 0, 0);
    static const double shares[] = {1, 0.5, 0.125};
    for (size_t k = 0; k < 3; ++k) {
        const double share = shares[k], q = share / 4;
        const struct measurement w = watch_of(&h, share);
        UNIT_EQUAL(fraction_run(&w), share);
        conclude(&found, &w);
        UNIT_NEAR(found.value, 3 * q + 2 * (1 - q), 1e-15);
        UNIT_NEAR(found.error,
                  2 * 0.01 *
                      sqrt((1 - q) * (1 - q) + 3 * q * q + 0.75 * share) /
                      found.value,
                  1e-15);
    }
}

/* Two standard errors are 0.01 of the value. An error that falls with the
   root of the time, but for that of the time T, has to go on 1/(e^2 -
   s/...) times as long; by a quarter at least; by twice if it has not
   settled. */
TEST(test_lengthened, "how much longer it takes")
{
    FREED(scene) s = rods();
    struct search h = begin(&s, AVERAGES_PRESSURE, 0, 0);
    struct measurement w = watch_of(&h, 0.125);
    const double square = 1e-4, scatter = 0.75 * 0.125 * square;
    UNIT_NEAR(longer_by(&w, 0.005), square / (2.5e-5 - scatter), 1e-10);
    UNIT_EQUAL(longer_by(&w, 0.05), 1.25);
    UNIT_TRUE(isinf(longer_by(&w, 0.999 * sqrt(2 * scatter))));
    UNIT_NEAR(longer_by(&w, 1.001 * sqrt(2 * scatter)),
              square / (1.001 * 1.001 * 2 * scatter - scatter), 1e-9);
    w.why = "so";
    UNIT_NEAR(longer_by(&w, 0.005), 4, 1e-12);
    UNIT_EQUAL(longer_by(&w, 0.05), 2);
    UNIT_NEAR(longer_by(&w, 1e-4), 1e4, 1e-8);
}

/* A first look, at 256 samples, gives a price: once it has settled, half as
   much again may be spent. */
TEST(test_gone_on, "a price that is not too much is paid")
{
    for (int place = 0; place < 2; ++place) {
        FREED(scene) s = disks(SCENE_HARD);
        s.position[2] = 2.5;
        struct search h =
            begin(&s, place ? AVERAGES_PLACE : AVERAGES_PRESSURE, 2, place);
        double price = INFINITY;
        request.until = 1e5;
        request.tolerance = place ? 0.01 : 0.001;
        for (int k = 0; k < 3; ++k) {
            struct measurement w;
            UNIT_MUST(!begin_measurement(&w, &h));
            request.budget =
                price / (place ? 1 : 1.5) * (k == 1 ? 1.01 : 0.99);
            w.run.limit = request.budget;
            UNIT_MUST(k ? go_on_until_sure(&found, &w) : advance(&w, 256));
            if (k == 0) {
                UNIT_EQUAL(w.why != NULL, place);
                price = cost(&w) * longer_by(&w, request.tolerance);
            }
            UNIT_EQUAL(w.run.rows > 256, k == 1);
            models_end(&w.run);
            blocks_free(&w.blocks);
        }
    }
}

/* Refusals: with what would fit, or without. */
TEST(test_refusals, "why it is not enough")
{
    FREED(scene) s = rods();
    struct search h = begin(&s, AVERAGES_PRESSURE, 0, 0);
    struct measurement w = watch_of(&h, 0.5);
    char text[AVERAGES_REFUSAL];
    request.tolerance = 0.005;
    w.run.rows = 64;
    w.run.work[MODELS_ROW] = 2 / 40e-9; /* 2 s so far, of 60 */
    /* At least 1.2 0.01 sqrt(0.75) = 0.0104; paid: 0.01 sqrt(6/60). */
    refuse(text, &w);
    UNIT_SAYS(text, "the mean over 100 s may be off by more than "
                    "0.005, that over 4.3e+02 s need not; 0.011 fits");
    request.tolerance = 0.009; /* 1e-4/(8.1e-5 - 3.75e-5) = 2.299 */
    refuse(text, &w);
    UNIT_SAYS(text, "0.009 would cost about 4.6 s by the price list, "
                    "of 60 that are reasonable; 0.011 fits");
    w.run.rows = 128;
    w.most = 128; /* all of the time: 1.2 0.01 sqrt(1.5 0.5) */
    refuse(text, &w);
    UNIT_SAYS(text, "the mean over 100 s may be off by more than "
                    "0.009, that over 1.3e+02 s need not; 0.011 fits");
    w.se = 0.3;
    refuse(text, &w);
    UNIT_TRUE(strstr(text, "; no tolerance fits") != NULL);
    w.se = 0.01;
    w.why = "it moves";
    refuse(text, &w);
    UNIT_SAYS(text, "it does not settle in 64 s: it moves; ask for a "
                    "longer time, or for the rows of a run");
    w.run.rows = 64;
    refuse(text, &w);
    UNIT_SAYS(text, "it does not settle in 32 s: it moves; to go on "
                    "costs at least 4 s by the price list, of 60 "
                    "that are reasonable");
}

static double noise(size_t i) /* number i of those drawn by a seed */
{
    static double drawn[1024];
    SEEDED(r, 3);
    for (size_t k = 0; k < 1024 && drawn[1023] == 0; ++k)
        drawn[k] = random_between(&r, -0.5, 0.5);
    return drawn[i];
}

/* A steady value; one whose first quarter does not count; one that rises;
   one of which sixteen samples are alike. */
enum value { STEADY, JUMP, SLOPE, ALIKE };

static double value_of(enum value kind, size_t i)
{
    return kind == JUMP && i < 64
               ? 77
               : 2 + 0.1 * noise(kind == ALIKE ? i / 48 : i) +
                     (kind == SLOPE ? 0.1 * (double)i / 256 : 0);
}

/* Fills blocks of one sample with a value in column 0 and, in the last,
   what is left of the start. */
static void fill(struct measurement *w, size_t n, enum value kind,
                 double left)
{
    blocks_free(&w->blocks);
    UNIT_TRUE(blocks_create(&w->blocks, w->columns));
    for (size_t i = 0; i < n; ++i) {
        double x[3] = {value_of(kind, i), 0, 0};
        x[w->columns - 1] = left + 0.2 * noise(i + 512);
        blocks_add(&w->blocks, x);
    }
}

/* What a run of 256 samples says of itself. */
TEST(test_settled, "when a run has settled")
{
    FREED(scene) s = disks(SCENE_HARD);
    struct search h = begin(&s, AVERAGES_PRESSURE, 0, 0);
    struct measurement w = {
        .h = &h, .most = 1000, .columns = 2, .why = "no run"};
    struct statistics_blocking b;
    double x[BLOCKS_MOST];
    UNIT_TRUE(blocks_create(&w.blocks, 2));
    fill(&w, 63, STEADY, 1);
    UNIT_TRUE(judge(&w) && strcmp(w.why, "no run") == 0); /* too few */
    fill(&w, 256, STEADY, 1);
    UNIT_TRUE(judge(&w) && !w.why);
    if (w.why)
        printf("# %s\n", w.why);
    UNIT_NEAR(w.mean, 2, 0.01); /* 0.1/sqrt(12 192) is 0.002 */
    const double mean = w.mean;
    double sum = 0;
    for (size_t i = 64; i < 256; ++i)
        sum += x[i - 64] = value_of(STEADY, i);
    UNIT_NEAR(w.mean, sum / 192, 1e-14);
    /* One standard error, and twice what is not known of that. */
    UNIT_TRUE(statistics_blocking(192, x, &b));
    UNIT_NEAR(w.se, b.error + 2 * b.level[b.chosen].uncertainty, 1e-17);
    fill(&w, 256, JUMP, 1);
    UNIT_TRUE(judge(&w) && !w.why);
    UNIT_EQUAL(w.first, 77);
    UNIT_EQUAL(w.mean, mean);
    fill(&w, 256, SLOPE, 1);
    UNIT_TRUE(judge(&w) && w.why);
    fill(&w, 256, ALIKE, 1);
    UNIT_TRUE(judge(&w) && w.why &&
              strcmp(w.why, "long blocks still remember each other") == 0);
    /* Off by 0.1, of a standard error of 0.2/sqrt(12 192) = 0.0042. */
    fill(&w, 256, STEADY, 1.1);
    UNIT_TRUE(judge(&w) && w.why &&
              strcmp(w.why, "velocities still remember the start") == 0);
    blocks_free(&w.blocks);
}

/* Without memory for the error of the mean a look fails. It is the third
   request: the first two are for errors that nobody asks for. */
TEST(test_look_without_memory, "no memory for a look")
{
    FREED(scene) s = disks(SCENE_HARD);
    struct search h = begin(&s, AVERAGES_PRESSURE, 0, 0);
    struct measurement w = {.h = &h, .most = 1000, .columns = 2};
    UNIT_TRUE(blocks_create(&w.blocks, 2));
    fill(&w, 64, STEADY, 1);
    heap_failing = 2;
    const bool well = judge(&w), refused = heap_failing < 0;
    heap_failing = -1;
    UNIT_TRUE(well != refused);
    UNIT_TRUE(judge(&w));
    blocks_free(&w.blocks);
}

/* Places have to come to where they end up: what is asked for, and all that
   are alike in the root of the mean square. */
TEST(test_places, "places come to their own")
{
    FREED(scene) s = disks(SCENE_HARD);
    struct search h = begin(&s, AVERAGES_PLACE, 0, 0); /* to 1 m */
    struct measurement w = {.h = &h, .most = 1000};
    choose_witnesses(&w);
    w.columns = w.places + 1;
    UNIT_TRUE(w.columns == 3 && blocks_create(&w.blocks, 3));
    for (size_t i = 0; i < 8; ++i)
        blocks_add(&w.blocks, (double[]){i < 2 ? 50 : 1.3, 1.4, 1});
    UNIT_NEAR(distance_from_law(&w, 2), sqrt((0.09 + 0.16) / 2), 1e-14);
    blocks_free(&w.blocks);
    UNIT_TRUE(blocks_create(&w.blocks, 3));
    for (size_t i = 0; i < 8; ++i)
        blocks_add(&w.blocks, (double[]){0.6, 0.9, 1});
    UNIT_NEAR(distance_from_law(&w, 2), 0.4, 1e-14);
    blocks_free(&w.blocks);
}
