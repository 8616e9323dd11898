/* The suite of exercise 06c: equal disks, equal spheres, unequal ones, a
   chord behind a centre, where the zones end, touching and overlapping, the
   potential, and how fast the overlap grows. */

#include "examiner/check.h"
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

double depletion(int dimensions, double R1, double R2, double small,
                 double density, double r, double *overlap);

struct pair {
    int dimensions;
    double R1, R2, small, density, r;
};

/* What the student's function answers; an untouched place reads as NaN. */
struct answer {
    double potential, overlap;
};

static struct answer answer(struct pair p)
{
    struct answer a = {NAN, NAN};
    a.potential = depletion(p.dimensions, p.R1, p.R2, p.small, p.density,
                            p.r, &a.overlap);
    return a;
}

static const char *input(struct pair p)
{
    return check_text("%d dimensions, R1 = %g m, R2 = %g m, small = %g m, "
                      "density = %g m^-%d, r = %.10g m",
                      p.dimensions, p.R1, p.R2, p.small, p.density,
                      p.dimensions, p.r);
}

static const double pi = 3.14159265358979323846;

/* What is cut off a zone by a chord at the distance c from its centre. */
static double part(int dimensions, double zone, double c)
{
    const double s = sqrt(fmax(0.0, (zone - c) * (zone + c)));
    return dimensions == 2
               ? zone * zone * atan2(s, c) - c * s
               : pi * (zone - c) * (zone - c) * (2.0 * zone + c) / 3.0;
}

/* The distance of the chord from the centre of the zone a. */
static double chord(double a, double b, double r)
{
    return 0.5 * (r + (a - b) * (a + b) / r);
}

static double shared(int dimensions, double a, double b, double r)
{
    if (r >= a + b)
        return 0.0;
    return part(dimensions, a, chord(a, b, r)) +
           part(dimensions, b, chord(b, a, r));
}

static double exact(struct pair p)
{
    return shared(p.dimensions, p.R1 + p.small, p.R2 + p.small, p.r);
}

/* The slips, each worked out for the pair at hand. */

static double one_part(struct pair p)
{
    const double a = p.R1 + p.small, b = p.R2 + p.small;
    return part(p.dimensions, a, chord(a, b, p.r));
}

static double in_the_middle(struct pair p)
{
    return part(p.dimensions, p.R1 + p.small, 0.5 * p.r) +
           part(p.dimensions, p.R2 + p.small, 0.5 * p.r);
}

static double small_diameter(struct pair p)
{
    return shared(p.dimensions, p.R1 + 2.0 * p.small, p.R2 + 2.0 * p.small,
                  p.r);
}

static double sectors(struct pair p)
{
    const double a = p.R1 + p.small, b = p.R2 + p.small;
    return a * a * acos(chord(a, b, p.r) / a) +
           b * b * acos(chord(b, a, p.r) / b);
}

/* Each piece as if the chord were always between the centre and the edge.
 */
static double never_behind(struct pair p)
{
    const double a = p.R1 + p.small, b = p.R2 + p.small;
    return part(p.dimensions, a, fabs(chord(a, b, p.r))) +
           part(p.dimensions, b, fabs(chord(b, a, p.r)));
}

/* The area of the lens whatever the dimensions. */
static double flat(struct pair p)
{
    p.dimensions = 2;
    return exact(p);
}

/* The formula of equal bodies, with the mean of the two radii. */
static double mean_radius(struct pair p)
{
    const double mean = 0.5 * (p.R1 + p.R2) + p.small;
    return shared(p.dimensions, mean, mean, p.r);
}

/* The polynomial of the spheres goes on where the zones have ended. */
static double goes_on(struct pair p)
{
    const double a = p.R1 + p.small, b = p.R2 + p.small, t = a + b - p.r;
    return p.dimensions == 2 ? NAN /* the acos of more than 1 */
                             : pi * t * t *
                                   (p.r * p.r + 2.0 * p.r * (a + b) -
                                    3.0 * (a - b) * (a - b)) /
                                   (12.0 * p.r);
}

/* An overlap is a difference of sectors and triangles, or of terms of the
   size of a ball: their rounding is a few epsilons of the whole zones. A
   chord's distance is rounded too, and acos and the root multiply that by
   zone/s where the lens is thin. */
static double tolerance(struct pair p)
{
    const double a = p.R1 + p.small, b = p.R2 + p.small;
    const double c = chord(a, b, p.r), s2 = (a - c) * (a + c);
    const double zones = a * a + b * b, thin = fmin(a, b);
    if (p.r >= a + b)
        return 0.0;
    return 16.0 * DBL_EPSILON *
           (p.dimensions == 2 ? zones * (1.0 + sqrt(zones / s2))
                              : zones * sqrt(zones) * sqrt(zones) / thin);
}

static const char because[] =
    "16 epsilons of the zones, more where the lens is thin";

static bool check_overlap(struct pair p, double expected,
                          const char *question)
{
    return CHECK_NEAR(
        answer(p).overlap, .quantity = "what the two zones share, *overlap",
        .unit = p.dimensions == 2 ? "m^2" : "m^3", .input = input(p),
        .expected = expected, .tolerance = tolerance(p), .because = because,
        .equation = p.dimensions == 2 ? "eq:lens" : "eq:lens3",
        .question = question,
        .mistakes = {
            {"area-for-volume", flat(p),
             "This is the area of a lens in the plane. How many dimensions "
             "were asked for?"},
            {"chord-in-the-middle", in_the_middle(p),
             "The chord lies half way between the centres when the zones "
             "are "
             "equal. Towards which one does it move when they are not?"},
            {"mean-radius", mean_radius(p),
             "This would be right for two equal bodies of the mean radius. "
             "Is the lens of a large and a small circle the same?"},
            {"chord-behind-the-centre", never_behind(p),
             "The chord is behind the centre of the smaller zone here. Is "
             "the piece then less than half of that zone, or more?"},
            {"one-piece", one_part(p),
             "This is what the chord cuts off one of the two zones. What "
             "lies on its other side?"},
            {"small-diameter", small_diameter(p),
             "Your zones are too wide. When a small body touches a big "
             "one, how far apart are their centres?"},
            {"sectors-only", p.dimensions == 2 ? sectors(p) : expected,
             "These are two slices of cake, up to the centres. Which "
             "triangles must be taken off?"},
            {"no-zone", 0.0,
             "The big bodies do not overlap, but what is forbidden to the "
             "centre of a small one reaches further. How far?"}});
}

/* The potential where the zones overlap. */
static bool check_potential(struct pair p, const char *question)
{
    const double expected = -p.density * exact(p);
    return CHECK_NEAR(
        answer(p).potential, .quantity = "the potential", .unit = "kT",
        .input = input(p), .expected = expected,
        .tolerance = p.density * tolerance(p), .because = because,
        .equation = "eq:depletion", .question = question,
        .mistakes = {
            {"pushed-apart", -expected,
             "The size is right. The small ones have more room when the "
             "big ones are near: is that cheaper or dearer?"},
            {"density-forgotten", -exact(p),
             "This is the shared room. How many small ones gain it?"},
            {"upside-down", -exact(p) / p.density,
             "The room was divided by the density. Do many small ones push "
             "more or less than few?"}});
}

static bool check_both(struct pair p, const char *question)
{
    return check_overlap(p, exact(p), question) &&
           check_potential(p, question);
}

/* Beyond the reach of the zones there is nothing, exactly. */
static bool check_apart(struct pair p, const char *question)
{
    static const char cut[] =
        "The zones do not meet any more, and your formula goes on. What is "
        "the acos of more than 1, and the volume of a cap of negative "
        "height? Up to which distance do the formulas hold?";
    return CHECK_NEAR(answer(p).potential, .quantity = "the potential",
                      .unit = "kT", .input = input(p), .expected = 0.0,
                      .tolerance = 0.0,
                      .because = "zones that do not meet share nothing",
                      .equation = "eq:depletion", .question = question,
                      .mistakes = {{"not-cut-off", -p.density * goes_on(p),
                                    cut}}) &&
           CHECK_NEAR(answer(p).overlap,
                      .quantity = "what the two zones share, *overlap",
                      .unit = p.dimensions == 2 ? "m^2" : "m^3",
                      .input = input(p), .expected = 0.0, .tolerance = 0.0,
                      .because = "zones that do not meet share nothing",
                      .equation = "eq:depletion", .question = question,
                      .mistakes = {
                          {"left-empty", NAN,
                           "Not a number: was something put into *overlap "
                           "where the zones do not meet?"}});
}

/* For R = 1 and small = 0.2 the overlap is 0.360124449 at r = 2 and
   0.128994108 at r = 2.2, in the plane; 0.284837734 and 0.073303829 in the
   room (checked with 2e7 random points). */
static void test_disks(void)
{
    static const char question[] =
        "Two circles of equal radius cut each other. What is half of the "
        "lens: a slice of cake less which triangle?";
    (void)(check_both((struct pair){2, 1.0, 1.0, 0.2, 1.5, 2.2},
                      question) &&
           check_both((struct pair){2, 1.0, 1.0, 0.2, 0.75, 2.05},
                      question) &&
           check_both((struct pair){2, 0.5, 0.5, 1.0, 2.0, 1.25},
                      question));
}

static void test_spheres(void)
{
    static const char question[] =
        "Two balls of equal radius share two caps. How high is a cap, and "
        "what is its volume?";
    (void)(check_both((struct pair){3, 1.0, 1.0, 0.2, 1.5, 2.2},
                      question) &&
           check_both((struct pair){3, 1.0, 1.0, 0.2, 0.75, 2.05},
                      question) &&
           check_both((struct pair){3, 0.5, 0.5, 1.0, 2.0, 1.25},
                      question));
}

/* Either way round. */
static bool check_twice(struct pair p, const char *question)
{
    struct pair q = p;
    q.R1 = p.R2;
    q.R2 = p.R1;
    return check_both(p, question) && check_both(q, question);
}

static void test_unequal(void)
{
    static const char question[] =
        "The two zones are not equal. How far is the chord from either "
        "centre?";
    (void)(check_twice((struct pair){2, 1.0, 0.5, 0.5, 1.25, 1.75},
                       question) &&
           check_twice((struct pair){3, 1.0, 0.5, 0.5, 1.25, 1.75},
                       question));
}

static void test_behind(void)
{
    static const char question[] =
        "The chord lies behind the centre of the small zone. What sign has "
        "its distance from there, and does your formula keep it?";
    (void)(check_twice((struct pair){2, 3.0, 0.25, 0.5, 1.25, 3.375},
                       question) &&
           check_twice((struct pair){3, 3.0, 0.25, 0.5, 1.25, 3.375},
                       question));
}

static void test_apart(void)
{
    static const char question[] =
        "The zones do not meet, or only touch. What do they share?";
    (void)(check_apart((struct pair){2, 1.0, 1.0, 0.25, 2.0, 3.0},
                       question) &&
           check_apart((struct pair){3, 1.0, 1.0, 0.25, 2.0, 3.0},
                       question) &&
           check_apart((struct pair){2, 1.0, 0.5, 0.25, 2.0, 2.0},
                       question) &&
           check_apart((struct pair){3, 1.0, 0.5, 0.25, 2.0, 2.0},
                       question) &&
           check_apart((struct pair){2, 1.0, 0.5, 0.0, 2.0, 1.5},
                       question) &&
           check_apart((struct pair){3, 1.0, 0.5, 0.25, 2.0, 1e6},
                       question));
}

static bool check_touching(struct pair p)
{
    static const char question[] =
        "The two big bodies just touch. Where are the zones and their "
        "chord now?";
    static const char why[] =
        "The big bodies do not overlap here, they just touch. Is that "
        "forbidden?";
    return CHECK_NEAR(isinf(answer(p).potential) ? 1.0 : 0.0,
                      .quantity =
                          "is the potential infinite? (1 yes, 0 no)",
                      .input = input(p), .expected = 0.0, .tolerance = 0.0,
                      .because = "yes or no", .equation = "eq:depletion",
                      .question = why,
                      .mistakes = {{"touching-forbidden", 1.0, why}}) &&
           check_both(p, question);
}

static void test_touching(void)
{
    (void)(check_touching((struct pair){2, 1.0, 1.0, 0.2, 1.5, 2.0}) &&
           check_touching((struct pair){3, 1.0, 1.0, 0.2, 1.5, 2.0}) &&
           check_touching((struct pair){2, 1.0, 0.25, 0.5, 1.5, 1.25}) &&
           check_touching((struct pair){3, 0.25, 1.0, 0.5, 1.5, 1.25}));
}

static bool check_core(struct pair p)
{
    static const char why[] =
        "The big bodies themselves overlap at this distance. What does "
        "that "
        "cost, however much room the small ones gain?";
    return CHECK_NEAR(
        answer(p).potential, .quantity = "the potential", .unit = "kT",
        .input = input(p), .expected = INFINITY, .tolerance = 0.0,
        .because = "infinity is exact", .equation = "eq:depletion",
        .question = why,
        .mistakes = {{"no-core", -p.density * exact(p), why}});
}

static void test_core(void)
{
    (void)(check_core((struct pair){2, 1.0, 1.0, 0.2, 1.5, 1.9}) &&
           check_core((struct pair){3, 1.0, 0.5, 0.5, 1.5, 1.25}) &&
           check_core((struct pair){2, 1.0, 0.5, 0.5, 0.0, 1.25}) &&
           check_core((struct pair){3, 1.0, 1.0, 0.0, 1.5, 1.0}));
}

const struct check_suite check_suite = {
    .exercise = "06c",
    .title = "Pushed together by nothing",
    .minutes = 35,
    .tests = {{"two equal disks share a lens", test_disks, 1, 0},
              {"two equal spheres share two caps", test_spheres, 1, 0},
              {"a large and a small one do it unequally", test_unequal, 1,
               0},
              {"a chord may lie behind a centre", test_behind, 1, 0},
              {"two that touch are as deep as they can be", test_touching,
               1, 0},
              {"zones that do not meet share nothing", test_apart, 1, 0},
              {"two that overlap are forbidden", test_core, 1, 0},
              {0}},
};
