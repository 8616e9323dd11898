/* The suite of exercise 06d, "A push that is handed on". */

#include "examiner/check.h"
#include <string.h>
#include "call.h"

enum { MOST = 16 };

struct box {
    size_t n;
    double sigma, width, height, x[MOST], y[MOST];
    size_t first;
    double length;
};

#define BOX(...) ((struct box){__VA_ARGS__})

/* What somebody may do otherwise. */
struct idea {
    double reach;  /* what stands for sigma, in sigma: 1 */
    bool straight; /* a disk aside is touched like one in front */
    bool stops;    /* the first touch ends the chain */
    bool anew;     /* each disk gets the whole length */
    bool no_x;     /* nobody is seen through the edges along x */
    bool no_y;     /* or across */
    bool outside;  /* places are left outside of the box */
    bool passes;   /* who stands a rounding too near is passed by */
};

static const struct idea right = {1.0,   false, false, false,
                                  false, false, false, false};

/* How far disk i can go until it touches disk j. */
static double room(const struct box *b, struct idea k, size_t i, size_t j)
{
    double along = b->x[j] - b->x[i], across = b->y[j] - b->y[i];
    const double sigma = k.reach * b->sigma;
    if (!k.no_y)
        across -= b->height * round(across / b->height);
    if (!k.no_x)
        along -= b->width * floor(along / b->width);
    if (i == j || fabs(across) >= sigma || along < 0.0)
        return INFINITY;
    const double behind =
        k.straight ? sigma : sqrt((sigma - across) * (sigma + across));
    if (k.passes && along < behind)
        return along - behind + b->width;
    return fmax(along - behind, 0.0);
}

/* Carries the chain out; at most 1000 touches, for whoever is mistaken. */
static size_t chain(struct box *b, struct idea k)
{
    size_t i = b->first, touches = 0;
    double left = b->length;
    while (touches < 1000) {
        size_t next = i;
        double way = left;
        for (size_t j = 0; j < b->n; ++j)
            if (room(b, k, i, j) < way) {
                way = room(b, k, i, j);
                next = j;
            }
        b->x[i] += way;
        if (!k.outside)
            b->x[i] -= b->width * floor(b->x[i] / b->width);
        if (next == i || k.stops)
            break;
        left = k.anew && touches < 3 ? b->length : left - way;
        ++touches;
        i = next;
    }
    return touches;
}

static const char *input(const struct box *b)
{
    const char *all = check_text("sigma = %g m, box %g m by %g m", b->sigma,
                                 b->width, b->height);
    for (size_t i = 0; i < b->n; ++i)
        all = check_text("%s%s(%g, %g)", all, i ? ", " : "; ", b->x[i],
                         b->y[i]);
    return check_text("%s; disk %zu is pushed, by %g m in all", all,
                      b->first, b->length);
}

static double would(const struct box *from, struct idea k, size_t i)
{
    struct box b = *from;
    chain(&b, k);
    return b.x[i];
}

/* Each touch has ten roundings of the width or so, and the root makes more
   of them where a disk is only brushed; drawn boxes have none such. */
static void check(const struct box *from)
{
    struct box got = *from, b = *from;
    struct idea radius = right, straight = right, stops = right,
                anew = right, no_x = right, no_y = right, outside = right,
                passes = right;
    radius.reach = 0.5;
    straight.straight = stops.stops = anew.anew = true;
    no_x.no_x = no_y.no_y = outside.outside = passes.passes = true;
    const size_t expected = chain(&b, right);
    const size_t touches =
        push_chain(got.n, got.sigma, got.width, got.height, got.x, got.y,
                   got.first, got.length);
    const double slack = 64.0 * DBL_EPSILON * (1.0 + (double)expected) *
                         (from->width + from->length + from->sigma);
    for (size_t k = 0; k < b.n; ++k) {
        const size_t i = (b.first + k) % b.n; /* the pushed one first */
        CHECK_NEAR(got.x[i], .quantity = check_text("x[%zu] after", i),
                   .unit = "m", .input = input(from), .expected = b.x[i],
                   .tolerance = slack,
                   .because =
                       "64 epsilons of the box and the way, for each touch",
                   .mistakes = {
                       {"radius-for-diameter", would(from, radius, i),
                        "Your disks come nearer to each other than they "
                        "can. How far apart are two centres that touch?"},
                       {"not-aside", would(from, straight, i),
                        "This disk stops a whole diameter short. The other "
                        "one stands aside: how far apart along x are their "
                        "centres when they touch?"},
                       {"push-not-handed-on", would(from, stops, i),
                        "At the first touch your chain ends. What becomes "
                        "of the rest of the way?"},
                       {"length-anew", would(from, anew, i),
                        "The length is for all disks together. How much of "
                        "it has the one before used up?"},
                       {"not-through-the-side", would(from, no_x, i),
                        "There is a disk beyond the right side, which has "
                        "a smaller x. How far ahead is it?"},
                       {"not-through-the-top", would(from, no_y, i),
                        "A disk near the top and one near the bottom may "
                        "touch. How far aside is it, by the shorter way?"},
                       {"left-outside", would(from, outside, i),
                        "This place is outside the box. Where does a disk "
                        "come in that leaves on the right?"},
                       {"touching-passed-by", would(from, passes, i),
                        "These disks touch, and a rounding has put one of "
                        "them a hair too near. Which way of yours has "
                        "become negative, or as long as the box?"}});
    }
    static const char count[] =
        "All places are right. When is a push handed on, and how often has "
        "that happened here?";
    CHECK_NEAR(
        (double)touches, .quantity = "what is returned",
        .input = input(from), .expected = (double)expected,
        .because = "a number of touches", .question = count,
        .mistakes = {{"disks-counted", (double)expected + 1.0, count}});
}

/* limit: 1 (disk) */
static void test_one(void)
{
    check_ask(
        "A disk alone has nobody to touch. Where is it after all the way?");
    check(&BOX(1, 1.0, 4.0, 3.0, {1.0}, {1.0}, 0, 1.5));
    check(&BOX(1, 1.0, 4.0, 3.0, {1.0}, {1.0}, 0, 5.5));
}

static void test_row(void)
{
    static const char question[] = "All are in one row. Who goes how far, "
                                   "and how long is that in all?";
    check_ask(question);
    check(&BOX(2, 1.0, 6.0, 3.0, {1.0, 2.5}, {1.0, 1.0}, 0, 1.5));
    check_ask(
        "The way ends just where they touch. Has anything been handed on?");
    check(&BOX(2, 1.0, 6.0, 3.0, {1.0, 2.5}, {1.0, 1.0}, 0, 0.5));
    check_ask(question);
    check(&BOX(3, 1.0, 9.0, 3.0, {3.5, 1.0, 6.0}, {1.0, 1.0, 1.0}, 1, 4.0));
    check_ask("Three in a row that touch, but for roundings. Which of them "
              "goes anywhere?");
    check(&BOX(3, 0.1, 1.2, 0.5, {0.1, 0.2, 0.3}, /* 0.3 - 0.2 < 0.1 */
               {0.2, 0.2, 0.2}, 0, 0.25));
}

static void test_aside(void)
{
    check_ask("The other one stands aside by 0.6 diameters. Where do they "
              "touch?");
    check(&BOX(2, 1.0, 6.0, 3.0, {1.0, 3.0}, {1.0, 1.6}, 0, 2.5));
}

/* limit: 2 sigma (what the box is larger than) */
static void test_edges(void)
{
    check_ask("The disk that is pushed leaves on the right. Who stands "
              "beyond that side?");
    check(&BOX(2, 1.0, 6.0, 3.0, {1.0, 5.0}, {1.0, 1.0}, 1, 2.0));
    check_ask("One disk is near the bottom and the other one near the top. "
              "Do they pass each other?");
    check(&BOX(2, 1.0, 6.0, 3.0, {1.0, 3.0}, {0.2, 2.8}, 0, 2.5));
    check_ask("The box is hardly larger than two disks. Whom does each of "
              "them meet, on either side?");
    check(&BOX(2, 1.0, 2.125, 2.125, {0.25, 1.5}, {0.5, 0.75}, 0, 3.0));
}

/* So many, one after the other, wherever they fit. */
static void draw(struct box *b)
{
    b->sigma = check_draw(0.5, 1.5);
    b->width = b->sigma * check_draw(5.0, 6.0);
    b->height = b->sigma * check_draw(4.0, 5.0);
    b->n = 0;
    for (int tries = 0; tries < 300 && b->n < 10; ++tries) {
        const size_t i = b->n++;
        b->x[i] = b->width * check_draw(0.0, 0.999);
        b->y[i] = b->height * check_draw(0.0, 0.999);
        for (size_t j = 0; j < i; ++j) {
            double along = b->x[j] - b->x[i], across = b->y[j] - b->y[i];
            along -= b->width * round(along / b->width);
            across -= b->height * round(across / b->height);
            if (hypot(along, across) < 1.001 * b->sigma ||
                fabs(fabs(across) - b->sigma) < 1e-3 * b->sigma) {
                b->n = i; /* an overlap, or nearly a brush */
                break;
            }
        }
    }
    b->first = (size_t)check_draw_whole(0, (int)b->n - 1);
    b->length = b->sigma * check_draw(0.5, 12.0);
}

CHECK_TIMES(20, test_room, i)
{
    struct box b, from;
    draw(&b);
    from = b;
    push_chain(b.n, b.sigma, b.width, b.height, b.x, b.y, b.first,
               b.length);
    double moved = 0.0;
    for (size_t k = 0; k < b.n; ++k)
        moved += b.x[k] - from.x[k];
    const double turns = (b.length - moved) / b.width;
    CHECK_NEAR(
        turns - round(turns),
        .quantity =
            "what is missing of the way in all, in widths of the box",
        .input = input(&from), .tolerance = 1e-11, .because = "roundings",
        .question = "Whatever one disk does not go, another one does. Add "
                    "up how far each has gone: is it the length?");
}

CHECK_TIMES(30, test_drawn, i)
{
    check_ask("Up to ten disks. Follow the push on paper, disk by disk: "
              "which one is touched first?");
    struct box b;
    draw(&b);
    check(&b);
}

const struct check_suite check_suite = {
    .file = "06d-chain.c",
    .title = "A push that is handed on",
    .minutes = 35,
    .equation = "eq:global-balance",
    .tests = {{"one disk goes all the way", test_one, 1, 0},
              {"in a row the push is handed on", test_row, 2, 0},
              {"a disk aside is touched later", test_aside, 1, 0},
              {"disks are seen through the edges", test_edges, 2, 0},
              {"all ways add up to the length", test_room, 1, 1},
              {"thirty drawn boxes are pushed as they should be",
               test_drawn, 2, 2},
              {0}},
};
