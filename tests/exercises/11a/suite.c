/* The suite of exercise 11a, "Push two spheres apart". */

#include "examiner/check.h"
#include "call.h"

/* Two spheres before, and where they belong. */
struct pair {
    struct sphere a, b;
    double a_after[3], b_after[3], depth;
};

struct answer {
    struct sphere a, b;
    double depth;
};

static struct answer answer(const struct pair *p)
{
    struct answer r = {p->a, p->b, NAN};
    r.depth = part_spheres(&r.a, &r.b);
    return r;
}

static const char *sphere_text(const struct sphere *s)
{
    return check_text("%g kg, radius %g m, at (%g, %g, %g) m", s->mass,
                      s->radius, s->x[0], s->x[1], s->x[2]);
}

static const char *input(const struct pair *p)
{
    return check_text("a: %s; b: %s", sphere_text(&p->a),
                      sphere_text(&p->b));
}

/* What rounds: the centres themselves, and the lengths between them. */
static double tolerance(const struct pair *p)
{
    double most = p->a.radius + p->b.radius;
    for (int k = 0; k < 3; ++k)
        most = fmax(most, fmax(fabs(p->a.x[k]), fabs(p->b.x[k])));
    return 8.0 * DBL_EPSILON * most;
}

static const char because[] =
    "8 epsilons of the largest of coordinates and radii";

/* Coordinate k of one of the two, with its mass and radius and those of the
   other. */
static void check_centre(const struct pair *p, bool first, double got,
                         int k)
{
    const struct sphere *own = first ? &p->a : &p->b;
    const struct sphere *other = first ? &p->b : &p->a;
    const double right = first ? p->a_after[k] : p->b_after[k];
    const double from = own->x[k], way = right - from;
    const double opposite =
        (first ? p->b_after[k] : p->a_after[k]) - other->x[k];
    const double whole = way - opposite;
    const double reach = own->radius + other->radius;
    CHECK_NEAR(
        got,
        .quantity =
            check_text("%s->x[%d], the centre of %s along %c",
                       first ? "a" : "b", k, first ? "a" : "b", "xyz"[k]),
        .unit = "m", .input = input(p), .expected = right,
        .tolerance = tolerance(p), .because = because,
        .mistakes = {
            {"own-mass", from - opposite,
             "The heavier one has gone further here. What has each mass to "
             "do with its way, if the centre of mass is to stay?"},
            {"equal-shares", from + 0.5 * whole,
             "Both have gone equally far. Where is the centre of mass when "
             "one is heavier?"},
            {"shares-by-radius", from + own->radius / reach * whole,
             "The larger one has gone further, as in the article. What do "
             "the radii say about the centre of mass?"},
            {"towards-each-other", first ? from - way : right,
             "The way is right, and its direction is not. Does the "
             "distance grow?"},
            {"both-the-whole-way", from + whole,
             "This one has gone the whole way. Does the other one move as "
             "well, and how far are they apart then?"},
            {"one-alone", from,
             "This one has not moved. Who is to stay when one is pushed: "
             "the other sphere, or the centre of mass?"},
            {"same-side", first ? right : from - way,
             "Both have gone to the same side. Does the distance grow, and "
             "what of the centre of mass?"},
            {"line-too-long", from + way * (reach - p->depth),
             "The way is too long or too short by the distance of the "
             "centres. How long is the vector that gives the direction?"}});
}

/* What should have stayed as it is. */
static void check_kept(const struct pair *p, bool first, double got, int k)
{
    const double right = first ? p->a.x[k] : p->b.x[k];
    CHECK_NEAR(got,
               .quantity = check_text(
                   "%s->x[%d], the centre of %s along %c",
                   first ? "a" : "b", k, first ? "a" : "b", "xyz"[k]),
               .unit = "m", .input = input(p), .expected = right,
               .because = "not a bit of it should change");
}

static bool is_finite(const struct sphere *s)
{
    return isfinite(s->x[0]) && isfinite(s->x[1]) && isfinite(s->x[2]);
}

static void check_finite(const struct pair *p, const struct answer *r)
{
    bool line = false;
    for (int k = 0; k < 3; ++k)
        line |= p->a.x[k] != p->b.x[k];
    const bool good = is_finite(&r->a) && is_finite(&r->b);
    const double no = good ? 0.0 : 1.0;
    CHECK_NEAR(
        no,
        .quantity =
            "is there a coordinate that is no number? (1 yes, 0 no)",
        .input = input(p), .because = "yes or no",
        .question = "Where does something come from that is no number?",
        .mistakes = {{"no-line", line ? 0.0 : 1.0,
                      "At the same place there is no line from one centre "
                      "to the other. What do you divide by, and what did "
                      "the exercise ask for?"},
                     {"infinity-over-infinity",
                      isinf(p->a.mass) || isinf(p->b.mass) ? 1.0 : 0.0,
                      "What is INFINITY over INFINITY? Make one mass "
                      "larger and larger: what become the two shares?"}});
}

static void check_pair(const struct pair *p)
{
    const struct answer r = answer(p);
    check_finite(p, &r);
    for (int k = 0; k < 3; ++k)
        check_centre(p, true, r.a.x[k], k);
    for (int k = 0; k < 3; ++k)
        check_centre(p, false, r.b.x[k], k);
}

static void check_depth(const struct pair *p)
{
    const double right = p->depth, sum = p->a.mass + p->b.mass;
    CHECK_NEAR(answer(p).depth, .quantity = "depth of the overlap",
               .unit = "m", .input = input(p), .expected = right,
               .tolerance = tolerance(p), .because = because,
               .mistakes = {{"share-for-the-depth", right * p->b.mass / sum,
                             "This is the way of one of the two. How deep "
                             "was the overlap?"}});
}

/* On the axis k, with the centres 1.5 m apart and 3 m from one to the other
   at contact. */
static struct pair on_axis(int k, double sign, double ma, double mb)
{
    struct pair p = {.a = {ma, 1.75, {0.5, 1.0, -2.0}},
                     .b = {mb, 1.25, {0.5, 1.0, -2.0}},
                     .depth = 1.5};
    p.b.x[k] += 1.5 * sign;
    for (int i = 0; i < 3; ++i) {
        p.a_after[i] = p.a.x[i];
        p.b_after[i] = p.b.x[i];
    }
    p.a_after[k] -= sign * 1.5 * (mb / (ma + mb));
    p.b_after[k] += sign * 1.5 * (ma / (ma + mb));
    return p;
}

CHECK_TIMES(3, test_equal, k)
{
    const struct pair p = on_axis(k, 1.0, 2.0, 2.0);
    const struct pair q = on_axis(k, -1.0, 2.0, 2.0);
    check_ask("Two equal masses: how far must each go, and to which side?");
    check_pair(&p);
    check_pair(&q);
}

CHECK_TIMES(3, test_masses, i)
{
    static const double mass[][2] = {{3.0, 1.0}, {1.0, 7.0}, {0.1, 100.0}};
    for (int k = 0; k < 3; ++k) {
        const struct pair p = on_axis(k, 1.0, mass[i][0], mass[i][1]);
        const struct pair q = on_axis(k, -1.0, mass[i][0], mass[i][1]);
        check_ask("A heavy one and a light one: which of them goes "
                  "further, so that the centre of mass stays?");
        check_pair(&p);
        check_pair(&q);
    }
}

/* A large light one and a small heavy one. */
static void test_radii(void)
{
    check_ask(
        "The radii say how deep the overlap is. What else do they say?");
    const struct pair p = {.a = {1.0, 4.0, {0.0, 0.0, 0.0}},
                           .b = {3.0, 0.5, {0.0, 3.5, 0.0}},
                           .a_after = {0.0, -0.75, 0.0},
                           .b_after = {0.0, 3.75, 0.0},
                           .depth = 1.0};
    const struct pair inside = {.a = {1.0, 4.0, {0.0, 0.0, 0.0}},
                                .b = {1.0, 0.5, {0.5, 0.0, 0.0}},
                                .a_after = {-2.0, 0.0, 0.0},
                                .b_after = {2.5, 0.0, 0.0},
                                .depth = 4.0};
    check_pair(&p);
    check_pair(&inside);
}

/* 3, 4 and 5 make a right angle; 2, 3, 6 and 7 make squares. */
static void test_oblique(void)
{
    check_ask("The line from centre to centre is oblique: is its length "
              "that of its vector, or 1?");
    const struct pair p = {.a = {2.0, 4.0, {1.0, 1.0, 1.0}},
                           .b = {8.0, 2.0, {4.0, 5.0, 1.0}},
                           .a_after = {0.52, 0.36, 1.0},
                           .b_after = {4.12, 5.16, 1.0},
                           .depth = 1.0};
    const struct pair q = {.a = {1.0, 7.0, {2.0, 3.0, 6.0}},
                           .b = {1.0, 7.0, {0.0, 0.0, 0.0}},
                           .a_after = {3.0, 4.5, 9.0},
                           .b_after = {-1.0, -1.5, -3.0},
                           .depth = 7.0};
    check_pair(&p);
    check_pair(&q);
}

/* Whatever the formula: they touch, and the centre of mass stays. */
static void test_touch(void)
{
    struct pair p = {.a = {1.5, 0.75, {0.5, -1.0, 2.0}},
                     .b = {4.0, 1.0, {1.0, -0.25, 1.5}}};
    const struct answer r = answer(&p);
    double square = 0.0;
    for (int k = 0; k < 3; ++k) {
        const double d = r.b.x[k] - r.a.x[k];
        square += d * d;
        CHECK_NEAR((1.5 * r.a.x[k] + 4.0 * r.b.x[k]) / 5.5,
                   .quantity =
                       check_text("the centre of mass along %c", "xyz"[k]),
                   .unit = "m", .input = input(&p),
                   .expected = (1.5 * p.a.x[k] + 4.0 * p.b.x[k]) / 5.5,
                   .tolerance = tolerance(&p), .because = because,
                   .question = "By how much is m1 x1 + m2 x2 changed by "
                               "one of the two ways, and by the other?");
    }
    CHECK_NEAR(sqrt(square), .quantity = "distance of the centres",
               .unit = "m", .input = input(&p), .expected = 1.75,
               .tolerance = tolerance(&p), .because = because,
               .question = "How far are two spheres apart that touch?");
}

static void check_unchanged(const struct pair *p, double gap)
{
    check_ask("These two do not overlap. Who has moved them?");
    const struct answer r = answer(p);
    const bool moved = r.a.x[0] != p->a.x[0] || r.b.x[0] != p->b.x[0];
    CHECK_NEAR(
        r.depth, .quantity = "depth of the overlap", .unit = "m",
        .input = input(p), .because = "there is none",
        .mistakes = {{"pulled-together", moved ? r.depth : 0.0,
                      "These two are apart, and have been pulled together. "
                      "What is to be done when nothing overlaps?"},
                     {"depth-below-zero", moved ? 0.0 : gap,
                      "The gap is taken for a negative depth. How deep is "
                      "an overlap of spheres that are apart?"}});
    for (int k = 0; k < 3; ++k) {
        check_kept(p, true, r.a.x[k], k);
        check_kept(p, false, r.b.x[k], k);
    }
}

static void test_apart(void)
{
    const struct pair apart = {.a = {1.0, 0.5, {0.1, 0.2, 0.3}},
                               .b = {3.0, 0.25, {3.1, 4.2, 0.3}}};
    const struct pair touch = {.a = {1.0, 2.0, {0.0, 0.0, 0.0}},
                               .b = {3.0, 5.0, {2.0, -3.0, 6.0}}};
    const struct pair points = {.a = {1.0, 0.0, {0.7, 0.0, 0.0}},
                                .b = {3.0, 0.0, {0.7, 0.0, 0.0}}};
    check_unchanged(&apart, 0.75 - 5.0);
    check_unchanged(&touch, 0.0);
    check_unchanged(&points, 0.0);
}

/* limit: 1e-100 m (and the very same place) */
static void test_same_place(void)
{
    const struct pair p = {.a = {1.0, 0.75, {0.5, 2.0, -1.0}},
                           .b = {3.0, 1.25, {0.5, 2.0, -1.0}},
                           .a_after = {-1.0, 2.0, -1.0},
                           .b_after = {1.0, 2.0, -1.0},
                           .depth = 2.0};
    const struct pair near = {.a = {1.0, 0.75, {0.0, 0.0, 0.0}},
                              .b = {3.0, 1.25, {0.0, 0.0, 1e-100}},
                              .a_after = {0.0, 0.0, -1.5},
                              .b_after = {0.0, 0.0, 0.5},
                              .depth = 2.0};
    check_ask("At the same place: which way was a to go, and which way b?");
    check_pair(&p);
    check_depth(&p);
    check_ask("The centres are very near each other, and still there is a "
              "line from one to the other. What do you compare with 0?");
    check_pair(&near);
}

CHECK_TIMES(3, test_immovable, k)
{
    check_ask(
        "One of them cannot be moved. How far must the other one go?");
    const struct pair heavy_a = {.a = {INFINITY, 1.75, {0.1, 0.7, 0.3}},
                                 .b = {2.0, 1.25, {0.1, -1.3, 0.3}},
                                 .a_after = {0.1, 0.7, 0.3},
                                 .b_after = {0.1, -2.3, 0.3},
                                 .depth = 1.0};
    const struct pair heavy_b = {.a = {2.0, 1.75, {2.0, 3.0, 6.0}},
                                 .b = {INFINITY, 12.25, {0.0, 0.0, 0.0}},
                                 .a_after = {4.0, 6.0, 12.0},
                                 .depth = 7.0};
    const struct pair both = {.a = {INFINITY, 1.0, {0.1, 0.7, 0.3}},
                              .b = {2.0, 1.0, {0.1, 0.7, 0.3}},
                              .a_after = {0.1, 0.7, 0.3},
                              .b_after = {2.1, 0.7, 0.3},
                              .depth = 2.0};
    check_pair(&heavy_a);
    check_pair(&heavy_b);
    check_pair(&both);
    const struct answer a = answer(&heavy_a), b = answer(&heavy_b);
    check_kept(&heavy_a, true, a.a.x[k], k);
    check_kept(&heavy_b, false, b.b.x[k], k);
}

static void test_depth(void)
{
    check_ask("How far apart should the centres be, and how far are they?");
    const struct pair p = on_axis(1, 1.0, 3.0, 1.0);
    const struct pair q = {.a = {1.0, 2.0, {1.0, 1.0, 1.0}},
                           .b = {2.0, 7.5, {3.0, 4.0, 7.0}},
                           .depth = 2.5};
    const struct pair heavy = {.a = {INFINITY, 3.0, {0.0, 0.0, 0.0}},
                               .b = {2.0, 0.5, {0.0, 3.0, 0.0}},
                               .depth = 0.5};
    check_depth(&p);
    check_depth(&q);
    check_depth(&heavy);
}

/* Whole numbers whose squares add up to a square, from any four; returns
   the root, which is the length of the vector d. */
static double draw_line(double d[3])
{
    double w, x, y, z;
    do {
        w = check_draw_whole(-4, 4);
        x = check_draw_whole(-4, 4);
        y = check_draw_whole(-4, 4);
        z = check_draw_whole(-4, 4);
    } while (w * w + x * x + y * y + z * z == 0.0);
    d[0] = 2.0 * (w * y + x * z);
    d[1] = 2.0 * (y * z - w * x);
    d[2] = w * w + z * z - x * x - y * y;
    return w * w + x * x + y * y + z * z;
}

/* A pair whose centres are `length` apart along a drawn line, and whose
   radii add up to `part` times as much; where the two belong is told from
   the centre of mass. */
static struct pair draw_pair(double part)
{
    struct pair p = {.a = {.mass = check_draw(0.1, 9.0)},
                     .b = {.mass = check_draw(0.1, 9.0)}};
    double d[3];
    const double size = ldexp(1.0, check_draw_whole(-5, 5));
    const double length = draw_line(d) * size;
    const double sum = p.a.mass + p.b.mass;
    const double reach = part * length;
    p.a.radius = reach * check_draw(0.01, 0.99);
    p.b.radius = reach - p.a.radius;
    p.depth = p.a.radius + p.b.radius - length;
    for (int k = 0; k < 3; ++k) {
        p.a.x[k] = check_draw_whole(-50, 50) * size;
        p.b.x[k] = p.a.x[k] + d[k] * size;
        const double centre =
            (p.a.mass * p.a.x[k] + p.b.mass * p.b.x[k]) / sum;
        const double line = d[k] * size / length * reach;
        p.a_after[k] = centre - p.b.mass / sum * line;
        p.b_after[k] = centre + p.a.mass / sum * line;
    }
    return p;
}

CHECK_TIMES(40, test_drawn, i)
{
    const struct pair p = draw_pair(check_draw(1.01, 5.0));
    check_ask("Any two that overlap: do they touch afterwards, with the "
              "centre of mass in its place?");
    check_pair(&p);
    check_ask("How deep was it?");
    check_depth(&p);
}

CHECK_TIMES(20, test_drawn_apart, i)
{
    const struct pair p = draw_pair(check_draw(0.1, 0.99));
    check_unchanged(&p, p.depth);
}

const struct check_suite check_suite = {
    .file = "11a-apart.c",
    .title = "Push two spheres apart",
    .minutes = 20,
    .equation = "eq:push",
    .tests =
        {{"equal masses go equally far", test_equal, 1, 0},
         {"the lighter one goes further", test_masses, 2, 0},
         {"the radii do not decide who yields", test_radii, 2, 0},
         {"they go along the line of their centres", test_oblique, 2, 0},
         {"they touch, and the centre of mass stays", test_touch, 1, 0},
         {"what does not overlap is left alone", test_apart, 2, 0},
         {"at the same place they part along x", test_same_place, 1, 0},
         {"what cannot be moved is not moved", test_immovable, 2, 0},
         {"the depth is told", test_depth, 1, 0},
         {"any two that overlap", test_drawn, 2, 2},
         {"any two that do not", test_drawn_apart, 1, 1},
         {0}},
    .idle = {test_apart, test_drawn_apart},
};
