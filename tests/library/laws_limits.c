/* Laws at the edges of what they are for, each number from its formula, and
   tests of a few samples by hand. */
#include "unit.h"

#include "line/laws.h"
#include "line/statistics.h"

#include <float.h>

static const double pi = 3.14159265358979324;

static struct law law_of(const char *text)
{
    struct law law = {0};
    const char *wrong = laws_read(text, &law);
    UNIT_TRUE(wrong == NULL);
    laws_complete(&law, 0, 1);
    return law;
}

/* Whether all texts of a list, with spaces between them, are read or
   refused; what is said of one that names a law begins with the name. */
static void each_text(const char *list, bool good)
{
    struct law law;
    char text[40];
    for (int length = 0; sscanf(list, "%39s%n", text, &length) == 1;
         list += length) {
        const size_t name = strcspn(text, ":,");
        const char *said = laws_read(text, &law);
        if (good != !said)
            printf("# %s\n", text);
        UNIT_TRUE(good == !said);
        if (said && text[name] == ':')
            UNIT_TRUE(strncmp(said, text, name) == 0 &&
                      strstr(said, " or ") != NULL);
    }
}

TEST(test_texts, "texts that just make sense, or just not")
{
    each_text("normal normal:-1,1e-300 microcanonical:2 "
              "microcanonical:1e9 microcanonical:2,1e-300,1e-300 "
              "beta:1,1 beta:1e9,1e9 beta:1,1,-1e-300,0 maxwell:1e-300 "
              "maxwell:1,1e-300 maxwell:1,1,1 maxwell:1,1,100",
              true);
    each_text("gauss normalx normal: normal:1 normal:0,0 normal:1,0 "
              "normal:1,2, normal:1,2,3 normal,1,2 normal:,1 normal:a,b "
              "microcanonical microcanonical:1 microcanonical:2.5 "
              "microcanonical:1000000001 microcanonical:10,6 "
              "microcanonical:2,0,1 microcanonical:2,1,0 "
              "microcanonical:2,1 microcanonical:10,-6,1 "
              "beta:1 beta:0,1 beta:0,3 beta:2,1 beta:4,3 beta:1,3, "
              "beta:1,1000000001 beta:1.5,2 beta:1,2.5 beta:1,1,0,0 "
              "beta:1,1,0 beta:1,3,2,2 beta:1,2,,3 beta:1,3x "
              "maxwell maxwell: maxwell:0 maxwell:1,0 maxwell:1,1,0 "
              "maxwell:1,1,1.5 maxwell:1,1,101 maxwell:1,1,1,1 "
              "maxwell:,1 maxwell:nan maxwell:inf",
              false);
    struct law law;
    UNIT_TRUE(laws_read("", &law) != NULL);
    UNIT_TRUE(strstr(laws_read("norma:1,2", &law), "beta:k,n") != NULL);
    UNIT_TRUE(strstr(laws_read("normals", &law), "beta:k,n") != NULL);
}

/* What is not given, in the order of the texts; how much comes from the
   column, of mean 3 and spread 2. */
TEST(test_completed, "what is not given")
{
    static const struct {
        const char *text;
        double from, p[4];
        size_t given;
    } laws[] = {{"normal", 2, {3, 2}, 2},
                {"normal:5,7", 0, {5, 7}, 2},
                {"microcanonical:10", 1, {10, 10 * 4 / 2.0, 1}, 3},
                {"microcanonical:10,6,0.5", 0, {10, 6, 0.5}, 3},
                {"beta:2,8", 0, {2, 8, 0, 1}, 4},
                {"beta:2,8,-1,5", 0, {2, 8, -1, 5}, 4},
                {"maxwell:3", 0, {3, 1, 0}, 3},
                {"maxwell:3,5", 0, {3, 5, 0}, 3},
                {"maxwell:3,5,2", 0, {3, 5, 2}, 3}};
    for (size_t i = 0; i < sizeof laws / sizeof laws[0]; ++i) {
        struct law law = {0};
        UNIT_TRUE(laws_read(laws[i].text, &law) == NULL);
        UNIT_EQUAL(laws_complete(&law, 3, 2), laws[i].from);
        UNIT_EQUAL(law.given, laws[i].given);
        for (size_t k = 0; k < law.given; ++k)
            UNIT_EQUAL(law.parameter[k], laws[i].p[k]);
    }
}

TEST(test_closed_forms, "points in closed form")
{
    static const struct {
        const char *text;
        double x, density, below, mean, sd;
    } points[] = {
        {"beta:1,8", 0, 8, 0, 1 / 9.0, 0},
        {"beta:8,8,2,4", 4, 4, 1, 2 + 2 * 8 / 9.0, 0},
        {"beta:2,3,2,4", 3, 0.75, 0.5, 3, 0},
        {"beta:2,3,2,4", 2, 0, 0, 3, 0},
        {"beta:2,3,2,4", 1.5, 0, 0, 3, 0},
        {"beta:2,3,2,4", 4.5, 0, 1, 3, 0},
        {"microcanonical:3,6,1", -3.5, 0, 0, 0, 2},
        {"microcanonical:3,6,1", 3.5, 0, 1, 0, 2},
        {"microcanonical:3,6,1", 1, 1 / (2 * 3.4641016151377546), 0, 0, 2},
        {"microcanonical:3,6,4", -1, 1 / 3.4641016151377546, 0, 0, 1},
        {"maxwell:2,3,1", 0, 0.97720502380583984, 0, 0, 0},
        {"maxwell:2,3,2", 0, 0, 0, 0, 0},
        {"maxwell:2,3,2", -1, 0, 0, 0, 0},
        {"maxwell:2,3,1", -1, 0, 0, 0, 0},
        {"maxwell:2,3,2", 2, 3 * 0.04978706836786394, 0.950212931632136, 0,
         0}};
    for (size_t i = 0; i < sizeof points / sizeof points[0]; ++i) {
        const struct law law = law_of(points[i].text);
        UNIT_NEAR(laws_density(&law, points[i].x), points[i].density,
                  1e-13);
        if (points[i].below > 0 || points[i].density == 0 ||
            points[i].x == 0)
            UNIT_NEAR(laws_below(&law, points[i].x), points[i].below,
                      1e-14);
        if (points[i].mean > 0)
            UNIT_NEAR(laws_mean(&law), points[i].mean, 1e-14);
        if (points[i].sd > 0) {
            UNIT_NEAR(laws_sd(&law), points[i].sd, 1e-14);
            UNIT_EQUAL(laws_mean(&law), 0);
        }
    }
    /* Speeds in one, two and three dimensions of m = 3 at kT = 2. */
    const double a = 2 / 3.0;
    const double mean[] = {sqrt(2 * a / pi), sqrt(pi * a / 2),
                           sqrt(8 * a / pi)};
    for (int d = 1; d <= 3; ++d) {
        char text[32];
        snprintf(text, sizeof text, "maxwell:2,3,%d", d);
        const struct law law = law_of(text);
        UNIT_NEAR(laws_mean(&law), mean[d - 1], 1e-14);
        UNIT_NEAR(laws_sd(&law), sqrt(d * a - mean[d - 1] * mean[d - 1]),
                  1e-14);
    }
    const struct law component = law_of("maxwell:2,3");
    UNIT_EQUAL(laws_mean(&component), 0);
    UNIT_NEAR(laws_sd(&component), sqrt(a), 1e-15);
    UNIT_NEAR(laws_below(&component, sqrt(a)), 0.84134474606854293, 1e-15);
    UNIT_NEAR(laws_density(&component, 0), 1 / sqrt(2 * pi * a), 1e-15);
}

TEST(test_kolmogorov, "Kolmogorov's function from both of its sums")
{
    for (double l = 0.3; l < 3; l += 0.05) {
        double far = 0, near = 0;
        for (int k = 1; k < 40; ++k) {
            const double odd = 2 * k - 1;
            far += (k % 2 ? 2 : -2) * exp(-2 * k * k * l * l);
            near += exp(-odd * odd * pi * pi / (8 * l * l));
        }
        near = 1 - sqrt(2 * pi) / l * near;
        UNIT_NEAR(laws_kolmogorov(l), l < 1 ? near : far, 1e-15);
        UNIT_NEAR(near, far, 1e-13);
    }
    UNIT_EQUAL(laws_kolmogorov(-1), 1);
}

/* 14 samples of a flat law in three blocks of 4: the scatter of the counts
   is that of the first twelve, chi-square that of all. Fitted numbers cost
   their share of the degrees. */
TEST(test_blocks, "samples in blocks, by hand")
{
    static const double samples[] = {.01, .02, .26, .99, .03, .27, .28,
                                     .97, .04, .01, .29, 1,   .51, .52};
    double *x = malloc(sizeof samples), count[3 * LAW_CELLS] = {0},
           all[LAW_CELLS] = {0}, chi2 = 0, distance = 0;
    UNIT_MUST(x);
    memcpy(x, samples, sizeof samples);
    const struct law flat = law_of("beta:1,1");
    for (size_t i = 0; i < 14; ++i) {
        const size_t cell = samples[i] < 1 ? (size_t)(samples[i] * 20) : 19;
        ++all[cell];
        if (i < 12)
            ++count[i / 4 * LAW_CELLS + cell];
        /* The share of samples below and up to this one. */
        double less = 0, most = 0;
        for (size_t k = 0; k < 14; ++k) {
            less += samples[k] < samples[i];
            most += samples[k] <= samples[i];
        }
        distance = fmax(
            distance, fmax(samples[i] - less / 14, most / 14 - samples[i]));
    }
    for (size_t k = 0; k < LAW_CELLS; ++k)
        chi2 += (all[k] - 0.7) * (all[k] - 0.7) / 0.7;
    const struct statistics_scatter s =
        statistics_scatter(3, LAW_CELLS, count, 4.0 / LAW_CELLS);
    UNIT_TRUE(s.scale != 1 && s.degrees < 19);
    for (size_t fitted = 0; fitted < 3; ++fitted)
        for (size_t block = 0; block < 6; ++block) {
            struct law_test t;
            const bool measured = block == 4;
            UNIT_TRUE(laws_test(&flat, 14, x, 2, block, fitted, &t));
            if (block == 2 || block == 3)
                continue; /* other blocks than those counted here */
            UNIT_NEAR(t.chi2, chi2 / (measured ? s.scale : 1), 1e-12);
            UNIT_NEAR(t.degrees,
                      (measured ? s.degrees : 19) * (19 - (double)fitted) /
                          19,
                      1e-13);
            UNIT_NEAR(t.chi2_probability, laws_chi2(t.chi2, t.degrees), 0);
            UNIT_NEAR(t.distance, distance, 1e-15);
            const double root = sqrt(7);
            if (fitted)
                UNIT_TRUE(isnan(t.distance_probability));
            else
                UNIT_NEAR(
                    t.distance_probability,
                    laws_kolmogorov(distance * (root + .12 + .11 / root)),
                    1e-15);
        }
    free(x);
}
