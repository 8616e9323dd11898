/* Builds scenes of bodies on circles and ellipses about each other. */
#include "forces/celestial.h"

#include "forces/kepler.h"
#include "toolbox/random.h"

#include <complex.h>
#include <math.h>
#include <stdint.h>

static const char no_memory[] = "no memory";

/* Puts body i at (x, y, 0), with a velocity in the plane z = 0. */
static void put(struct scene *s, size_t i, double mass, double x, double y,
                double vx, double vy)
{
    const size_t n = s->bodies;
    s->mass[i] = mass;
    s->position[i] = x;
    s->position[n + i] = y;
    s->velocity[i] = vx;
    s->velocity[n + i] = vy;
}

/* Subtracts from n values their mean weighted with the masses. */
static void balance(double value[], const double mass[], size_t n)
{
    double sum = 0, all = 0;
    for (size_t i = 0; i < n; ++i) {
        sum += mass[i] * value[i];
        all += mass[i];
    }
    for (size_t i = 0; i < n; ++i)
        value[i] -= sum / all;
}

/* Shifts positions and velocities so that the centre of mass is at rest at
   the origin. Most scenes are first described relative to a central body at
   rest. */
static void centre(struct scene *s)
{
    for (size_t k = 0; k < 3; ++k) {
        balance(s->position + k * s->bodies, s->mass, s->bodies);
        balance(s->velocity + k * s->bodies, s->mass, s->bodies);
    }
}

/* Sets the radius and the colour of body i, which are used only for
   drawing. */
static void paint(struct scene *s, size_t i, double radius, double red,
                  double green, double blue)
{
    s->radius[i] = radius;
    s->colour[i] = red;
    s->colour[s->bodies + i] = green;
    s->colour[2 * s->bodies + i] = blue;
}

/* Builds the scene of the first listing of the MPPhys paper. Uses the
   paper's k and puts the Sun at rest, so that our results can be compared
   with the paper's figures. */
static const char *build_sun_earth(struct scene *s, const double value[])
{
    const double mass = value[0], speed = value[1];
    if (!scene_create(s, 2))
        return no_memory;
    put(s, 0, 1, 0, 0, 0, 0);
    put(s, 1, mass, 1, 0, 0, speed * CELESTIAL_K);
    paint(s, 0, 0.1, 1, 1, 0);
    paint(s, 1, 0.03, 0.3, 0.3, 1);
    if (value[2] != 0)
        centre(s);
    s->freedom[4] = s->freedom[5] = 0; /* plane motion, as in the listing */
    s->k2 = CELESTIAL_K2;
    s->dt = value[3];
    return NULL;
}

/* The data of a planet: the Sun's mass divided by the planet's mass, and
   orbital elements in AU and degrees. The mean longitude and the longitude
   of perihelion are measured from the equinox. */
struct planet {
    double sun, axis, eccentricity, inclination, longitude, perihelion,
        node;
};

/* Orbital elements on 1 January 2000, 12 h: E. M. Standish, Keplerian
   elements for approximate positions of the major planets (JPL), 1800 to
   2050. Masses: IAU 2009 system of constants. The Earth's mass includes the
   Moon's. */
static const struct planet planets[] = {
    {6.0236e6, 0.38709927, 0.20563593, 7.00497902, 252.25032350,
     77.45779628, 48.33076593},
    {4.08523719e5, 0.72333566, 0.00677672, 3.39467605, 181.97909950,
     131.60246718, 76.67984255},
    {328900.5596, 1.00000261, 0.01671123, -0.00001531, 100.46457166,
     102.93768193, 0},
    {3.09870359e6, 1.52371034, 0.09339410, 1.84969142, -4.55343205,
     -23.94362959, 49.55953891},
    {1047.348644, 5.20288700, 0.04838624, 1.30439695, 34.39644051,
     14.72847983, 100.47390909},
    {3497.9018, 9.53667594, 0.05386179, 2.48599187, 49.95424423,
     92.59887831, 113.66242448},
    {22902.98, 19.18916464, 0.04725744, 0.77263783, 313.23810451,
     170.95427630, 74.01692503},
    {19412.26, 30.06992276, 0.00859048, 1.77004347, -55.12002969,
     44.96476227, 131.78422574}};

/* Puts planet number i (1 is Mercury), with this mass, at its position on 1
   January 2000 relative to the Sun at the origin. kepler_elements measures
   the perihelion from the node and the anomaly from the perihelion, so both
   are differences of longitudes in the table. */
static void put_planet(struct scene *s, size_t i, double mass)
{
    const struct planet *p = &planets[i - 1];
    const double degree = KEPLER_PI / 180;
    const struct kepler_elements o = {p->axis,
                                      p->eccentricity,
                                      p->inclination * degree,
                                      p->node * degree,
                                      (p->perihelion - p->node) * degree,
                                      (p->longitude - p->perihelion) *
                                          degree};
    double x[3], v[3];
    kepler_place(s->k2 * (1 + mass), &o, x, v);
    for (size_t k = 0; k < 3; ++k) {
        s->position[k * s->bodies + i] = x[k];
        s->velocity[k * s->bodies + i] = v[k];
    }
    s->mass[i] = mass;
    paint(s, i, 0.05, 0.3, 0.3, 1);
}

static const char *build_solar_system(struct scene *s, const double value[])
{
    const double k = 0.01720209895; /* Gauss's value, AU^(3/2) per day */
    const size_t count = (size_t)value[1];
    if (!scene_create(s, 1 + count))
        return no_memory;
    s->k2 = k * k;
    s->mass[0] = 1;
    paint(s, 0, 0.1, 1, 1, 0);
    for (size_t i = 1; i <= count; ++i)
        put_planet(s, i, (i == 5 ? value[0] : 1) / planets[i - 1].sun);
    centre(s);
    s->dt = value[2];
    return NULL;
}

/* Kepler-16 (Doyle et al. 2011): masses of the stars (in solar masses) and
   their separation (in AU). */
static const double star_a = 0.6897, star_b = 0.2026, separation = 0.2243;

/* Builds two stars and a planet on a circle around them. Stars on an
   eccentric orbit start where they are farthest apart and slowest. */
static const char *build_circumbinary(struct scene *s, const double value[])
{
    const double r = value[0], e = value[1], mass = value[3];
    const double stars = star_a + star_b, k = CELESTIAL_K;
    const double far = separation * (1 + e);
    const double u = k * sqrt(stars / separation * (1 - e) / (1 + e));
    const double v = k * sqrt(stars / r);
    double c, sine;
    if (!scene_create(s, 3))
        return no_memory;
    put(s, 0, star_a, -far * star_b / stars, 0, 0, -u * star_b / stars);
    put(s, 1, star_b, far * star_a / stars, 0, 0, u * star_a / stars);
    kepler_turn(2 * KEPLER_PI * value[2], &c, &sine);
    put(s, 2, mass, r * c, r * sine, -v * sine, v * c);
    paint(s, 0, 0.03, 1, 0.8, 0.3);
    paint(s, 1, 0.01, 1, 0.4, 0.2);
    paint(s, 2, 0.005, 0.3, 0.3, 1);
    s->k2 = CELESTIAL_K2;
    s->dt = value[4];
    return NULL;
}

double celestial_choreography(size_t count)
{
    double sum = 0, c, s;
    for (size_t j = 1; j < count; ++j) {
        kepler_turn(KEPLER_PI * (double)j / (double)count, &c, &s);
        sum += 1 / s;
    }
    return sum / sqrt(2);
}

/* Builds equal bodies on a circle. The parameter `kick` displaces the first
   body so that the bodies leave the circle sooner. */
static const char *build_choreography(struct scene *s, const double value[])
{
    const size_t count = (size_t)value[0];
    const double speed =
        sqrt(celestial_choreography(count) / sqrt(8)) * value[1];
    if (!scene_create(s, count))
        return no_memory;
    for (size_t i = 0; i < count; ++i) {
        double c, sine;
        kepler_turn(2 * KEPLER_PI * (double)i / (double)count, &c, &sine);
        put(s, i, 1, c, sine, -speed * sine, speed * c);
        paint(s, i, 0.03, 0.3, 0.3, 1);
    }
    s->position[0] += value[2];
    s->k2 = 1;
    s->dt = value[3];
    return NULL;
}

/* Returns P_m, the sum of (1 - cos(m phi)) / |1 - e^(i phi)|^3 over the
   angles phi of the other bodies: (9.12, eq:choreography-modes). */
static double stiffness(size_t count, size_t m)
{
    double sum = 0, c, s, cm, sm;
    for (size_t j = 1; j < count; ++j) {
        const double angle = KEPLER_PI * (double)j / (double)count;
        kepler_turn(angle, &c, &s);
        kepler_turn(2 * angle * (double)(m % count), &cm, &sm);
        sum += (1 - cm) / (8 * s * s * s);
    }
    return sum;
}

/* Returns the largest imaginary part of the four roots of w^4 + c[2] w^2 +
   c[1] w + c[0]. Weierstrass's method improves one root after another, each
   as if the other roots were exact. */
static double largest_imaginary(const double c[3])
{
    const double complex begin = 0.4 + 0.9 * I;
    double complex w[4] = {1, begin, begin * begin, begin * begin * begin};
    double most = 0;
    for (int turn = 0; turn < 200; ++turn)
        for (int i = 0; i < 4; ++i) {
            double complex z = w[i], p = 1;
            for (int j = 0; j < 4; ++j)
                p *= j == i ? 1 : z - w[j];
            w[i] -= (((z * z + c[2]) * z + c[1]) * z + c[0]) / p;
        }
    for (int i = 0; i < 4; ++i)
        most = fmax(most, cimag(w[i]));
    return most;
}

double celestial_growth(size_t count)
{
    const double square = celestial_choreography(count) / sqrt(8);
    const double first = stiffness(count, 1);
    double most = 0;
    for (size_t k = 0; k < count; ++k) {
        const double a = 1 + stiffness(count, k + 1) / (2 * square);
        const double b = 1 + stiffness(count, k + count - 1) / (2 * square);
        const double mix = 1.5 * (first - stiffness(count, k)) / square;
        const double c[] = {a * b - mix * mix, -2 * (a - b), a + b - 4};
        most = fmax(most, largest_imaginary(c));
    }
    return most;
}

/* Builds three bodies that follow each other on a figure of eight. The
   initial values of this orbit are known to thirty digits. */
static const char *build_figure_eight(struct scene *s, const double value[])
{
    const double x = 0.970004356697333439943496928324;
    const double y = -0.243087531535848861715739838256;
    const double vx = -0.932407371441052301548231764005;
    const double vy = -0.864731460921005956374659068751;
    if (!scene_create(s, 3))
        return no_memory;
    put(s, 0, 1, x, y, -vx / 2, -vy / 2);
    put(s, 1, 1, -x, -y, -vx / 2, -vy / 2);
    put(s, 2, 1, 0, 0, vx, vy);
    for (size_t i = 0; i < 3; ++i)
        paint(s, i, 0.03, i == 0, i == 1, i == 2);
    s->k2 = 1;
    s->dt = value[0];
    return NULL;
}

/* Builds Burrau's problem with G = 1: masses of 3, 4 and 5 at rest at the
   corners of a triangle with sides of length 3, 4 and 5. Each mass is
   opposite the side whose length is the same number. The centre of mass is
   the origin. */
static const char *build_pythagorean(struct scene *s, const double value[])
{
    if (!scene_create(s, 3))
        return no_memory;
    put(s, 0, 3, 1, 3, 0, 0);
    put(s, 1, 4, -2, -1, 0, 0);
    put(s, 2, 5, 1, -1, 0, 0);
    for (size_t i = 0; i < 3; ++i)
        paint(s, i, 0.05, i == 0, i == 1, i == 2);
    s->k2 = 1;
    s->dt = value[0];
    return NULL;
}

/* Returns the difference K - E of the complete elliptic integrals with the
   modulus q, 0 <= q <= 1, by the arithmetic-geometric mean. */
static double elliptic_difference(double q)
{
    double a = 1, b = sqrt((1 - q) * (1 + q)), c = q;
    double sum = c * c / 2, power = 0.5;
    if (b == 0)
        return INFINITY;
    while (c > 1e-9 * a) {
        const double mean = (a + b) / 2;
        c = (a - b) / 2;
        b = sqrt(a * b);
        a = mean;
        power *= 2;
        sum += power * c * c;
    }
    return KEPLER_PI / (2 * a) * sum;
}

/* Returns the inward acceleration, with k2 = 1, at the radius r due to a
   disk of radius a and unit surface density: (9.13, eq:disk-field). */
static double disk_pull(double a, double r)
{
    if (r == 0)
        return 0;
    return r < a ? 4 * elliptic_difference(r / a) * a / r
                 : 4 * elliptic_difference(a / r);
}

double celestial_ring_pull(double mass, double inner, double outer,
                           double r)
{
    const double area = KEPLER_PI * (outer - inner) * (outer + inner);
    return mass / area * (disk_pull(outer, r) - disk_pull(inner, r));
}

/* The parameters of the scene `ring`. */
struct ring {
    size_t particles;
    double mass, inner, outer, softening, moon, moon_distance;
    bool own; /* speeds include the pull of the ring itself */
    int decades;
};

/* Returns the speed of a circular orbit of radius r around the planet and
   its ring, or NaN if the ring pulls outwards there more than the planet
   pulls inwards. */
static double ring_speed(const struct ring *g, double r)
{
    const double s = r * r + g->softening * g->softening;
    double pull = r / (s * sqrt(s));
    if (g->own)
        pull += celestial_ring_pull(g->mass * (double)g->particles,
                                    g->inner, g->outer, r);
    return sqrt(CELESTIAL_K2 * r * pull);
}

/* Puts body i at a random position in the ring. r^2 is uniformly
   distributed between the edges, so equal areas are equally likely. */
static void put_random(struct scene *s, size_t i, const struct ring *g,
                       struct random *random)
{
    const double u = random_uniform(random) + 0x1p-54; /* u is never 0 */
    const double low = g->inner * g->inner, high = g->outer * g->outer;
    const double r = sqrt(low + u * (high - low)), v = ring_speed(g, r);
    double d[2];
    random_direction(random, 2, d);
    put(s, i, g->mass, r * d[0], r * d[1], -v * d[1], v * d[0]);
    paint(s, i, 0.005, 0.6, 0.6, 0.6);
}

/* Gives the particles random masses, uniformly distributed on a logarithmic
   scale. The total mass stays the same. */
static void mix_masses(struct scene *s, const struct ring *g,
                       struct random *random)
{
    double widest = 1, sum = 0;
    for (int k = 0; k < g->decades; ++k)
        widest *= 10;
    for (size_t i = 1; i <= g->particles; ++i)
        sum += s->mass[i] = random_log_uniform(random, 1, widest);
    for (size_t i = 1; i <= g->particles; ++i)
        s->mass[i] *= g->mass * (double)g->particles / sum;
}

/* Builds a planet (body 0), its ring, and a moon (the last body) if its
   mass is not 0. Returns an error if the ring is too heavy for orbits. */
static const char *build_ring(struct scene *s, const double value[])
{
    const struct ring g = {(size_t)value[0], value[1] * value[2],
                           value[3],         value[4],
                           value[5],         value[7],
                           value[8],         value[6] != 0,
                           (int)value[9]};
    const size_t bodies = 1 + g.particles + (g.moon > 0);
    struct random random;
    if (g.inner >= g.outer)
        return "--inner: it is not less than --outer";
    if (!scene_create(s, bodies))
        return no_memory;
    random_seed(&random, (uint64_t)value[10]);
    put(s, 0, 1, 0, 0, 0, 0);
    paint(s, 0, 0.2, 1, 0.8, 0.5);
    for (size_t i = 1; i <= g.particles; ++i)
        put_random(s, i, &g, &random);
    if (g.decades > 0)
        mix_masses(s, &g, &random);
    if (g.moon > 0) {
        put(s, bodies - 1, g.moon, g.moon_distance, 0, 0,
            ring_speed(&g, g.moon_distance));
        paint(s, bodies - 1, 0.03, 0.3, 0.3, 1);
    }
    centre(s);
    for (size_t i = 0; i < bodies; ++i)
        if (isnan(s->velocity[bodies + i])) {
            scene_free(s);
            return "the ring is too heavy: it pulls harder than its planet "
                   "(--mass, --factor, --own)";
        }
    s->k2 = CELESTIAL_K2;
    s->softening = g.softening;
    s->dt = 4;
    return NULL;
}

const struct gallery_scene celestial_scenes[] = {
    {"sun-earth",
     "the Sun and the Earth, AU and days",
     {{"mass", 3e-6, 0, 1, false, "of the Earth, the Sun's being 1"},
      {"speed", 1, 0, 1.4, false, "of the Earth, in units of a circle's"},
      {"centred", 0, 0, 1, true, "1: the centre of mass at rest"},
      {"dt", 0.03, 1e-6, 100, false, "time step, d"}},
     build_sun_earth},
    {"solar-system",
     "the planets on 1 January 2000, AU and days",
     {{"jupiter", 1, 0, 1000, false, "factor on Jupiter's mass"},
      {"planets", 8, 1, 8, true, "how many, from Mercury on"},
      {"dt", 1, 1e-6, 100, false, "time step, d"}},
     build_solar_system},
    {"circumbinary",
     "a planet of two stars: Kepler-16 on circles, AU and days",
     {{"distance", 0.7048, 0.3, 10, false,
       "of the planet from the centre of mass, AU"},
      {"eccentricity", 0, 0, 0.9, false,
       "of the stars' orbit (Kepler-16: 0.159)"},
      {"phase", 0, 0, 1, false, "where the planet begins, turns"},
      {"planet", 0.318e-3, 0, 0.1, false, "its mass, the Sun's being 1"},
      {"dt", 0.2, 1e-6, 10, false, "time step, d"}},
     build_circumbinary},
    {"choreography",
     "equal bodies on one circle of radius 1",
     {{"particles", 3, 2, 10000, true, "how many"},
      {"speed", 1, 0, 1.4, false, "in units of a circle's"},
      {"kick", 0, -0.1, 0.1, false, "displaces the first one along x"},
      {"dt", 0.01, 1e-9, 1, false, "time step"}},
     build_choreography},
    {"figure-eight",
     "three bodies on one curve",
     {{"dt", 0.01, 1e-9, 1, false, "time step"}},
     build_figure_eight},
    {"pythagorean",
     "masses 3, 4 and 5 at rest on a triangle",
     {{"dt", 0.01, 1e-9, 1, false, "time step"}},
     build_pythagorean},
    {"ring",
     "a planet of mass 1 and its ring, AU and days",
     {{"particles", 3072, 1, 1000000, true, "how many"},
      {"mass", 1e-8, 0, 1e-3, false, "of each"},
      {"factor", 1, 0, 1e5, false, "on all of these masses"},
      {"inner", 2, 0.01, 1000, false, "radius, AU"},
      {"outer", 2.5, 0.01, 1000, false, "radius, AU"},
      {"softening", 0.01, 0, 1, false, "AU"},
      {"own", 1, 0, 1, true, "1: the speeds count the ring's own pull"},
      {"moon", 0, 0, 0.1, false, "mass of a moon, the planet's being 1"},
      {"moon-distance", 3.2, 0.01, 1000, false, "of the moon, AU"},
      {"mixed", 0, 0, 6, true, "decades of different masses"},
      {"seed", 1, 0, 1e15, true, "of the random places"}},
     build_ring},
    {0}};
