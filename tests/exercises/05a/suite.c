/* The suite of exercise 05a, "The time to a round wall". */

#include "examiner/check.h"
#include "call.h"

struct flight {
    double box, radius;
    double r[2], v[2];
};

static double answer(const struct flight *f)
{
    check_about(check_text("box = %g m, radius = %g m, r = {%.17g, %.17g} "
                           "m, v = {%.17g, %.17g} m/s",
                           f->box, f->radius, f->r[0], f->r[1], f->v[0],
                           f->v[1]));
    return round_wall_time(f->box, f->radius, f->r, f->v);
}

static double dot(const double a[2], const double b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

static double reach(const struct flight *f)
{
    return f->box - f->radius;
}

/* The discriminant, over 4, for a circle of the radius s. */
static double disc(const struct flight *f, double s)
{
    const double b = dot(f->r, f->v);
    return b * b + dot(f->v, f->v) * (s * s - dot(f->r, f->r));
}

/* The two times, by the schoolbook, at which the centre is at s. */
static double root(const struct flight *f, double s, double sign)
{
    return (-dot(f->r, f->v) + sign * sqrt(disc(f, s))) / dot(f->v, f->v);
}

/* The slips, each worked out for the flight at hand. */

static double b_not_doubled(const struct flight *f)
{
    const double s = reach(f), b = dot(f->r, f->v), v2 = dot(f->v, f->v);
    const double room = s * s - dot(f->r, f->r);
    return (-b + sqrt(b * b + 4.0 * v2 * room)) / (2.0 * v2);
}

static double as_a_flat_wall(const struct flight *f)
{
    const double distance = sqrt(dot(f->r, f->r));
    return (reach(f) - distance) * distance / dot(f->r, f->v);
}

static double square_box(const struct flight *f)
{
    double first = INFINITY;
    for (int k = 0; k < 2; ++k)
        if (f->v[k] != 0.0)
            first = fmin(first,
                         (copysign(reach(f), f->v[k]) - f->r[k]) / f->v[k]);
    return first;
}

/* Each term of the discriminant is at most s^2 v^2 and is rounded a few
   times; the root passes that on to the time, divided by the root. Along
   the wall the root is small, and nobody can do better. What is earlier
   than now is no answer at all. */
static double tolerance(const struct flight *f, double got)
{
    const double s = reach(f);
    return got < 0.0 ? 0.0 : 16.0 * DBL_EPSILON * s * s / sqrt(disc(f, s));
}

static const char because[] =
    "16 epsilons of s^2 over the square root in the formula, s = box - "
    "radius; and not before now";

/* From inside the circle. */
static void check_inside(struct flight f, double expected)
{
    const double got = answer(&f);
    CHECK_NEAR(
        got, .quantity = "time until the disk touches the wall",
        .unit = "s", .expected = expected, .tolerance = tolerance(&f, got),
        .because = because,
        .mistakes = {
            {"radius-forgotten", root(&f, f.box, 1.0),
             "By then the CENTRE of the disk is at the wall of the box. "
             "Where is it when the edge of the disk is there?"},
            {"first-root", root(&f, reach(&f), -1.0),
             "A straight line crosses the circle twice. The disk is inside "
             "it: which crossing is still to come?"},
            {"flat-wall", as_a_flat_wall(&f),
             "This divides the distance to the nearest point of the wall "
             "by the speed at which it shrinks now. Does it go on "
             "shrinking like that?"},
            {"square-box", square_box(&f),
             "This is the wall time of a square box. Is it enough to look "
             "at one coordinate at a time when the wall is round?"},
            {"b-not-doubled", b_not_doubled(&f),
             "The formula with 4ac and 2a takes the whole factor of t for "
             "its b, which is 2 r.v. Which of the two formulas did you "
             "mean?"},
            {"sign-of-b", -root(&f, reach(&f), -1.0),
             "A quadratic has -b in its solution. Which sign has yours, "
             "and is the disk on its way to the wall or from it?"},
            {"length-for-time", expected * sqrt(dot(f.v, f.v)),
             "This is the length of the way. Which unit does a time have, "
             "and by what do you divide?"},
            {"not-divided", expected * dot(f.v, f.v),
             "This is the numerator. By what is it divided in the solution "
             "of a quadratic, and what is that here?"}});
}

/* A disk that moves comes to the wall, sooner or later. */
static void check_comes(double got)
{
    CHECK_NEAR(
        got == INFINITY ? 0.0 : 1.0,
        .quantity = "does the disk come to the wall? (1 yes, 0 never)",
        .expected = 1.0, .because = "yes or no", .equation = "eq:wall-time",
        .question = "Which disks never come to the wall?",
        .mistakes = {
            {"lost-through-the-wall", 0.0,
             "The disk is at the wall, or a hair beyond it, and moves. "
             "Your function says that it will never come to the wall, so "
             "nothing will turn it round. What becomes of it?"}});
}

/* On the wall or a hair beyond it, and moving outwards. */
static void check_now(struct flight f)
{
    const double got = answer(&f);
    check_comes(got);
    CHECK_NEAR(got, .quantity = "time until the disk touches the wall",
               .unit = "s", .tolerance = tolerance(&f, got),
               .because = because, .equation = "eq:wall-time",
               .mistakes = {
                   {"first-root", root(&f, reach(&f), -1.0),
                    "This time is in the past, when the disk came from the "
                    "other side. Which crossing does it stand at now?"},
                   {"time-in-the-past", got < 0.0 ? got : -1.0,
                    "The disk is a hair too far out, by rounding, and "
                    "would have touched the wall in the past. No program "
                    "goes back. When can it still bounce?"}});
}

/* On the wall or a hair beyond it, and moving inwards. */
static void check_across(struct flight f, double expected)
{
    const double got = answer(&f);
    check_comes(got);
    CHECK_NEAR(got, .quantity = "time until the disk touches the wall",
               .unit = "s", .expected = expected,
               .tolerance = tolerance(&f, got), .because = because,
               .mistakes = {{"stuck-at-the-wall", 0.0,
                             "The disk has just bounced and moves inwards. "
                             "With this time it would bounce again at "
                             "once, and for ever. Where does it go?"}});
}

static void test_centre(void)
{
    check_ask("The disk starts at the centre of the box. How far can its "
              "centre go, and how fast does it?");
    check_inside((struct flight){4.0, 1.0, {0.0, 0.0}, {0.4, 0.0}}, 7.5);
    check_ask(
        "From the centre every direction is alike. What is the speed?");
    check_inside((struct flight){3.0, 1.0, {0.0, 0.0}, {-3.0, -4.0}}, 0.4);
}

/* Chords of circles of 5 m and 13 m. */
static void test_by_hand(void)
{
    check_ask("Draw it: where does the path cross the circle on which the "
              "centre must stay, and how far is that?");
    static const struct flight f[] = {{6.0, 1.0, {1.0, 3.0}, {2.0, 0.0}},
                                      {6.0, 1.0, {3.0, 0.0}, {0.0, 2.0}},
                                      {14.0, 1.0, {-5.0, 0.0}, {0.0, -0.5}},
                                      {14.0, 1.0, {-5.0, 6.0}, {0.0, 3.0}}};
    check_inside(f[0], 1.5);
    check_inside(f[1], 2.0);
    check_inside(f[2], 24.0);
    check_inside(f[3], 2.0);
}

static void test_inwards(void)
{
    check_ask("The disk moves inwards first. Which part of the way brings "
              "it nearer to the centre, and which takes it to the wall?");
    static const struct flight f[] = {{6.0, 1.0, {2.0, 3.0}, {-0.25, 0.0}},
                                      {6.0, 1.0, {2.0, -4.0}, {-2.0, 0.0}},
                                      {6.0, 1.0, {-4.0, 0.0}, {0.5, 0.0}}};
    check_inside(f[0], 24.0);
    check_inside(f[1], 2.5);
    check_inside(f[2], 18.0);
}

/* No round numbers, all around; and at the time found the centre must be
   where it belongs. */
CHECK_TIMES(24, test_all_directions, k)
{
    check_ask("Does your formula know the direction? What does r + v t say "
              "at the time you found?");
    const double angle = 0.1 + 0.26 * k;
    const struct flight f = {
        2.3, 0.41, {0.71, -1.13}, {1.7 * cos(angle), 1.7 * sin(angle)}};
    check_inside(f, root(&f, reach(&f), 1.0));
}

/* A flight drawn from its end: the disk comes to the wall after some time,
   at some slant to the wall, and flies backwards from there. Chord is how
   long it takes from wall to wall. */
struct drawn {
    struct flight f;
    double time, chord;
};

static struct drawn draw_flight(double from, double to)
{
    struct drawn d;
    d.f.box = check_draw(0.5, 9.0);
    d.f.radius = check_draw(0.05 * d.f.box, 0.8 * d.f.box);
    const double speed = check_draw_whole(0, 1) ? check_draw(0.01, 0.2)
                                                : check_draw(0.2, 30);
    const double way = check_draw(-3.1416, 3.1416);
    const double slant = check_draw(-1.4, 1.4), s = reach(&d.f);
    d.f.v[0] = speed * cos(way);
    d.f.v[1] = speed * sin(way);
    d.chord = 2.0 * s * cos(slant) / speed;
    d.time = d.chord * check_draw(from, to);
    d.f.r[0] = s * cos(way + slant) - d.f.v[0] * d.time;
    d.f.r[1] = s * sin(way + slant) - d.f.v[1] * d.time;
    return d;
}

CHECK_TIMES(40, test_drawn, i)
{
    check_ask("This flight was drawn backwards from the wall. Where does "
              "yours end, and how far is that from the centre?");
    const struct drawn d = draw_flight(0.02, 0.98);
    check_inside(d.f, d.time);
}

/* A place on the circle of the radius 5, exactly. */
static void test_on_the_wall_inwards(void)
{
    check_ask("The disk touches the wall and moves inwards. How long is "
              "the chord before it?");
    check_across((struct flight){6.0, 1.0, {5.0, 0.0}, {-2.0, 0.0}}, 5.0);
    check_across((struct flight){6.0, 1.0, {3.0, 4.0}, {0.0, -0.5}}, 16.0);
    check_across((struct flight){6.0, 1.0, {-4.0, 3.0}, {4.0, 0.0}}, 2.0);
}

static void test_on_the_wall_outwards(void)
{
    check_ask("The disk touches the wall and moves outwards. When is it at "
              "the wall?");
    check_now((struct flight){6.0, 1.0, {5.0, 0.0}, {2.0, 0.0}});
    check_now((struct flight){6.0, 1.0, {3.0, 4.0}, {0.0, 0.5}});
    check_now((struct flight){6.0, 1.0, {-4.0, 3.0}, {-4.0, 1.0}});
}

/* At the wall, and nobody knows on which side of it by a rounding. */
CHECK_TIMES(40, test_drawn_at_the_wall, i)
{
    const struct drawn d = draw_flight(0.0, 0.0);
    struct flight back = d.f;
    back.v[0] = -d.f.v[0];
    back.v[1] = -d.f.v[1];
    check_ask(
        "The disk has come to the wall and moves on. When does it bounce?");
    check_now(d.f);
    check_ask("The disk leaves the wall and crosses the box. How long is "
              "the chord before it?");
    check_across(back, d.chord);
}

static void test_a_hair_beyond(void)
{
    check_ask("A rounding has put the disk a hair too far out. Which way "
              "does it move, and which of the two crossings is meant?");
    const double hair = 8.0 * DBL_EPSILON;
    check_now((struct flight){6.0, 1.0, {5.0 + hair, 0.0}, {2.0, 0.0}});
    check_now((struct flight){6.0, 1.0, {3.0, 4.0 + hair}, {-0.5, 1.0}});
    check_across((struct flight){6.0, 1.0, {5.0 + hair, 0.0}, {-2.0, 0.0}},
                 5.0);
    check_across((struct flight){6.0, 1.0, {3.0, 4.0 + hair}, {0.0, -0.5}},
                 16.0);
}

/* Just along the wall the path has only this point in common with the
   circle. A rounding of the place is a square root of it in time. */
static void check_along(struct flight f)
{
    const double got = answer(&f);
    check_comes(got);
    CHECK_NEAR(got, .quantity = "time until the disk touches the wall",
               .unit = "s",
               .tolerance = 4.0 * sqrt(DBL_EPSILON) * reach(&f) /
                            sqrt(dot(f.v, f.v)),
               .because = "4 square roots of an epsilon, times the time to "
                          "fly the radius s",
               .question =
                   "The disk touches the wall and moves just along it, so "
                   "the next moment it would be outside. What is your "
                   "numerator, and what do you divide by?");
}

/* A hair too far out and nearly along the wall, the path just misses the
   circle. Anything from now to twice the time of the nearest approach will
   do; what will not do is no number, or never. */
static void test_along_the_wall(void)
{
    const double hair = 4.0 * DBL_EPSILON, slope = 1e-9;
    const struct flight f = {2.0, 1.0, {1.0 + hair, 0.0}, {-slope, 1.0}};
    check_along((struct flight){6.0, 1.0, {5.0, 0.0}, {0.0, 2.0}});
    check_along((struct flight){6.0, 1.0, {3.0, 4.0}, {4.0, -3.0}});
    const double got = answer(&f);
    check_comes(got);
    CHECK_NEAR(got, .quantity = "time until the disk touches the wall",
               .unit = "s", .expected = slope, .tolerance = slope,
               .because = "from now to twice the time of the nearest "
                          "approach: inside the rounding all are alike",
               .question = "This path all but touches the circle. Which "
                           "number under the root is as good as none?",
               .mistakes = {{"root-of-a-negative", CHECK_NAN,
                             "Not a number: what stands under the square "
                             "root, by a hair less than zero, when the "
                             "path only just misses the circle?"}});
}

static void check_at_rest(double x, double y)
{
    const struct flight f = {6.0, 1.0, {x, y}, {0.0, 0.0}};
    CHECK_NEAR(answer(&f),
               .quantity = "time until the disk touches the wall",
               .unit = "s", .expected = INFINITY,
               .because = "never is never", .equation = "eq:wall-time",
               .mistakes = {
                   {"at-rest-divided", CHECK_NAN,
                    "Not a number: at rest the quadratic is none. What is "
                    "zero divided by zero, and what was to be returned?"},
                   {"at-rest-now", 0.0,
                    "The disk is at rest and will not come to any wall. If "
                    "it bounced now, where would it go, and when would it "
                    "bounce again?"}});
}

/* limit: 1e-9 m/s (the smallest speed of a disk that is not at rest) */
static void check_slow(double u, double w, double expected)
{
    const struct flight f = {6.0, 1.0, {3.0, 0.0}, {u, w}};
    const double got = answer(&f);
    static const char question[] =
        "This disk moves, at 1e-9 m/s. Is that the same as at rest? From "
        "which number on does your function take it for that, and is that "
        "number a speed or the square of one?";
    CHECK_NEAR(
        got, .quantity = "time until the disk touches the wall",
        .unit = "s", .expected = expected, .tolerance = tolerance(&f, got),
        .because = because, .equation = "eq:wall-time",
        .question = question,
        .mistakes = {{"slow-taken-for-at-rest", INFINITY, question}});
}

static void test_at_rest(void)
{
    check_ask("Nothing moves. What was to be returned, and what did your "
              "division make of it?");
    check_at_rest(0.0, 0.0);
    check_at_rest(2.0, -1.5);
    check_at_rest(3.0, 4.0);
    check_at_rest(5.0 + 8.0 * DBL_EPSILON, 0.0);
    check_slow(0.0, 1e-9, 4e9);
    check_slow(1e-9, 0.0, 2e9);
    check_slow(-1e-9, 0.0, 8e9);
}

/* Millimetres and kilometres per second, and the other way round. */
static void test_units(void)
{
    check_ask(
        "The same picture, but small and fast or large and slow. Is there "
        "a number in your function that belongs to one size only?");
    check_inside((struct flight){6e-3, 1e-3, {3e-3, 0.0}, {0.0, 2e3}},
                 2e-6);
    check_inside((struct flight){6e6, 1e6, {1e6, 4e6}, {2e-3, 0.0}}, 1e9);
}

const struct check_suite check_suite = {
    .file = "05a-round.c",
    .title = "The time to a round wall",
    .minutes = 20,
    .equation = "eq:pair-quadratic",
    .tests =
        {{"a disk from the centre comes straight to the wall", test_centre,
          1, 0},
         {"a disk from elsewhere flies as far as drawn by hand",
          test_by_hand, 2, 0},
         {"a disk that moves inwards crosses the box", test_inwards, 1, 0},
         {"the way is right in all directions", test_all_directions, 1, 0},
         {"a disk that has just bounced crosses the box",
          test_on_the_wall_inwards, 1, 0},
         {"a disk on the wall that moves outwards bounces now",
          test_on_the_wall_outwards, 1, 0},
         {"a hair beyond the wall nothing else holds", test_a_hair_beyond,
          2, 0},
         {"along the wall there is still a time", test_along_the_wall, 1,
          0},
         {"a disk at rest never comes to the wall", test_at_rest, 1, 0},
         {"small and fast is as good as large and slow", test_units, 1, 0},
         {"flights drawn end where they were drawn from", test_drawn, 3, 3},
         {"flights drawn begin at the wall", test_drawn_at_the_wall, 2, 2},
         {0}},
    .idle = {test_on_the_wall_outwards, test_along_the_wall},
};
