/* The suite of exercise 06c, "Pushed together by nothing". */

#include "examiner/check.h"
#include "call.h"

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
    check_about(check_text(
        "%d dimensions, R1 = %.10g m, R2 = %.10g m, small = %.10g m, "
        "density = %g m^-%d, r = %.10g m",
        p.dimensions, p.R1, p.R2, p.small, p.density, p.dimensions, p.r));
    struct answer a = {CHECK_EMPTY, CHECK_EMPTY};
    a.potential = depletion(p.dimensions, p.R1, p.R2, p.small, p.density,
                            p.r, &a.overlap);
    return a;
}

static const double pi = 3.14159265358979323846;

/* What is cut off a zone by a chord at the distance c from its centre. */
static double part(int dimensions, double zone, double c)
{
    const double s = sqrt(fmax(0.0, (zone - c) * (zone + c)));
    const double angle = 2.0 * atan2(s, c);
    return dimensions == 2
               ? 0.5 * zone * zone * (angle - sin(angle))
               : pi * (zone - c) * (zone - c) * (2.0 * zone + c) / 3.0;
}

/* The distance of the chord from the centre of the zone a. */
static double chord(double a, double b, double r)
{
    return (r * r + (a + b) * (a - b)) / (2.0 * r);
}

static double shared(int dimensions, double a, double b, double r)
{
    return r < a + b ? part(dimensions, a, chord(a, b, r)) +
                           part(dimensions, b, chord(b, a, r))
                     : 0.0;
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
    return p.dimensions == 2 ? CHECK_NAN /* the acos of more than 1 */
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

/* What may be off, and why. */
struct slack {
    double overlap;
    const char *because;
};

static void check_overlap(struct pair p, double expected,
                          struct slack slack)
{
    CHECK_NEAR(
        answer(p).overlap, .quantity = "what the two zones share, *overlap",
        .unit = p.dimensions == 2 ? "m^2" : "m^3", .expected = expected,
        .tolerance = slack.overlap, .because = slack.because,
        .equation = p.dimensions == 2 ? "eq:lens" : "eq:lens3",
        .mistakes = {
            {"area-for-volume", flat(p),
             "This is the area of a lens in the plane. How many dimensions "
             "were asked for?"},
            {"chord-in-the-middle",
             part(p.dimensions, p.R1 + p.small, 0.5 * p.r) +
                 part(p.dimensions, p.R2 + p.small, 0.5 * p.r),
             "The chord lies half way between the centres when the zones "
             "are equal. Towards which one does it move when they are "
             "not?"},
            {"mean-radius", mean_radius(p),
             "This would be right for two equal bodies of the mean radius. "
             "Is the lens of a large and a small circle the same?"},
            {"chord-behind-the-centre", never_behind(p),
             "The chord is behind the centre of the smaller zone here. Is "
             "the piece then less than half of that zone, or more?"},
            {"one-piece", one_part(p),
             "This is what the chord cuts off one of the two zones. What "
             "lies on its other side?"},
            {"small-diameter",
             shared(p.dimensions, p.R1 + 2.0 * p.small,
                    p.R2 + 2.0 * p.small, p.r),
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
static void check_potential(struct pair p, double overlap,
                            struct slack slack)
{
    const double expected = -p.density * overlap;
    CHECK_NEAR(
        answer(p).potential, .quantity = "the potential", .unit = "kT",
        .expected = expected, .tolerance = p.density * slack.overlap,
        .because = slack.because,
        .mistakes = {
            {"pushed-apart", -expected,
             "The size is right. The small ones have more room when the "
             "big ones are near: is that cheaper or dearer?"},
            {"density-forgotten", -overlap,
             "This is the shared room. How many small ones gain it?"},
            {"upside-down", -overlap / p.density,
             "The room was divided by the density. Do many small ones push "
             "more or less than few?"}});
}

static void check_given(struct pair p, double overlap, struct slack slack)
{
    check_overlap(p, overlap, slack);
    check_potential(p, overlap, slack);
}

static void check_both(struct pair p)
{
    const struct slack few = {
        tolerance(p),
        "16 epsilons of the zones, more where the lens is thin"};
    check_given(p, exact(p), few);
}

/* Beyond the reach of the zones there is nothing, exactly. Where they touch
   but for a rounding, a lens of the thickness of an epsilon may be left. */
static void check_apart(struct pair p, double tolerance)
{
    static const char cut[] =
        "The zones do not meet any more, and your formula goes on. What is "
        "the acos of more than 1, and the volume of a cap of negative "
        "height? Up to which distance do the formulas hold?";
    CHECK_NEAR(answer(p).potential, .quantity = "the potential",
               .unit = "kT", .tolerance = tolerance,
               .because = "zones that do not meet share nothing",
               .mistakes = {{"not-cut-off", -p.density * goes_on(p), cut}});
    CHECK_NEAR(
        answer(p).overlap, .quantity = "what the two zones share, *overlap",
        .unit = p.dimensions == 2 ? "m^2" : "m^3", .tolerance = tolerance,
        .because = "zones that do not meet share nothing",
        .mistakes = {{"left-empty", CHECK_EMPTY,
                      "Not a number: was something put into *overlap where "
                      "the zones do not meet?"}});
}

static void test_disks(void)
{
    check_ask("Two circles of equal radius cut each other. What is half of "
              "the lens: a slice of cake less which triangle?");
    check_both((struct pair){2, 1.0, 1.0, 0.2, 1.5, 2.2});
    check_both((struct pair){2, 1.0, 1.0, 0.2, 0.75, 2.05});
    check_both((struct pair){2, 0.5, 0.5, 1.0, 2.0, 1.25});
}

static void test_spheres(void)
{
    check_ask("Two balls of equal radius share two caps. How high is a "
              "cap, and what is its volume?");
    check_both((struct pair){3, 1.0, 1.0, 0.2, 1.5, 2.2});
    check_both((struct pair){3, 1.0, 1.0, 0.2, 0.75, 2.05});
    check_both((struct pair){3, 0.5, 0.5, 1.0, 2.0, 1.25});
}

/* Either way round. */
static void check_twice(struct pair p)
{
    struct pair q = p;
    q.R1 = p.R2;
    q.R2 = p.R1;
    check_both(p);
    check_both(q);
}

static void test_unequal(void)
{
    check_ask("The two zones are not equal. How far is the chord from "
              "either centre?");
    check_twice((struct pair){2, 1.0, 0.5, 0.5, 1.25, 1.75});
    check_twice((struct pair){3, 1.0, 0.5, 0.5, 1.25, 1.75});
}

static void test_behind(void)
{
    check_ask(
        "The chord lies behind the centre of the small zone. What sign has "
        "its distance from there, and does your formula keep it?");
    check_twice((struct pair){2, 3.0, 0.25, 0.5, 1.25, 3.375});
    check_twice((struct pair){3, 3.0, 0.25, 0.5, 1.25, 3.375});
}

static void test_apart(void)
{
    check_ask("The zones do not meet, or only touch. What do they share?");
    static const struct pair apart[] = {
        {2, 1.0, 1.0, 0.25, 2.0, 3.0}, {3, 1.0, 1.0, 0.25, 2.0, 3.0},
        {2, 1.0, 0.5, 0.25, 2.0, 2.0}, {3, 1.0, 0.5, 0.25, 2.0, 2.0},
        {2, 1.0, 0.5, 0.0, 2.0, 1.5},  {3, 1.0, 0.5, 0.25, 2.0, 1e6}};
    static const double touching[][3] = {
        {0.1, 0.2, 0.25}, {0.1, 0.3, 0.1}, {0.1, 0.2, 1.3}};
    for (size_t i = 0; i < sizeof apart / sizeof apart[0]; ++i)
        check_apart(apart[i], 0.0);
    for (size_t i = 0; i < 3; ++i) {
        const double *t = touching[i];
        const struct pair p = {2,    t[0], t[1],
                               t[2], 2.0,  (t[0] + t[2]) + (t[1] + t[2])};
        check_apart(p, 1e-20);
    }
}

static void check_touching(struct pair p)
{
    check_ask("The two big bodies just touch. Where are the zones and "
              "their chord now?");
    static const char why[] = "The big bodies do not overlap here, they "
                              "just touch. Is that forbidden?";
    CHECK_NEAR(isinf(answer(p).potential),
               .quantity = "is the potential infinite? (1 yes, 0 no)",
               .because = "yes or no", .question = why,
               .mistakes = {{"touching-forbidden", 1.0, why}});
    check_both(p);
}

static void test_touching(void)
{
    check_touching((struct pair){2, 1.0, 1.0, 0.2, 1.5, 2.0});
    check_touching((struct pair){3, 1.0, 1.0, 0.2, 1.5, 2.0});
    check_touching((struct pair){2, 1.0, 0.25, 0.5, 1.5, 1.25});
    check_touching((struct pair){3, 0.25, 1.0, 0.5, 1.5, 1.25});
}

static void check_core(struct pair p)
{
    static const char why[] =
        "The big bodies themselves overlap at this distance. What does "
        "that cost, however much room the small ones gain?";
    CHECK_NEAR(answer(p).potential, .quantity = "the potential",
               .unit = "kT", .expected = INFINITY,
               .because = "infinity is exact", .question = why,
               .mistakes = {{"no-core", -p.density * exact(p), why}});
}

static void test_core(void)
{
    check_core((struct pair){2, 1.0, 1.0, 0.2, 1.5, 1.9});
    check_core((struct pair){3, 1.0, 0.5, 0.5, 1.5, 1.25});
    check_core((struct pair){2, 1.0, 0.5, 0.5, 0.0, 1.25});
    check_core((struct pair){3, 1.0, 1.0, 0.0, 1.5, 1.0});
}

/* What an angle cuts off the circle, or off the sphere, of radius 1: the
   angle from the middle of the chord to its end, seen from the centre. */
static double cut(int dimensions, double angle)
{
    const double less = 1.0 - cos(angle);
    return dimensions == 2 ? angle - 0.5 * sin(2.0 * angle)
                           : pi * less * less * (1.0 - less / 3.0);
}

/* A pair that is made for its lens: half a chord is s, and the two zones
   see it under drawn angles. The second chord may lie behind its centre,
   but not so far that its zone is nearly whole: to integrate is difficult
   there. The small bodies are so large that the big ones do not overlap,
   and smaller than either zone. */
static struct pair draw_pair(int dimensions, double *overlap)
{
    const double s = check_draw(0.2, 2.0);
    const double alpha = check_draw(0.15, 1.4);
    const double beta = check_draw(0.15, fmin(2.0, 2.7 - alpha));
    const double a = s / sin(alpha), b = s / sin(beta);
    const double r = s * (1.0 / tan(alpha) + 1.0 / tan(beta));
    const double least = 0.5 * (a + b - r), most = fmin(a, b);
    const double small = least + check_draw(0.05, 0.9) * (most - least);
    const struct pair p = {
        dimensions, a - small, b - small, small, check_draw(0.1, 9.0), r};
    *overlap = pow(a, dimensions) * cut(dimensions, alpha) +
               pow(b, dimensions) * cut(dimensions, beta);
    return p;
}

CHECK_TIMES(40, test_limits, i)
{
    check_ask("The zones do not meet. What do they share?");
    double overlap;
    struct pair far = draw_pair(2 + i % 2, &overlap), near = far;
    far.r = far.R1 + far.R2 + 2.0 * far.small + check_draw(0.01, 9.0);
    near.r = check_draw(0.1, 0.98) * (near.R1 + near.R2);
    check_core(near);
    check_apart(far, 0.0);
}

CHECK_TIMES(40, test_drawn, i)
{
    check_ask("Two zones, and a chord in front of a centre or behind it. "
              "What does it cut off each of them?");
    double overlap;
    struct pair p = draw_pair(2 + i % 2, &overlap);
    if (check_draw_whole(0, 1)) {
        const double R1 = p.R1;
        p.R1 = p.R2;
        p.R2 = R1;
    }
    const struct slack some = {
        tolerance(p) + 1e-8 * overlap,
        "a hundred millionth, for those who integrate"};
    check_given(p, overlap, some);
}

const struct check_suite check_suite = {
    .file = "06c-depletion.c",
    .title = "Pushed together by nothing",
    .minutes = 35,
    .equation = "eq:depletion",
    .tests =
        {{"two equal disks share a lens", test_disks, 2, 0},
         {"two equal spheres share two caps", test_spheres, 2, 0},
         {"a large and a small one do it unequally", test_unequal, 2, 0},
         {"a chord may lie behind a centre", test_behind, 2, 0},
         {"two that touch are as deep as they can be", test_touching, 1, 0},
         {"zones that do not meet share nothing", test_apart, 1, 0},
         {"two that overlap are forbidden", test_core, 1, 0},
         {"zones made for their lens share it", test_drawn, 2, 3},
         {"too near or too far, whatever the bodies", test_limits, 1, 1},
         {0}},
    .idle = {test_apart},
};
