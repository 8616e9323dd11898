/* The tree: its error against the direct sum is never more than the bound
   of (9.15, eq:tree-bound), added up over the cells that a body takes;
   theta rules it; what weighs nothing, sits in one place or has blown up.
 */
#include "unit.h"

#include <forces/tree.c> /* of src: what the tree is made of */

#include "toolbox/random.h"

#include <float.h>

enum { MOST = 3000 };
static double place[3 * MOST], mass[MOST], direct[3 * MOST], tree[3 * MOST];

/* A cube, a flat ring with a heavy middle, or two dense balls far apart. */
enum cloud { CUBE, RING, BALLS, CLOUDS };

static void scatter(enum cloud cloud, size_t n, uint64_t seed)
{
    SEEDED(r, seed);
    for (size_t i = 0; i < n; ++i) {
        double at[3] = {random_between(&r, -1, 1),
                        random_between(&r, -1, 1),
                        random_between(&r, -1, 1)};
        const double r2 = at[0] * at[0] + at[1] * at[1];
        if (cloud == RING && (r2 < 0.64 || r2 > 1) && i > 0) {
            --i;
            continue;
        }
        for (size_t k = 0; k < 3; ++k) {
            if (cloud == RING)
                at[k] *= i > 0 && k < 2;
            if (cloud == BALLS)
                at[k] = 0.1 * at[k] * at[k] * at[k] + 5 * (double)(i % 2);
            place[k * n + i] = at[k];
        }
        mass[i] = cloud == RING && i == 0 ? 1e3 : random_between(&r, 0, 1);
    }
}

/* Both sums, the tree's by theta. */
static struct gravity sum_both(size_t n, double softening, double theta)
{
    struct gravity g;
    UNIT_TRUE(gravity_create(&g, n, mass, 1, softening));
    memset(direct, 0, sizeof direct);
    memset(tree, 0, sizeof tree);
    gravity_add(&g, place, direct);
    UNIT_TRUE(gravity_use_tree(&g, theta));
    gravity_add(&g, place, tree);
    return g;
}

static size_t wrong; /* bodies and cells that break a promise */

/* What a cell may be wrong by at a place. */
static double of_cell(const struct gravity *g, const struct cell *c,
                      const double at[3])
{
    const double *p = g->tree->place;
    const size_t n = g->bodies;
    const double centre[] = {c->x, c->y, c->z};
    double sum = 0, R2 = g->softening * g->softening;
    for (size_t k = 0; k < 3; ++k)
        R2 += (centre[k] - at[k]) * (centre[k] - at[k]);
    for (size_t j = c->first; j < c->end; ++j) {
        double r2 = 0;
        for (size_t k = 0; k < 3; ++k)
            r2 += (p[k * n + j] - centre[k]) * (p[k * n + j] - centre[k]);
        const double q = sqrt(r2 / R2), m = p[3 * n + j];
        wrong += !(q < 1);
        sum += m / R2 * q * q * (3 - 2 * q) / (1 - q) / (1 - q);
    }
    return sum;
}

/* The bounds of body j of the tree's order, added up along its block's
   walk. */
static double of_body(const struct gravity *g, size_t j)
{
    const struct tree *t = g->tree;
    const size_t n = g->bodies, i = j - j % BLOCK;
    const struct block o =
        block_of(g, t->place, i, n - i < BLOCK ? n : i + BLOCK);
    const struct box box = box_of(&o);
    const double at[] = {t->place[j], t->place[n + j], t->place[2 * n + j]};
    double sum = 0;
    for (size_t c = 0; c < t->cells;) {
        const bool far = is_small(t, &t->cell[c], &box);
        sum += far ? of_cell(g, &t->cell[c], at) : 0;
        c = far ? t->cell[c].next : c + 1;
    }
    return sum;
}

/* All that is rounded: n terms of either sum, whose sizes add up to less
   than the sum of m/R^2. */
static double rounding(const struct gravity *g, size_t i)
{
    double size = 0;
    for (size_t j = 0; j < g->bodies; ++j) {
        double s = g->softening * g->softening;
        for (size_t k = 0; k < 3; ++k) {
            const double d =
                place[k * g->bodies + j] - place[k * g->bodies + i];
            s += d * d;
        }
        size += j == i ? 0 : mass[j] / s;
    }
    return 2 * ((double)g->bodies + 10) * DBL_EPSILON * size;
}

/* No body's error is more than its bound; returns the largest share. */
static double hold_bound(const struct gravity *g)
{
    const size_t n = g->bodies;
    double share = 0;
    wrong = 0;
    for (size_t j = 0; j < n; ++j) {
        const size_t i = g->tree->body[j];
        double e2 = 0;
        for (size_t k = 0; k < 3; ++k)
            e2 += pow(tree[k * n + i] - direct[k * n + i], 2);
        const double most = of_body(g, j) + rounding(g, i);
        wrong += !(sqrt(e2) <= most);
        share = fmax(share, sqrt(e2) / most);
    }
    UNIT_EQUAL(wrong, 0);
    return share;
}

TEST(test_bound, "no body's error is beyond its bound")
{
    static const double thetas[] = {0.1, 0.3, 0.5, GRAVITY_WIDEST};
    double share = 0;
    for (int cloud = 0; cloud < CLOUDS; ++cloud)
        for (int k = 0; k < 8; ++k) {
            const size_t n = 900 + 37 * (size_t)k;
            scatter((enum cloud)cloud, n, 10 + (uint64_t)k);
            FREED(gravity) g = sum_both(n, k % 2 ? 0.03 : 0, thetas[k / 2]);
            share = fmax(share, hold_bound(&g));
        }
    UNIT_TRUE(share > 0.02); /* it is a bound that means something */
}

/* The root mean square of the error in that of the pull. */
static double error_of(size_t n)
{
    double error = 0, size = 0;
    for (size_t c = 0; c < 3 * n; ++c) {
        error += pow(tree[c] - direct[c], 2);
        size += direct[c] * direct[c];
    }
    return sqrt(error / size);
}

/* Each cell loses a share below theta^2, so half of theta leaves a quarter
   or less; and with 0 nothing is left but rounding. */
TEST(test_theta, "half of theta, a quarter of the error")
{
    for (int cloud = 0; cloud < CLOUDS; ++cloud) {
        double last = INFINITY;
        scatter((enum cloud)cloud, MOST, 5);
        for (double theta = 0.4; theta > 0.09; theta /= 2) {
            FREED(gravity) g = sum_both(MOST, 0.02, theta);
            UNIT_TRUE(error_of(MOST) > 0);
            UNIT_TRUE(error_of(MOST) < last / 4);
            last = error_of(MOST);
        }
        FREED(gravity) g = sum_both(MOST, 0.02, 0);
        UNIT_NEAR(error_of(MOST), 0, MOST * DBL_EPSILON);
    }
}

TEST(test_massless, "what weighs nothing pulls nowhere")
{
    scatter(CUBE, 1000, 3);
    for (size_t i = 0; i < 1000; ++i)
        if (i % 2 || place[i] < 0)
            mass[i] = 0;
    FREED(gravity) g = sum_both(1000, 0, 0.4);
    UNIT_TRUE(error_of(1000) < 0.01);
    hold_bound(&g);
}

/* In one place, or as near as a rounding: a hundred of them, or all. With
   softening they pull each other nowhere. */
TEST(test_together, "bodies in one place")
{
    scatter(CUBE, 400, 8);
    for (size_t i = 0; i < 400; ++i)
        for (size_t k = 0; k < 3; ++k)
            if (i % 4 == 0)
                place[k * 400 + i] =
                    place[k * 400] * (1 + (double)(i % 8) * DBL_EPSILON);
    FREED(gravity) g = sum_both(400, 0.1, 0.5);
    hold_bound(&g);
    UNIT_TRUE(g.tree->cells < 800);
    double least = INFINITY; /* roundings of 400 sums are a thousandth */
    for (size_t c = 0; c < g.tree->cells; ++c)
        least = fmin(least, g.tree->cell[c].side);
    UNIT_TRUE(least > 400 * DBL_EPSILON * 1e3);
    gravity_free(&g);
    for (size_t c = 0; c < 1200; ++c)
        place[c] = 0.25;
    g = sum_both(400, 0.1, 0.5);
    for (size_t c = 0; c < 1200; ++c)
        wrong += tree[c] != 0;
    UNIT_EQUAL(wrong, 0);
}

/* What is no number anywhere is none afterwards, and comes to an end. */
TEST(test_blown_up, "a run that has blown up")
{
    static const double wild[] = {INFINITY, -INFINITY, NAN, 1e308, 1e-320};
    for (size_t w = 0; w < 5; ++w) {
        scatter(CUBE, 200, 4);
        place[7] = wild[w];
        FREED(gravity) g = sum_both(200, 0.1, 0.5);
        UNIT_TRUE(w > 2 || isnan(tree[7]));
        UNIT_TRUE(w < 4 || error_of(200) < 0.01);
    }
}

TEST(test_again, "built again, with another theta")
{
    scatter(BALLS, 777, 2);
    FREED(gravity) g = sum_both(777, 0, 0.5);
    memcpy(direct, tree, sizeof tree);
    UNIT_TRUE(gravity_use_tree(&g, 0.2));
    gravity_add(&g, place, direct);
    UNIT_TRUE(gravity_use_tree(&g, 0.5));
    memset(direct, 0, sizeof direct);
    gravity_add(&g, place, direct);
    UNIT_TRUE(memcmp(direct, tree, 3 * 777 * sizeof tree[0]) == 0);
    UNIT_SAYS(gravity_summed_by(&g), "tree");
}

/* A cell is taken for one mass from where it looks smaller than theta, from
   the nearest point of the box of those that it pulls at: 1 m at 2 m for
   0.5, on each side of the box and across its edges (1.2, 1.6). */
TEST(test_small, "theta is how large a cell may look")
{
    const struct box box = {{-1, -2, -3}, {4, 5, 6}};
    mass[0] = 1;
    FREED(gravity) g;
    UNIT_TRUE(gravity_create(&g, 1, mass, 1, 0) &&
              gravity_use_tree(&g, 0.5));
    for (int k = 0; k < 3; ++k)
        for (int side = 0; side < 4; ++side)
            for (int far = 0; far < 2; ++far) {
                double at[3] = {0, 0, 0};
                const double more = far ? 1e-9 : -1e-9;
                const double way = side < 2 ? 2 : 1.2;
                at[k] = side % 2 ? box.most[k] + way + more
                                 : box.least[k] - way - more;
                const int m = (k + 1) % 3;
                if (side > 1)
                    at[m] = box.most[m] + 1.6;
                const struct cell c = {1, at[0], at[1], at[2], 1, 0, 1, 1};
                UNIT_TRUE(is_small(g.tree, &c, &box) == (far == 1));
            }
}

/* How many cells the tree of n bodies has. */
static size_t count_cells(size_t n)
{
    FREED(gravity) g;
    UNIT_TRUE(gravity_create(&g, n, mass, 1, 0) &&
              gravity_use_tree(&g, 0.5));
    tree_build(g.tree, place);
    const size_t cells = g.tree->cells;
    for (size_t i = 0; i < cells; ++i)
        UNIT_TRUE(g.tree->cell[i].next > i &&
                  g.tree->cell[i].next <= cells);
    UNIT_EQUAL(g.tree->cell[0].next, cells);
    return cells;
}

/* Sixteen bodies are a leaf, one more and their cube is divided; cells are
   not smaller than 2^-30 of the largest coordinate, 1 m here: 10 bodies and
   10 others are parted where the middle of a cube of 2^-29 m lies between
   them, and stay together where only that of a smaller one does. */
TEST(test_cells, "when cubes are divided")
{
    for (size_t i = 0; i < MOST; ++i)
        mass[i] = 1;
    for (size_t k = 0; k < 3; ++k) {
        memset(place, 0, sizeof place);
        for (size_t i = 8; i < 16; ++i)
            place[16 * k + i] = 1;
        UNIT_EQUAL(count_cells(16), 1);
        memset(place, 0, sizeof place);
        for (size_t i = 8; i < 17; ++i)
            place[17 * k + i] = 1;
        UNIT_EQUAL(count_cells(17), 3);
        for (int near = 30; near < 32; ++near) {
            memset(place, 0, sizeof place);
            for (size_t i = 10; i < 20; ++i)
                place[21 * k + i] = ldexp(1, -near);
            place[21 * k + 20] = 1;
            UNIT_EQUAL(count_cells(21), near == 30 ? 5 : 3);
            for (size_t i = 0; i < 21; ++i) /* below 0 as well */
                place[21 * k + i] -= 1;
            UNIT_EQUAL(count_cells(21), near == 30 ? 5 : 3);
        }
    }
}
