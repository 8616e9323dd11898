/* The scenes of the sky against numbers computed for this book (40 digits,
   quadruple precision), the sums and fields that they need, and what must
   balance in them. */
#include "unit.h"

#include "forces/celestial.h"
#include "forces/gravity.h"
#include "forces/kepler.h"

struct wish {
    const char *key;
    double value;
};

static void make(struct scene *s, const char *name,
                 const struct wish wishes[])
{
    const struct gallery_scene *g = gallery_find(celestial_scenes, name);
    double value[GALLERY_KEYS];
    UNIT_MUST(g);
    gallery_usual(g, value);
    for (; wishes->key; ++wishes) {
        const size_t k = gallery_key(g, wishes->key);
        UNIT_TRUE(g->key[k].name != NULL);
        value[k] = wishes->value;
    }
    UNIT_TRUE(!g->build(s, value));
}

/* Sum of mass times position, or velocity, along an axis. */
static double moment(const struct scene *s, const double v[], size_t axis)
{
    double sum = 0;
    for (size_t i = 0; i < s->bodies; ++i)
        sum += s->mass[i] * v[axis * s->bodies + i];
    return sum;
}

/* The elements that went in come out; the planets go round in the right
   time: Jupiter's year is 11.86 years. */
TEST(test_planets, "the planets have their elements")
{
    static const double axis[] = {0.38709927,  0.72333566, 1.00000261,
                                  1.52371034,  5.20288700, 9.53667594,
                                  19.18916464, 30.06992276};
    static const double eccentricity[] = {
        0.20563593, 0.00677672, 0.01671123, 0.09339410,
        0.04838624, 0.05386179, 0.04725744, 0.00859048};
    MADE(scene, s, make(&s, "solar-system", (struct wish[]){{0}}));
    UNIT_EQUAL(s.bodies, 9);
    for (size_t i = 1; i < 9; ++i) {
        double x[3], v[3], a, e;
        for (size_t k = 0; k < 3; ++k) {
            x[k] = s.position[9 * k + i] - s.position[9 * k];
            v[k] = s.velocity[9 * k + i] - s.velocity[9 * k];
        }
        kepler_shape(s.k2 * (1 + s.mass[i]), x, v, &a, &e);
        UNIT_NEAR(a / axis[i - 1], 1, 1e-13);
        UNIT_NEAR(e, eccentricity[i - 1], 1e-13);
    }
    for (size_t k = 0; k < 3; ++k) {
        UNIT_NEAR(moment(&s, s.position, k), 0, 1e-16);
        UNIT_NEAR(moment(&s, s.velocity, k), 0, 1e-18);
    }
    UNIT_NEAR(1 / s.mass[5], 1047.348644, 1e-9);
    scene_free(&s);
    make(&s, "solar-system",
         (struct wish[]){{"jupiter", 100}, {"planets", 5}, {0}});
    UNIT_EQUAL(s.bodies, 6);
    UNIT_NEAR(s.mass[5], 100 / 1047.348644, 1e-15);
}

/* On 1 January 2000 the Earth stood at a longitude of 100.4 degrees less
   the equation of the centre, and was 0.9833 AU from the Sun: four days
   before its perihelion. */
TEST(test_date, "and stand where they stood")
{
    MADE(scene, s, make(&s, "solar-system", (struct wish[]){{0}}));
    const double x = s.position[3] - s.position[0];
    const double y = s.position[12] - s.position[9];
    UNIT_NEAR(hypot(x, y), 0.9833, 1e-4);
    UNIT_NEAR(atan2(y, x) * 180 / KEPLER_PI, 100.38, 0.02);
}

TEST(test_circumbinary, "two suns and a planet")
{
    MADE(scene, s, make(&s, "circumbinary", (struct wish[]){{0}}));
    UNIT_NEAR(s.velocity[3], -0.00778928877069, 1e-14);
    UNIT_LIST(s.velocity + 4, 1e-13, 0.0265166459286, 0.0193531180487);
    UNIT_LIST(s.position, 1e-16, -5.0928140759834136501e-02,
              1.7337185924016586350e-01);
    UNIT_EQUAL(s.position[2], 0.7048);
    scene_free(&s);
    /* begun at the far end: the shape of the stars' orbit */
    make(&s, "circumbinary",
         (struct wish[]){{"eccentricity", 0.159}, {"phase", 0.25}, {0}});
    double a, e;
    kepler_shape(s.k2 * (s.mass[0] + s.mass[1]),
                 (double[]){s.position[1] - s.position[0], 0, 0},
                 (double[]){0, s.velocity[4] - s.velocity[3], 0}, &a, &e);
    UNIT_NEAR(a, 0.2243, 1e-15);
    UNIT_NEAR(e, 0.159, 1e-15);
    UNIT_NEAR(s.position[2], 0, 1e-16);
    UNIT_NEAR(s.position[5], 0.7048, 1e-16);
}

/* Table 1 of the paper, to 12 digits; its 7.933369 is not S_8. */
TEST(test_choreography, "table 1 of the paper, and its slip")
{
    static const double sum[] = {0.7071067811865475, 1.632993161855452,
                                 2.707106781186548,  3.892995957870921,
                                 5.16852706778819,   6.51885947719245,
                                 7.933358640692054};
    for (size_t n = 2; n <= 8; ++n)
        UNIT_NEAR(celestial_choreography(n), sum[n - 2], 1e-12);
    UNIT_NEAR(celestial_choreography(9), 9.404032819668571, 1e-12);
    UNIT_TRUE(fabs(celestial_choreography(8) - 7.933369) > 1e-5);
    for (size_t n = 2; n <= 40;
         ++n) { /* the pull is what the speed needs */
        double a[3 * 40] = {0};
        MADE(scene, s,
             make(&s, "choreography",
                  (struct wish[]){{"particles", (double)n}, {0}}));
        MADE(gravity, g, gravity_create(&g, n, s.mass, s.k2, 0));
        gravity_add(&g, s.position, a);
        const double v2 = s.velocity[n] * s.velocity[n];
        UNIT_NEAR(a[0], -v2, 1e-12 * v2);
        UNIT_NEAR(a[n], 0, 1e-12 * v2);
    }
}

/* Eigenvalues of the linear equations, by another program for this book. */
TEST(test_growth, "choreographies grow as the theory says")
{
    static const double rate[] = {
        0.70710678, 0.85953250, 0.93913045, 0.98936111, 1.29425024,
        1.77848224, 2.08256214, 2.42617583, 2.68806776, 2.98783156};
    UNIT_NEAR(celestial_growth(2), 0, 1e-6); /* a double root */
    for (size_t n = 3; n <= 12; ++n)
        UNIT_NEAR(celestial_growth(n), rate[n - 3], 1e-8);
}

TEST(test_eight, "the figure of eight has its energy")
{
    MADE(scene, s, make(&s, "figure-eight", (struct wish[]){{0}}));
    struct gravity g;
    double kinetic = 0;
    gravity_create(&g, 3, s.mass, s.k2, 0);
    for (size_t i = 0; i < 9; ++i)
        kinetic += s.velocity[i] * s.velocity[i] / 2;
    UNIT_NEAR(kinetic + gravity_potential(&g, s.position),
              -1.287141995631857705, 4e-15); /* a dozen roundings */
    for (size_t k = 0; k < 2; ++k)
        UNIT_NEAR(moment(&s, s.velocity, k), 0, 1e-15);
}

/* Speeds round a planet with a ring of 0.02 of its mass, by quadrature in
   40 digits, computed for this book. */
TEST(test_ring_speeds, "speeds in a ring have their closed form")
{
    static const double known[][2] = {
        {1.5, .014001554932841},  {1.9, .012284080782243},
        {2.1, .011717969870531},  {2.25, .011526240507293},
        {2.4, .011406450233484},  {2.6, .01106344629159},
        {3, .010126105307661},    {4, .0087152274853993},
        {1.0, 0.017190124707258}, {1.99, 0.01168908524699},
        {2.01, 0.01162921593758}, {2.51, 0.011635912037525}};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i) {
        const double r = known[i][0];
        const double pull = celestial_ring_pull(0.02, 2, 2.5, r);
        UNIT_NEAR(0.0172 * sqrt(1 / r + r * pull), known[i][1], 1e-14);
    }
    /* far away, a point; in the middle, nothing */
    UNIT_NEAR(celestial_ring_pull(1, 2, 2.5, 1e4) * 1e8, 1, 1e-6);
    UNIT_EQUAL(celestial_ring_pull(1, 2, 2.5, 0), 0);
    UNIT_TRUE(isinf(celestial_ring_pull(1, 2, 2.5, 2.5)));
}

TEST(test_ring, "a ring is uniform and repeats itself")
{
    FREED(scene) s, again;
    make(&s, "ring", (struct wish[]){{0}});
    UNIT_EQUAL(s.bodies, 3073);
    double inside = 0, least = 9, most = 0;
    for (size_t i = 1; i < s.bodies; ++i) {
        const double x = s.position[i] - s.position[0];
        const double y = s.position[s.bodies + i] - s.position[s.bodies];
        const double r = hypot(x, y);
        least = fmin(least, r);
        most = fmax(most, r);
        inside += r < sqrt((4 + 6.25) / 2); /* half of the area */
        UNIT_EQUAL(s.mass[i], 1e-8);
    }
    UNIT_TRUE(least >= 2 - 1e-6 && most <= 2.5 + 1e-6);
    UNIT_NEAR(inside, 1536, 4 * sqrt(3072) / 2); /* four sigma */
    make(&again, "ring", (struct wish[]){{"seed", 1}, {0}});
    UNIT_TRUE(
        memcmp(s.position, again.position, 3 * 3073 * sizeof(double)) == 0);
    scene_free(&again);
    make(&again, "ring", (struct wish[]){{"seed", 2}, {0}});
    UNIT_TRUE(s.position[7] != again.position[7]);
}

/* All key combinations: masses keep their sum, momentum is zero. */
TEST(test_ring_keys, "with a moon and mixed masses")
{
    struct scene s;
    make(&s, "ring",
         (struct wish[]){{"particles", 500},
                         {"factor", 1000},
                         {"mixed", 2},
                         {"moon", 1e-4},
                         {"moon-distance", 2.7},
                         {0}});
    UNIT_EQUAL(s.bodies, 502);
    double sum = 0, least = 1, most = 0;
    for (size_t i = 1; i <= 500; ++i) {
        sum += s.mass[i];
        least = fmin(least, s.mass[i]);
        most = fmax(most, s.mass[i]);
    }
    UNIT_NEAR(sum, 500 * 1e-5, 1e-16);
    UNIT_TRUE(most / least > 80 && most / least <= 100);
    UNIT_EQUAL(s.mass[501], 1e-4);
    for (size_t k = 0; k < 3; ++k)
        UNIT_NEAR(moment(&s, s.velocity, k), 0, 1e-15);
    scene_free(&s);
    const struct gallery_scene *g = gallery_find(celestial_scenes, "ring");
    double value[GALLERY_KEYS];
    gallery_usual(g, value);
    value[gallery_key(g, "inner")] = 3;
    const char *wrong = g->build(&s, value);
    UNIT_TRUE(wrong && strstr(wrong, "inner"));
}
