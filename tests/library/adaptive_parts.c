/* What steps of their own length are made of: how a step is stretched, the
   first one, roots, scales, sums with tails, the weights of the
   polynomials; all by hand. And what is noted, counted and bounded. */
#include "unit.h"

#include <forces/adaptive.c> /* of src: the parts */

#include "library/own_steps.h"
#include "forces/stepping.h"

#include <float.h>

/* From above: the last correction is below 1e-3 of the root, and leaves
   (n - 1) / 2 times its square. */
TEST(test_root, "roots are from above")
{
    UNIT_EQUAL(power_of(2, 0), 1);
    UNIT_EQUAL(power_of(-3, 3), -27);
    for (int n = 5; n < 8; n += 2)
        for (double z = 1e-4; z < 1e6; z *= 1.7) {
            const double off = root(z, n) / pow(z, 1.0 / n) - 1;
            UNIT_TRUE(off > -4 * DBL_EPSILON && off < (n - 1) / 2e6);
        }
}

/* 0.75 of what would just do, from a fifth to five times. */
TEST(test_stretch, "by how much a step is stretched")
{
    for (int n = 5; n < 8; n += 2) {
        for (double by = 0.21; by < 4.9; by += 0.13)
            UNIT_NEAR(stretch(pow(0.75 / by, n), n) / by, 1, 4e-6);
        UNIT_EQUAL(stretch(pow(0.75 / 5, n) * 0.999, n), 5);
        UNIT_TRUE(stretch(pow(0.75 / 5, n) * 1.001, n) < 5);
        UNIT_EQUAL(stretch(0, n), 5);
        UNIT_EQUAL(stretch(-1, n), 5);
        UNIT_EQUAL(stretch(pow(0.75 / 0.2, n) * 1.001, n), 0.2);
        UNIT_TRUE(stretch(pow(0.75 / 0.2, n) * 0.999, n) > 0.2);
        UNIT_EQUAL(stretch(INFINITY, n), 0.2);
        UNIT_EQUAL(stretch(NAN, n), 0.2);
    }
}

TEST(test_scales, "what changes are compared with")
{
    UNIT_EQUAL(scale_of(2, 3), 2);
    UNIT_EQUAL(scale_of(2e-6, 1), 2e-6);
    UNIT_EQUAL(scale_of(0.5e-6, 1), 1);
    UNIT_EQUAL(scale_of(0, 7), 7);
    UNIT_EQUAL(scale_of(0, 0), 1);
    const struct adaptive s = {.tolerance = 1e-9};
    UNIT_TRUE(settled(&s, 1.009e-9, INFINITY));
    UNIT_TRUE(!settled(&s, 1.011e-9, INFINITY));
    UNIT_TRUE(settled(&s, 1, 1) && !settled(&s, 0.9, 1));
    UNIT_TRUE(settled(&s, NAN, 1));
}

/* 1e16 + 1.5 + 0.25, of numbers that are even there; what is small counts
   where the sum alone would lose it. */
TEST(test_tail, "sums with a tail")
{
    double to, owed;
    add_tail(&to, &owed, 1e16, 1.5, 0.25);
    UNIT_EQUAL(to, 1e16 + 2);
    UNIT_EQUAL(owed, -0.25);
    add_tail(&to, &owed, 1.5, 1e16, -0.75);
    UNIT_EQUAL(to, 1e16);
    UNIT_EQUAL(owed, 0.75);
    add_tail(&to, &owed, 1, 0x1p-60, 0x1p-70);
    UNIT_EQUAL(to, 1);
    UNIT_EQUAL(owed, 0x1p-60 + 0x1p-70);
}

/* A hundredth of x/v, root x/a or v/a, of the least where all are known,
   and of dt where nothing is. */
TEST(test_first, "how long the first step is")
{
    static const double known[][4] = {
        {0, 0, 0, 3},     {2, 4, 0, 0.5}, {2, 0, 8, 0.5}, {0, 4, 50, 0.08},
        {2, 4, 50, 0.08}, {2, 4, 2, 0.5}, {8, 1, 2, 0.5}, {2, 100, 8, 0.02},
        {0, 4, 0, 3},     {0, 0, 4, 3},   {2, 0, 0, 3}};
    for (size_t k = 0; k < sizeof known / sizeof known[0]; ++k) {
        double x[] = {0, -known[k][0]}, v[] = {-known[k][1], 0},
               a[] = {known[k][2], 0};
        const struct adaptive s = {
            .forces = {.size = 2}, .dt = 3, .to = {.x = x, .v = v, .a = a}};
        UNIT_NEAR(first_length(&s), known[k][3] / 100, 1e-17);
    }
}

/* The larger acceleration of both ends, times the step, is at most 1e-9 of
   the velocity. */
TEST(test_edge, "what an edge is")
{
    for (int end = 0; end < 2; ++end)
        for (int more = 0; more < 2; ++more) {
            double p[] = {0, end ? 1 : -4}, q[] = {end ? 4 : 1, 0},
                   v[] = {3, more ? -7.9 : -8.1};
            const struct adaptive s = {.forces = {.size = 2},
                                       .from = {.a = p},
                                       .to = {.v = v, .a = q}};
            UNIT_TRUE(is_edge(&s, 2e-9) == !more);
        }
}

static double choose(int n, int k)
{
    double by = 1;
    for (int j = 0; j < k; ++j)
        by *= (double)(n - j) / (j + 1);
    return by;
}

/* From powers to the polynomials and back is the identity; N_k is zero at
   the first k nodes; the binomials; one over the gaps between nodes, 0 and
   1. Terms are below 20, and some ten of them are added. */
TEST(test_weights, "weights of Radau's polynomials")
{
    const struct stepping_forces f = {.size = 1};
    OWN s = adaptive_create(stepping_find("radau15"), f);
    UNIT_MUST(s);
    const struct adaptive_weights *const w = s->weights;
    const double *const c = s->method->node;
    double amplified = 0;
    for (int k = 0; k < STAGES; ++k)
        for (int m = 0; m < STAGES; ++m) {
            double sum = 0;
            for (int j = m; j <= k; ++j)
                sum += w->power[k][j] * w->newton[j][m];
            UNIT_NEAR(sum, k == m, 1e-13);
            if (m <= k) {
                UNIT_NEAR(w->binomial[k][m], choose(k + 1, m + 1), 1e-13);
                UNIT_NEAR(w->gap[k][m] * (c[k] - (m > 0 ? c[m - 1] : 0)), 1,
                          1e-15);
            }
            if (m < k) {
                double at = 0;
                for (int j = k; j >= 0; --j)
                    at = (at + w->power[k][j]) * c[m];
                UNIT_NEAR(at, 0, 1e-14);
            }
        }
    for (int i = 0; i < 9; ++i) {
        double gaps = 1;
        for (int j = 0; j < 9; ++j) {
            const double p = i == 0 ? 0 : i == 8 ? 1 : c[i - 1];
            const double q = j == 0 ? 0 : j == 8 ? 1 : c[j - 1];
            gaps *= i == j ? 1 : fabs(p - q);
        }
        amplified += 1 / gaps;
    }
    UNIT_NEAR(w->amplified / amplified, 1, 1e-13);
    for (int j = 0; j < STAGES; ++j)
        UNIT_NEAR(w->last[j] * (1 - c[j]), 1, 1e-15);
}

/* The mean of N_k = s (s - c_1) ... (s - c_k), with the factor 1 - u or
   without, over s = u c, u = 0 ... 1, by Gauss's rule of five points: exact
   to the degree 9, of which 8 is needed. */
static double mean_of(const double node[], int k, double c, bool twice)
{
    const double near = sqrt(5 - 2 * sqrt(10 / 7.0)) / 3;
    const double far = sqrt(5 + 2 * sqrt(10 / 7.0)) / 3;
    const double at[] = {0, near, -near, far, -far};
    const double share = 13 * sqrt(70);
    const double by[] = {512, 322 + share, 322 + share, 322 - share,
                         322 - share};
    double sum = 0;
    for (int j = 0; j < 5; ++j) {
        const double u = (1 + at[j]) / 2;
        double value = u * c * (twice ? 1 - u : 1);
        for (int m = 0; m < k; ++m)
            value *= u * c - node[m];
        sum += by[j] / 1800 * value;
    }
    return sum;
}

/* What a polynomial adds to a velocity and to a place on the way to a node:
   its integral, and that of its integral. Terms are below 20. */
TEST(test_integrals, "what polynomials add by a node")
{
    const struct stepping_forces f = {.size = 1};
    OWN s = adaptive_create(stepping_find("radau15"), f);
    UNIT_MUST(s);
    const double *const c = s->method->node;
    for (int i = 0; i < STAGES; ++i)
        for (int k = 0; k < STAGES; ++k) {
            const double once = mean_of(c, k, c[i], false);
            const double twice = mean_of(c, k, c[i], true);
            UNIT_NEAR(s->weights->v[i][k], once, 1e-13);
            UNIT_NEAR(s->weights->x[i][k], twice, 1e-13);
        }
}

static const char *const names[] = {"dopri5", "radau15"};

static struct adaptive *set_off(const char *name)
{
    struct adaptive *const s =
        adaptive_create(stepping_find(name), orbit_forces);
    UNIT_MUST(s);
    adaptive_begin(s, 1e-9, 1, 0.3, (double[]){0.1, 0},
                   (double[]){0, sqrt(19)});
    return s;
}

/* Another one that recalls what was noted goes on with the same bits and
   counts, between the ends of steps too; no number is noted beyond what was
   said. */
TEST(test_notes, "what is noted is all")
{
    for (int k = 0; k < 2; ++k) {
        double note[200], x[2], v[2], y[2], u[2], seen[2], sought[2];
        OWN s = set_off(names[k]);
        OWN t = set_off(names[k]);
        const size_t notes = adaptive_notes(s);
        UNIT_TRUE(notes < 200);
        UNIT_TRUE(adaptive_reach(s, 0.9, x, v));
        s->refused += 3; /* there may have been none */
        note[notes] = 77;
        adaptive_note(s, note);
        UNIT_EQUAL(note[notes], 77);
        adaptive_recall(t, note);
        UNIT_EQUAL(t->t, s->t);
        adaptive_look(s, s->t - s->h / 3, x, v);
        adaptive_look(t, s->t - s->h / 3, y, u);
        UNIT_TRUE(!memcmp(x, y, sizeof x) && !memcmp(v, u, sizeof v));
        UNIT_TRUE(adaptive_reach(s, 9, seen, v));
        UNIT_TRUE(adaptive_reach(t, 9, sought, u));
        UNIT_TRUE(!memcmp(seen, sought, sizeof x) &&
                  !memcmp(v, u, sizeof v));
        UNIT_TRUE(s->taken == t->taken && s->refused == t->refused &&
                  s->evaluations == t->evaluations);
        UNIT_TRUE(s->shortest == t->shortest && s->h == t->h &&
                  s->owed == t->owed && s->next == t->next &&
                  s->noise == t->noise && s->start == t->start);
        UNIT_TRUE(s->shortest > 0 && s->refused >= 3);
    }
}

/* Times are sums of steps, with what they lose owed: those of steps that
   were taken again too, of half their length here. 300 of them as they are
   would be off by some 1e-15; here they are off by the roundings of a
   longer type alone, 6e-20 of up to 16 s each. The shortest is counted as
   it was taken.
 */
TEST(test_times, "times are sums of steps")
{
    for (int k = 0; k < 2; ++k) {
        OWN s = set_off(names[k]);
        long double t = 0.3;
        double shortest = INFINITY, x[2], v[2];
        for (int n = 0; n < 300; ++n) {
            UNIT_TRUE(adaptive_step(s, 0.1));
            UNIT_TRUE(s->h <= 0.1);
            shortest = fmin(shortest, s->h);
            t += n % 3 == 0 ? s->h / 2 : s->h;
            if (n % 3 == 0)
                adaptive_again(s, s->h / 2, x, v);
            UNIT_NEAR(t - s->t - s->owed, 0, 300 * 16 * 6e-20);
            UNIT_NEAR(s->owed, 0, DBL_EPSILON * s->t);
        }
        UNIT_EQUAL(s->shortest, shortest);
    }
}

/* After so many evaluations no step is taken. */
TEST(test_most, "the most evaluations")
{
    for (int k = 0; k < 2; ++k) {
        OWN s = set_off(names[k]);
        double x[2], v[2];
        s->most = 500;
        UNIT_TRUE(!adaptive_reach(s, 1000, x, v));
        UNIT_TRUE(s->evaluations > 500 && s->evaluations < 700);
    }
}
