/* The suite of exercise 01d, "Taking aim". */

#include "examiner/check.h"
#include "call.h"

static double pi(void)
{
    return acos(-1.0);
}

struct shot {
    double r1, r2, im1, im2;
    double deflection;
};

static const char *input(struct shot s)
{
    return check_text("r1 = %g m, r2 = %g m, im1 = %g /kg, im2 = %g /kg, "
                      "deflection = %.10g rad (%.6g degrees)",
                      s.r1, s.r2, s.im1, s.im2, s.deflection,
                      s.deflection * 180.0 / pi());
}

static double aim(struct shot s)
{
    return impact_parameter(s.r1, s.r2, s.im1, s.im2, s.deflection);
}

/* The deflection of a blow whose line of centres makes the angle phi with
   the way of the first disk: the blow takes its speed along that line. */
static double deflection_at(double phi, double im1, double im2)
{
    const double blow = 2.0 * im1 / (im1 + im2) * cos(phi);
    return atan2(blow * sin(phi), 1.0 - blow * cos(phi));
}

/* How much the angles magnify a rounding: without bound at the largest
   deflection. */
static double tolerance(struct shot s)
{
    const double sine = s.im2 / s.im1 * sin(s.deflection);
    const double steep = sine < 1.0 ? 1.0 / sqrt(1.0 - sine * sine) : 1.0;
    return 8.0 * DBL_EPSILON * (s.r1 + s.r2) * (1.0 + steep);
}

/* What the formula gives for the mass ratio m1/m2, whatever it is worth. */
static double formula(struct shot s, double ratio, bool harder)
{
    const double side = asin(ratio * sin(s.deflection));
    const double turn = s.deflection + (harder ? pi() - side : side);
    return (s.r1 + s.r2) * cos(0.5 * turn);
}

/* A slip that has no answer here stands aside for the expected one. */
static double known(double value, double expected)
{
    return isnan(value) ? expected : value;
}

/* What the formula gives when the angle is taken in the wrong unit. */
static double in_unit(struct shot s, double unit)
{
    s.deflection *= unit;
    return formula(s, s.im2 / s.im1, false);
}

static const char degrees[] =
    "The deflection is given in radians already, and sin() and cos() take "
    "radians. How large is a right angle then? What becomes of it on its "
    "way through your function?";

static void check_aim(struct shot s, double expected)
{
    const double ratio = s.im2 / s.im1, both = s.r1 + s.r2;
    const double cosine = formula(s, ratio, false) / both;
    CHECK_NEAR(
        aim(s), .quantity = "impact parameter b", .unit = "m",
        .input = input(s), .expected = expected, .tolerance = tolerance(s),
        .because = "8 epsilons of r1 + r2, and more as the largest "
                   "deflection is near",
        .mistakes = {
            {"the-harder-blow",
             ratio > 1.0 ? formula(s, ratio, true) : expected,
             "This aim does turn the disk by that angle, by the harder of "
             "two possible blows. Which one was asked for?"},
            {"one-radius", s.r1 / both * formula(s, ratio, false),
             "The disks touch when their rims meet, not when a rim meets a "
             "centre. How far apart are the centres then?"},
            {"target-held-fast", both * cos(0.5 * s.deflection),
             "This is right for a target that nothing moves. Here it gives "
             "way, and the centre of mass moves. What angle does somebody "
             "see who moves with it?"},
            {"masses-exchanged",
             known(formula(s, 1.0 / ratio, false), expected),
             "The masses have changed places. Which of them over which is "
             "im2/im1?"},
            {"sine-for-cosine", both * sqrt(1.0 - cosine * cosine),
             "A graze would be a head-on blow by this formula. For which "
             "impact parameter is the deflection nothing, for which is it "
             "largest?"},
            {"whole-for-half", both * (2.0 * cosine * cosine - 1.0),
             "The line of centres halves the angle between the way back "
             "and the way on, as it does for a mirror. Which angle in your "
             "formula is still a whole one?"},
            {"degrees-for-radians",
             known(in_unit(s, pi() / 180.0), expected), degrees},
            {"degrees-for-radians",
             known(in_unit(s, 180.0 / pi()), expected), degrees}});
}

static void check_out_of_reach(struct shot s)
{
    CHECK_NEAR(
        aim(s), .quantity = "impact parameter b, or -1", .unit = "m",
        .input = input(s), .expected = -1.0,
        .because = "the answer for an angle out of reach",
        .mistakes = {
            {"out-of-reach", formula(s, s.im2 / s.im1, false),
             "No impact parameter turns this disk so far. Carry out the "
             "blow that your answer proposes: which angle do you get, and "
             "which test was missing?"},
            {"out-of-reach", 0.0,
             "A blow head-on is no answer here: it does not turn the disk "
             "by this angle. What was to be returned when nothing does?"}});
}

static void test_graze(void)
{
    check_ask("A disk that is not turned at all has only been touched in "
              "passing. How far apart do the centres pass?");
    check_aim((struct shot){0.3, 0.2, 1.0, 0.5, 0.0}, 0.5);
}

static void test_fixed(void)
{
    check_ask("Nothing moves this target, so the first disk is reflected "
              "as by a mirror. Where does the line of centres point "
              "between the two ways?");
    check_aim((struct shot){0.3, 0.2, 1.0, 0.0, pi()}, 0.0);
    check_aim((struct shot){0.3, 0.2, 1.0, 0.0, 2.0 * pi() / 3.0}, 0.25);
}

static void test_equal_masses(void)
{
    check_ask(
        "Equal disks leave at a right angle to each other, and the target "
        "leaves along the line of centres. What is left for the first?");
    check_aim((struct shot){0.5, 0.5, 2.0, 2.0, atan2(3.0, 4.0)}, 0.8);
    check_aim((struct shot){0.5, 0.5, 2.0, 2.0, atan2(4.0, 3.0)}, 0.6);
}

static void test_right_angle(void)
{
    check_ask("The moving disk is lighter than the target, which gives way "
              "all the same. What angle does it turn by for somebody who "
              "moves with the centre of mass?");
    check_aim(
        (struct shot){0.25, 0.5, 3.0, 1.0, deflection_at(1.45, 3.0, 1.0)},
        0.75 * sin(1.45));
    check_aim((struct shot){1.0, 3.0, 2.0, 1.0, 0.5 * pi()}, 2.0);
}

/* Carries out the blow with the student's impact parameter. */
static double turned(struct shot s)
{
    const double sine = aim(s) / (s.r1 + s.r2);
    if (!(sine >= 0.0 && sine <= 1.0))
        return 0.0; /* a miss */
    return deflection_at(asin(sine), s.im1, s.im2);
}

static void test_blow(void)
{
    for (int i = 1; i < 12; ++i) {
        const struct shot s = {0.4, 0.7, 1.0, 0.6, pi() * i / 12.0};
        CHECK_NEAR(
            turned(s), .quantity = "deflection by the blow that you aimed",
            .unit = "rad", .input = input(s), .expected = s.deflection,
            .tolerance = 128.0 * DBL_EPSILON,
            .because = "128 epsilons: those of the aim, and an angle up to "
                       "six times as sensitive",
            .question =
                "The blow was carried out with your b, along the line of "
                "centres. For which angles does it come out as wanted?");
    }
}

static void test_heavy(void)
{
    check_ask("A heavy disk can be turned by this angle in two ways. Which "
              "one disturbs it less, and which has the larger b?");
    check_aim(
        (struct shot){0.5, 0.5, 1.0, 3.0, deflection_at(1.2, 1.0, 3.0)},
        sin(1.2));
    check_aim(
        (struct shot){0.5, 0.5, 1.0, 3.0, deflection_at(0.63, 1.0, 3.0)},
        sin(0.63));
    check_aim((struct shot){0.5, 0.5, 1.0, 3.0, 0.0}, 1.0);
}

static void test_out_of_reach(void)
{
    check_ask("A heavy disk ploughs on. What is the largest angle that a "
              "light one can turn it by, and is this one larger?");
    check_out_of_reach((struct shot){0.5, 0.5, 2.0, 2.0, 2.0 * pi() / 3.0});
    check_out_of_reach(
        (struct shot){0.5, 0.5, 1.0, 2.0, 17.0 * pi() / 18.0});
    check_out_of_reach((struct shot){0.5, 0.5, 1.0, 2.0, 2.0 * pi() / 9.0});
}

/* A target that nothing moves is a mirror, and equal disks leave at a right
   angle: in both cases the aim is the cosine of an angle that is given. */
CHECK_TIMES(30, test_drawn_special, i)
{
    const double r1 = check_draw(0.1, 2.0), r2 = check_draw(0.1, 2.0);
    const double im = check_draw(0.2, 5.0);
    const double wide = check_draw(0.6, 3.0);
    const double sharp = check_draw(0.1, 1.4);
    check_ask("Where does a mirror stand that turns a ray by this angle?");
    check_aim((struct shot){r1, r2, im, 0.0, wide},
              (r1 + r2) * sin(0.5 * (pi() - wide)));
    check_ask("Equal disks part at a right angle. In which direction does "
              "the target go, and where was it hit?");
    check_aim((struct shot){r1, r2, im, im, sharp}, (r1 + r2) * cos(sharp));
}

/* Made from the answer: we aim, carry the blow out in more digits, and ask
   for the aim. Where the moving disk is the heavier, a blow is the softer
   one of two if it turns the disk by less than acos(-im1/im2) as seen from
   the centre of mass; we stay well below. */
CHECK_TIMES(40, test_drawn, i)
{
    check_ask("A disk was aimed, hit, and went off at this angle. From "
              "which angle, as seen from the centre of mass, does the "
              "other one come about?");
    struct shot s = {.r1 = check_draw(0.1, 2.0),
                     .r2 = check_draw(0.1, 2.0),
                     .im1 = check_draw(0.2, 5.0),
                     .im2 = check_draw(0.2, 5.0)};
    const double most = s.im2 > s.im1 ? 0.9 * acos(-s.im1 / s.im2) : 2.5;
    const long double phi = 0.5 * (pi() - most * check_draw(0.05, 1.0));
    const long double blow = 2.0L * cosl(phi) / (1.0L + s.im2 / s.im1);
    s.deflection =
        (double)atan2l(blow * sinl(phi), 1.0L - blow * cosl(phi));
    check_aim(s, (double)((s.r1 + s.r2) * sinl(phi)));
}

/* Beyond the largest angle, on the way to pi; for equal disks that is a
   right angle. */
CHECK_TIMES(40, test_drawn_out_of_reach, i)
{
    struct shot s = {.r1 = check_draw(0.1, 2.0),
                     .r2 = check_draw(0.1, 2.0),
                     .im1 = check_draw(0.2, 5.0)};
    s.im2 = i % 5 == 4 ? s.im1 : s.im1 * check_draw(1.01, 8.0);
    const double most = asin(s.im1 / s.im2);
    s.deflection = most + check_draw(0.02, 0.99) * (pi() - most);
    check_ask(check_text("This target can turn the disk by %.4g rad at "
                         "most. Is it asked for more?",
                         most));
    check_out_of_reach(s);
}

const struct check_suite check_suite = {
    .file = "01d-aim.c",
    .title = "Taking aim",
    .minutes = 40,
    .equation = "eq:impulse",
    .tests =
        {{"equal disks leave at a right angle", test_equal_masses, 1, 0},
         {"a disk that only grazes goes straight on", test_graze, 1, 0},
         {"a target that nothing moves is a mirror", test_fixed, 1, 0},
         {"a light disk leaves as worked out by hand", test_right_angle, 1,
          0},
         {"the blow turns the disk by the wanted angle", test_blow, 1, 0},
         {"of two impact parameters the larger is returned", test_heavy, 2,
          0},
         {"an angle out of reach is refused", test_out_of_reach, 2, 0},
         {"thirty mirrors and thirty pairs of equal disks",
          test_drawn_special, 1, 1},
         {"forty blows are aimed again", test_drawn, 1, 2},
         {"forty angles are too large", test_drawn_out_of_reach, 1, 1},
         {0}},
    .idle = {test_graze},
};
