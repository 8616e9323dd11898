/* The suite of exercise 05b, "Two disks that fall". */

#include "examiner/check.h"
#include "call.h"

struct pair {
    double g;
    struct thrown a, b;
};

#define PAIR(...) ((struct pair){__VA_ARGS__})

/* What the student's function answers; an untouched place reads as NaN. */
struct answer {
    double time, height;
};

static const char *disk(const struct thrown *d)
{
    return check_text("(%.17g, %.17g) m, (%.17g, %.17g) m/s, radius %g m",
                      d->x, d->y, d->vx, d->vy, d->radius);
}

static struct answer answer(const struct pair *p)
{
    check_about(check_text("g = %g m/s^2; a: %s; b: %s", p->g, disk(&p->a),
                           disk(&p->b)));
    struct answer a = {CHECK_EMPTY, CHECK_EMPTY};
    a.time = falling_pair_time(p->g, &p->a, &p->b, &a.height);
    return a;
}

/* The quadratic v2 t^2 + 2 b t + c = 0 for the distance s, and its
   discriminant over 4. */
struct quadratic {
    double v2, b, c, disc;
};

static struct quadratic quadratic(const struct pair *p, double s)
{
    const double x = p->b.x - p->a.x, y = p->b.y - p->a.y;
    const double u = p->b.vx - p->a.vx, w = p->b.vy - p->a.vy;
    struct quadratic q = {u * u + w * w, x * u + y * w,
                          -(s * s - (x * x + y * y)), 0.0};
    q.disc = q.b * q.b - q.v2 * q.c;
    return q;
}

static double touching(const struct pair *p)
{
    return p->a.radius + p->b.radius;
}

/* A root by the schoolbook, with the sign -1 the first. */
static double root(const struct pair *p, double s, double sign)
{
    const struct quadratic q = quadratic(p, s);
    return (-q.b + sign * sqrt(q.disc)) / q.v2;
}

/* The slips, each worked out for the pair at hand. */

static double missing(const struct pair *p, bool as_a_sum)
{
    const struct quadratic q = quadratic(p, touching(p));
    if (q.disc >= 0.0)
        return 0.0;
    const double width = sqrt(fabs(q.disc));
    return as_a_sum ? q.c / (width - q.b) : (-q.b - width) / q.v2;
}

/* When two that part have met, or will; 0 for two that never do. */
static double met(const struct pair *p, double sign)
{
    const double time = root(p, touching(p), sign);
    return isnan(time) ? 0.0 : time;
}

static double nearest(const struct pair *p)
{
    const struct quadratic q = quadratic(p, touching(p));
    return -q.b / q.v2;
}

/* When b alone, or a alone, falls: found by small steps. */
static double one_falls(const struct pair *p, double g)
{
    const double x = p->b.x - p->a.x, y = p->b.y - p->a.y;
    const double u = p->b.vx - p->a.vx, w = p->b.vy - p->a.vy;
    double early = 0.0, late = 0.0;
    for (int i = 0; i < 100000; ++i, early = late) {
        late += 1e-4;
        if (hypot(x + u * late, y + w * late - 0.5 * g * late * late) <
            touching(p))
            break;
    }
    for (int i = 0; i < 60; ++i) {
        const double t = 0.5 * (early + late);
        const bool out =
            hypot(x + u * t, y + w * t - 0.5 * g * t * t) > touching(p);
        *(out ? &early : &late) = t;
    }
    return late;
}

/* The terms of the discriminant are of the size v^2 d^2, of which s^2 is a
   part; the root passes their roundings on to the time. So it does with
   those of the positions, which move the contact. */
static double tolerance(const struct pair *p)
{
    const struct quadratic q = quadratic(p, touching(p));
    const double s = touching(p);
    const double places =
        fabs(p->a.x) + fabs(p->a.y) + fabs(p->b.x) + fabs(p->b.y);
    return 16.0 * DBL_EPSILON * (q.c + (2.0 * s + places) * s) /
           sqrt(q.disc);
}

static const char quantity[] = "time until the disks touch";

/* Whether they meet at all is a check of its own, since never is not a
   number that has neighbours. */
static void check_meets(double got, const char *mistake, const char *hint)
{
    CHECK_NEAR(got == INFINITY ? 0.0 : 1.0,
               .quantity = "do the disks ever touch? (1 yes, 0 never)",
               .expected = 1.0, .because = "yes or no",
               .mistakes = {{mistake, 0.0, hint}});
}

static void check_time(struct pair p, double expected)
{
    const double got = answer(&p).time, allowed = tolerance(&p);
    /* The slips that take many steps, only for who needs them. */
    const bool wrong = !(fabs(got - expected) <= allowed);
    check_meets(got, NULL, NULL);
    CHECK_NEAR(
        got, .quantity = quantity, .unit = "s", .expected = expected,
        .tolerance = allowed,
        .because = "16 epsilons of the squares of distance and contact "
                   "distance, and of positions times contact distance, "
                   "over the square root in the formula",
        .equation = "eq:pair-quadratic",
        .mistakes = {
            {"second-root", root(&p, touching(&p), 1.0),
             "At this time the disks have passed through each other and "
             "touch for the second time. Which root comes first?"},
            {"closest-approach", nearest(&p),
             "At this time the centres are nearest to each other. Have the "
             "disks not met before?"},
            {"one-radius", root(&p, p.a.radius, -1.0),
             "Here the centre of b comes to the edge of a. How far apart "
             "are the centres when edge meets edge?"},
            {"first-radius-twice", root(&p, 2.0 * p.a.radius, -1.0),
             "That would be right for two disks like a. How large is b?"},
            {"one-falls", wrong ? one_falls(&p, p.g) : expected,
             "Here b falls and a does not. What does gravity do to the "
             "distance of two bodies that both fall?"},
            {"one-falls", wrong ? one_falls(&p, -p.g) : expected,
             "Here a falls and b does not. What does gravity do to the "
             "distance of two bodies that both fall?"}});
}

/* Any number at all is a meeting, and 0 is one too. */
static void check_never(struct pair p)
{
    static const char passing[] =
        "The disks pass each other at a distance. What does a negative "
        "number under the square root mean?";
    const double got = answer(&p).time;
    const double told = got == 0.0 ? -1.0 : got;
    CHECK_NEAR(
        got == INFINITY ? 0.0 : told,
        .quantity = "0 if they never touch, -1 if they meet now, or else "
                    "the time until they touch",
        .because = "never is never",
        .mistakes = {
            {"root-of-a-negative", CHECK_NAN,
             "Not a number: they pass each other, or move alike. What "
             "stands under your square root, or below your fraction?"},
            {"touching-is-meeting", -1.0,
             "They touch and do not approach, as two that have just "
             "collided. If they met now, when would they meet next?"},
            {"parting-pairs-meet", met(&p, -1.0),
             "This is when they would have touched in the past; now they "
             "part. Which sign tells the two cases apart?"},
            {"parting-pairs-meet", met(&p, 1.0),
             "This is the other root. They part, or do not approach at "
             "all: is one of the roots a meeting?"},
            {"missed-but-met", missing(&p, false), passing},
            {"missed-but-met", missing(&p, true), passing}});
}

static void check_now(struct pair p)
{
    static const char lost[] =
        "They touch, or overlap by a rounding, and approach; your function "
        "lets them pass through each other. What decides whether they "
        "collide: the gap or the approach?";
    const double got = answer(&p).time;
    check_meets(got, "contact-lost", lost);
    CHECK_NEAR(
        got, .quantity = quantity, .unit = "s",
        .because = "two that touch and approach meet now",
        .mistakes = {
            {"time-in-the-past", root(&p, touching(&p), -1.0),
             "A rounding has let them overlap, and the time would be in "
             "the past. Can your program go back? When can they still "
             "collide?"},
            {"second-root", root(&p, touching(&p), 1.0),
             "At this time they would have passed through each other. What "
             "should become of two that touch and approach?"}});
}

static void check_height(struct pair p, double expected)
{
    const double t = root(&p, touching(&p), -1.0);
    const double part = p.a.radius / touching(&p);
    const double y = p.a.y + part * (p.b.y - p.a.y);
    const double vy = p.a.vy + part * (p.b.vy - p.a.vy);
    const double fallen = 0.5 * p.g * t * t;
    const double middle =
        0.5 * (p.a.y + p.b.y + (p.a.vy + p.b.vy) * t) - fallen;
    const double fast = fabs(p.a.vy) + fabs(p.b.vy) + p.g * t;
    CHECK_NEAR(
        answer(&p).height, .quantity = "*height, where the two touch",
        .unit = "m", .expected = expected,
        .tolerance =
            16.0 * DBL_EPSILON * (fabs(p.a.y) + fabs(p.b.y) + fast * t) +
            fast * tolerance(&p),
        .because = "16 epsilons of the heights and the ways, and what the "
                   "time may err by",
        .equation = "eq:pair-quadratic",
        .mistakes = {
            {"height-without-gravity", expected + fallen,
             "Gravity does not change when they meet. Does it change "
             "where?"},
            {"gravity-not-halved", expected - fallen,
             "How far does a stone fall in one second?"},
            {"gravity-upwards", expected + 2.0 * fallen,
             "The disks fall upwards here. Which way does g point?"},
            {"height-of-now", y,
             "This is the height now. They touch later: how have the "
             "centres moved until then?"},
            {"centre-for-contact", p.a.y + p.a.vy * t - fallen,
             "This is the height of the centre of a. Where do the two "
             "edges touch?"},
            {"middle-of-the-centres", middle,
             "This is half way between the centres. To which of them is "
             "the point of contact nearer when one disk is larger?"},
            {"radii-exchanged", 2.0 * middle - y - vy * t + fallen,
             "This point is at the distance of the radius of b from the "
             "centre of a. Which radius leads from the centre of a to the "
             "contact?"},
            {"left-empty", CHECK_EMPTY,
             "Not a number: was something put into *height?"}});
}

static void test_along_a_line(void)
{
    check_ask("The disks are on one line. How large is the gap between "
              "their edges, and how fast does it shrink?");
    check_time(
        PAIR(0.0, {0.0, 0.0, 0.5, 0.0, 0.5}, {6.0, 0.0, -1.5, 0.0, 1.5}),
        2.0);
    check_time(
        PAIR(0.0, {1.0, 7.0, 0.0, -3.0, 2.0}, {1.0, 1.0, 0.0, -1.0, 1.0}),
        1.5);
}

/* Triangles with the sides 3, 4, 5 and 5, 12, 13. */
static void test_in_the_plane(void)
{
    check_ask("Draw disk a at rest and the path of disk b past it. Where "
              "is its centre when the edges touch?");
    check_time(
        PAIR(0.0, {0.0, 0.0, 0.0, 0.0, 2.0}, {7.0, 4.0, -1.0, 0.0, 3.0}),
        4.0);
    check_time(PAIR(0.0, {2.0, -1.0, 3.0, 0.5, 10.0},
                    {-3.0, -21.0, 3.0, 2.5, 3.0}),
               4.0);
}

/* One disk is let fall at the moment when another is thrown at it, from
   straight below and from the side. */
static void test_with_gravity(void)
{
    check_ask("Both fall alike. What does gravity do to the way from the "
              "one to the other?");
    static const struct pair p[] = {
        {10.0, {2.0, 0.0, 0.0, 20.0, 0.25}, {2.0, 11.0, 0.0, 0.0, 0.75}},
        {10.0, {0.0, 0.0, 3.0, 4.0, 0.25}, {6.0, 8.0, 0.0, 0.0, 0.75}},
        {9.81, {0.0, 0.0, 0.0, 0.0, 2.0}, {7.0, 4.0, -1.0, 0.0, 3.0}}};
    check_time(p[0], 0.5);
    check_time(p[1], 1.8);
    check_time(p[2], 4.0);
}

static void test_never(void)
{
    check_ask("These two never touch. What is the sign of d.u, and what "
              "stands under the square root?");
    check_never(
        PAIR(9.81, {0.0, 0.0, 0.0, 0.0, 1.0}, {9.0, 4.0, -2.0, 0.0, 2.0}));
    check_never(
        PAIR(9.81, {0.0, 0.0, -1.0, 0.0, 1.0}, {5.0, 0.0, 1.0, 0.0, 2.0}));
    check_never(
        PAIR(9.81, {0.0, 0.0, 2.0, 1.0, 1.0}, {5.0, 0.0, 2.0, 1.0, 2.0}));
    check_never(
        PAIR(9.81, {0.0, 0.0, 0.0, 0.0, 1.0}, {0.0, 5.0, 3.0, 0.0, 2.0}));
}

static struct pair in_contact(double overlap, double u, double w)
{
    return PAIR(9.81, {1.0, 2.0, 0.25, 0.5, 2.0},
                {4.0 - overlap, 6.0, 0.25 + u, 0.5 + w, 3.0});
}

static const double hair = 16.0 * DBL_EPSILON;

static void test_touching(void)
{
    check_ask("The disks touch, or overlap by a rounding. What do their "
              "velocities say?");
    check_now(in_contact(0.0, -1.0, 0.0));
    check_now(in_contact(0.0, 2.0, -2.0));
    check_now(in_contact(hair, -1.0, 0.0));
    check_now(in_contact(hair, 2.0, -2.0));
}

static void test_touching_and_parting(void)
{
    check_ask("The disks touch, or overlap by a rounding, and do not "
              "approach. What was to be returned?");
    check_never(in_contact(0.0, 1.0, 0.0));
    check_never(in_contact(hair, 0.5, 0.5));
    check_never(in_contact(0.0, 4.0, -3.0));
    check_never(in_contact(0.0, 0.0, 0.0));
    check_never(in_contact(hair, 0.0, 0.0));
}

static void test_height(void)
{
    check_ask("Where are the two centres at that time, and where between "
              "them is the point of contact?");
    check_height(
        PAIR(0.0, {1.0, 1.0, 0.0, 1.0, 1.0}, {1.0, 8.0, 0.0, -1.0, 3.0}),
        3.5);
    check_height(
        PAIR(10.0, {0.0, 2.0, 3.0, 4.0, 0.25}, {6.0, 10.0, 0.0, 0.0, 0.75}),
        2.0 + 7.2 + 0.2 - 16.2);
    check_height(
        PAIR(2.0, {0.0, 0.0, 0.0, 2.0, 2.0}, {7.0, 4.0, -1.0, 2.0, 3.0}),
        8.0 - 16.0 + 1.6);
}

/* Two that touch already: the contact is where it is. */
static void test_height_now(void)
{
    const struct pair p = in_contact(0.0, -1.0, 0.0);
    CHECK_NEAR(
        answer(&p).height, .quantity = "*height, where the two touch",
        .unit = "m", .expected = 3.6, .tolerance = 16.0 * DBL_EPSILON * 8.0,
        .because = "16 epsilons of the heights",
        .question =
            "They touch now. How far is the contact from either centre?",
        .mistakes = {{"left-empty", CHECK_EMPTY,
                      "Not a number: was something put into *height in "
                      "this case as well?"}});
}

/* The same two, seen by somebody who moves, on planets of all sizes; no
   round numbers. */
CHECK_TIMES(12, test_falling_along, i)
{
    static const struct pair still = {0.0,
                                      {0.31, 0.77, 0.0, 0.0, 0.13},
                                      {1.93, 1.41, -0.57, -0.23, 0.29}};
    const double expected = root(&still, touching(&still), -1.0);
    struct pair p = still;
    const double vx = 0.7 * (i - 5), vy = 0.3 * i;
    p.g = 3.7 * i;
    p.a.vx += vx, p.a.vy += vy;
    p.b.vx += vx, p.b.vy += vy;
    CHECK_NEAR(answer(&p).time, .quantity = quantity, .unit = "s",
               .expected = expected, .tolerance = 16.0 * tolerance(&p),
               .because = "the roundings of velocities 16 times as large "
                          "as their difference",
               .equation = "eq:pair-quadratic",
               .question = "Somebody who falls along sees the same "
                           "meeting. Which of your numbers minds?");
}

/* Positions with few binary digits: the distance, its square and the square
   of the contact distance are exact, and so is their difference. What is
   left is a handful of roundings. */
/* limit: 1p-26 of the distance */
/* limit: 1e-13 (13 digits) */
static void test_small_gaps(void)
{
    for (int power = 26; power >= 18; power -= 2) {
        const double gap = ldexp(1.0, -power), speed = 0.7;
        const struct pair p = {9.81,
                               {0.0, 2.0, 0.0, 0.0, 0.25},
                               {1.0 + gap, 2.0, -speed, 0.0, 0.75}};
        const struct quadratic q = quadratic(&p, 1.0);
        const double naive = root(&p, 1.0, -1.0), v = sqrt(q.v2);
        const double in_parts =
            -q.b / q.v2 - sqrt(q.b * q.b / q.v2 / q.v2 - q.c / q.v2);
        const double in_lengths =
            (-q.b / v - sqrt(q.b * q.b / q.v2 - q.c)) / v;
        const double expected = gap / speed;
        static const char hint[] =
            "Digits are gone: the time is short, and it was made as the "
            "difference of two long ones. Which form of the root takes a "
            "sum instead?";
        CHECK_NEAR(
            answer(&p).time, .quantity = quantity, .unit = "s",
            .expected = expected, .tolerance = 1e-13 * expected,
            .because = "13 digits: the gap, the radii and their squares "
                       "are exact here",
            .question =
                "The gap is small. How many digits does your formula keep?",
            .mistakes = {{"digits-cancelled", naive, hint},
                         {"digits-cancelled", in_parts, hint},
                         {"digits-cancelled", in_lengths, hint}});
    }
}

/* A meeting drawn from its end: where the two touch, which way the contact
   looks from a to b, and how b moves past a then, by no more than a slant
   off the straight way towards it. */
struct meeting {
    struct pair p;
    double time, height;
};

/* Before they meet, both have flown and fallen for that time. */
static void fly_back(struct thrown *d, double g, double time)
{
    d->x -= d->vx * time;
    d->y -= (d->vy + 0.5 * g * time) * time;
    d->vy += g * time;
}

static struct meeting draw_meeting(void)
{
    struct meeting m;
    const double contact = check_draw(-3.1416, 3.1416);
    const double past = contact + check_draw(-1.4, 1.4);
    const double x = cos(contact), y = sin(contact);
    const double u = check_draw(0.2, 8.0), w = check_draw(-9.0, 9.0);
    m.time = check_draw(0.05, 2.0);
    m.height = check_draw(-9.0, 9.0);
    m.p.g = check_draw_whole(0, 3) ? check_draw(0.5, 20.0) : 0.0;
    m.p.a.radius = check_draw(0.05, 2.0);
    m.p.b.radius = check_draw(0.05, 2.0);
    m.p.a.x = -m.p.a.radius * x;
    m.p.a.y = m.height - m.p.a.radius * y;
    m.p.b.x = m.p.b.radius * x;
    m.p.b.y = m.height + m.p.b.radius * y;
    m.p.a.vx = check_draw(-9.0, 9.0);
    m.p.a.vy = w;
    m.p.b.vx = m.p.a.vx - u * cos(past);
    m.p.b.vy = w - u * sin(past);
    fly_back(&m.p.a, m.p.g, m.time);
    fly_back(&m.p.b, m.p.g, m.time);
    return m;
}

CHECK_TIMES(40, test_drawn, i)
{
    check_ask("This meeting was drawn backwards from the contact. Where "
              "are the two at the time that you found?");
    const struct meeting m = draw_meeting();
    check_time(m.p, m.time);
    check_height(m.p, m.height);
}

/* Lengths and velocities a thousandth of what they were. */
static struct thrown small(struct thrown d)
{
    const double k = 1.0 / 1024.0;
    return (struct thrown){k * d.x, k * d.y, k * d.vx, k * d.vy,
                           k * d.radius};
}

/* In place of touching they pass at a distance, or have met already. */
CHECK_TIMES(40, test_drawn_never, i)
{
    check_ask("These two were drawn so that they pass each other, or part. "
              "Which of the two do you take for a meeting?");
    struct meeting m = draw_meeting();
    struct thrown *b = &m.p.b;
    if (i % 2) { /* moving apart, and just as fast */
        b->vx = 2.0 * m.p.a.vx - b->vx;
        b->vy = 2.0 * m.p.a.vy - b->vy;
    } else { /* beside the line on which b would come to a's centre */
        const double u = b->vx - m.p.a.vx, w = b->vy - m.p.a.vy;
        const double far = touching(&m.p) * check_draw(1.1, 5.0);
        const double beside = far / hypot(u, w);
        b->x = m.p.a.x - u * m.time + w * beside;
        b->y = m.p.a.y - w * m.time - u * beside;
    }
    if (i % 4 < 2)
        m.p = PAIR(m.p.g, small(m.p.a), small(m.p.b));
    check_never(m.p);
}

/* In contact to the last bit: right triangles with whole sides. */
CHECK_TIMES(40, test_drawn_contact, i)
{
    check_ask("The distance is just the sum of the radii. What do the "
              "velocities say: do they approach?");
    static const int side[][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}};
    const int *const s = side[check_draw_whole(0, 2)];
    const int swap = check_draw_whole(0, 1);
    const int x = s[swap] * (check_draw_whole(0, 1) ? 1 : -1);
    const int y = s[1 - swap] * (check_draw_whole(0, 1) ? 1 : -1);
    const int part = check_draw_whole(1, s[2] - 1);
    const int u = check_draw_whole(-9, 9), w = check_draw_whole(-9, 9);
    const struct thrown a = {
        check_draw_whole(-9, 9), check_draw_whole(-9, 9),
        check_draw_whole(-9, 9), check_draw_whole(-9, 9), part};
    const struct thrown b = {a.x + x, a.y + y, a.vx + u, a.vy + w,
                             s[2] - part};
    const struct pair p = {check_draw(0.0, 20.0), a, b};
    if (x * u + y * w < 0)
        check_now(p);
    else
        check_never(p);
}

const struct check_suite check_suite = {
    .file = "05b-falling.c",
    .title = "Two disks that fall",
    .minutes = 25,
    .equation = "eq:pair-time",
    .tests =
        {{"on a line the gap closes at the relative speed",
          test_along_a_line, 1, 0},
         {"in the plane they meet as drawn by hand", test_in_the_plane, 2,
          0},
         {"gravity does not change when they meet", test_with_gravity, 1,
          0},
         {"some never meet", test_never, 1, 0},
         {"two that touch and approach meet now", test_touching, 1, 0},
         {"two that touch and part do not meet", test_touching_and_parting,
          1, 0},
         {"they touch at the height worked out by hand", test_height, 2, 0},
         {"two in contact touch where they are", test_height_now, 1, 0},
         {"whoever falls along sees the same", test_falling_along, 1, 0},
         {"a small gap costs no digits", test_small_gaps, 2, 0},
         {"meetings drawn happen where they were drawn from", test_drawn, 3,
          3},
         {"pairs drawn to miss each other never meet", test_drawn_never, 2,
          2},
         {"pairs drawn in contact meet now or never", test_drawn_contact, 1,
          1},
         {0}},
    .idle = {test_touching},
};
