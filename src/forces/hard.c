/* Builds scenes of hard bodies: a cradle, a break, gases and lines. */
#include "forces/hard.h"

#include "toolbox/random.h"

#include <math.h>

static const char no_memory[] = "there is no memory for so many bodies";

/* Creates a scene of colliding bodies, all of the same radius. */
static bool create(struct scene *s, size_t bodies, double radius, double dt)
{
    if (!scene_create(s, bodies))
        return false;
    s->contact = true;
    s->dt = dt;
    for (size_t i = 0; i < bodies; ++i)
        s->radius[i] = radius;
    return true;
}

/* Makes a body free along the first `axes` axes and fixed along the
   rest. */
static void free_along(struct scene *s, size_t body, size_t axes)
{
    for (size_t k = 0; k < SCENE_AXES; ++k)
        s->freedom[k * s->bodies + body] = k < axes;
}

static void set_walls(struct scene *s, size_t k, enum scene_wall wall,
                      double low, double high)
{
    s->wall[k] = wall;
    s->low[k] = low;
    s->high[k] = high;
}

enum {
    CRADLE_BALLS,
    CRADLE_LEFT,
    CRADLE_RIGHT,
    CRADLE_GAP,
    CRADLE_FIRST,
    CRADLE_LAST,
    CRADLE_MIDDLE,
    CRADLE_RESTITUTION,
    CRADLE_STRING,
    CRADLE_DT
};

static const double cradle_radius = 0.1, cradle_way = 0.5; /* m */

/* Places the balls of the cradle along x. The moving balls start half a
   metre away from the row. */
static void place_in_a_row(struct scene *s, const double value[])
{
    const size_t n = (size_t)value[CRADLE_BALLS];
    for (size_t i = 0; i < n; ++i) {
        const double side = i < (size_t)value[CRADLE_LEFT]         ? -1
                            : n - i <= (size_t)value[CRADLE_RIGHT] ? 1
                                                                   : 0;
        s->position[i] =
            (double)i * (2 * cradle_radius + value[CRADLE_GAP]) +
            side * cradle_way;
        s->velocity[i] = -side;
    }
    s->mass[0] = value[CRADLE_FIRST];
    s->mass[n - 1] = value[CRADLE_LAST];
    if (n > 2)
        s->mass[n / 2] = value[CRADLE_MIDDLE];
    s->restitution = value[CRADLE_RESTITUTION];
}

static const double cradle_stiffness = 1e5, cradle_gravity = 9.81;

/* Hangs each ball on a string: a stiff spring from a fixed body above it.
   A ball that has a velocity is pulled aside instead and starts at rest.
   The rest length is shorter than the string by the stretch due to the
   ball's weight, so a ball hanging straight down is in equilibrium.
   Returns false if memory runs out. */
static bool hang(struct scene *s, size_t balls, double length)
{
    const size_t n = s->bodies;
    bool done = scene_add_kind(s, cradle_stiffness, 0);
    s->gravity[2] = -cradle_gravity;
    for (size_t i = 0; i < balls; ++i) {
        const double aside = -s->velocity[i] * cradle_way;
        const size_t top = balls + i;
        s->velocity[i] = 0;
        s->freedom[2 * n + i] = 1;
        s->position[2 * n + i] =
            length - sqrt(length * length - aside * aside);
        s->position[top] = s->position[i] - aside;
        s->position[2 * n + top] = length;
        s->radius[top] = 0;
        free_along(s, top, 0);
        done =
            done && scene_add_spring(s, i, top, 0,
                                     length - s->mass[i] * cradle_gravity /
                                                  cradle_stiffness);
    }
    return done;
}

static const char *build_cradle(struct scene *s, const double value[])
{
    const size_t balls = (size_t)value[CRADLE_BALLS];
    const bool hanging = value[CRADLE_STRING] > 0;
    if (value[CRADLE_LEFT] + value[CRADLE_RIGHT] > value[CRADLE_BALLS])
        return "more balls would move than there are";
    if (hanging && value[CRADLE_STRING] <= cradle_way)
        return "the string is too short: balls are pulled aside by 0.5 m";
    if (!create(s, hanging ? 2 * balls : balls, cradle_radius,
                value[CRADLE_DT]))
        return no_memory;
    for (size_t i = 0; i < balls; ++i)
        free_along(s, i, 1);
    place_in_a_row(s, value);
    if (hanging && !hang(s, balls, value[CRADLE_STRING])) {
        scene_free(s);
        return no_memory;
    }
    if (!hanging) {
        const double end =
            (double)(balls - 1) * (2 * cradle_radius + value[CRADLE_GAP]);
        /* A ball that flies out moves by twice cradle_way before a wall
           reflects it. */
        const double room = cradle_radius + 2 * cradle_way;
        set_walls(s, 0, SCENE_HARD, -room, end + room);
    }
    return NULL;
}

enum {
    BREAK_GAP,
    BREAK_SPEED,
    BREAK_OFFSET,
    BREAK_JITTER,
    BREAK_SEED,
    BREAK_RESTITUTION,
    BREAK_TABLE,
    BREAK_DT
};

enum { BREAK_BALLS = 16 }; /* including body 0, the cue ball */

/* Billiards on a nine-foot table. */
static const double ball_radius = 0.028575, ball_mass = 0.17,   /* m, kg */
    cue_place = -1.27, table_length = 2.54, table_width = 1.27; /* m */

/* Places the balls in a triangle, with the given distance (in m) between
   neighbours. Displaces each ball at random by up to `jitter` (in m) along
   x and y. */
static void rack(struct scene *s, double distance, double jitter,
                 struct random *r)
{
    const size_t n = s->bodies;
    size_t i = 1;
    for (int row = 0; row < 5; ++row)
        for (int place = 0; place <= row; ++place, ++i) {
            s->position[i] = row * distance * sqrt(0.75) +
                             random_between(r, -jitter, jitter);
            s->position[n + i] = (place - row / 2.0) * distance +
                                 random_between(r, -jitter, jitter);
        }
}

static const char *build_break(struct scene *s, const double value[])
{
    struct random r;
    if (!create(s, BREAK_BALLS, ball_radius, value[BREAK_DT]))
        return no_memory;
    random_seed(&r, (uint64_t)value[BREAK_SEED]);
    for (size_t i = 0; i < BREAK_BALLS; ++i) {
        s->mass[i] = ball_mass;
        free_along(s, i, 2);
    }
    s->restitution = value[BREAK_RESTITUTION];
    rack(s, 2 * ball_radius + value[BREAK_GAP], value[BREAK_JITTER], &r);
    s->position[0] = cue_place;
    s->position[BREAK_BALLS] = value[BREAK_OFFSET];
    s->velocity[0] = value[BREAK_SPEED];
    if (value[BREAK_TABLE] > 0) {
        set_walls(s, 0, SCENE_HARD, table_length / 4 - table_length,
                  table_length / 4);
        set_walls(s, 1, SCENE_HARD, -table_width / 2, table_width / 2);
    }
    return NULL;
}

enum {
    GAS_DISKS,
    GAS_RADIUS,
    GAS_WIDTH,
    GAS_HEIGHT,
    GAS_SPEED,
    GAS_LATTICE,
    GAS_SEED,
    GAS_RESTITUTION,
    GAS_DT,
    GAS_HEAVY, /* mass of the heavy disk, in brownian only */
    GAS_HEAVY_RADIUS
};

/* Builds a scene from disks and their box. A disk whose mass is not 1
   becomes species 1. Returns false if memory runs out. */
static bool copy_disks(struct scene *s, const struct disks *d, double dt)
{
    const size_t n = d->count;
    if (!create(s, n, 0, dt))
        return false;
    for (size_t i = 0; i < n; ++i) {
        s->mass[i] = d->mass[i];
        s->radius[i] = d->disk[i].radius;
        s->species[i] = d->mass[i] != 1;
        free_along(s, i, d->dimensions);
        for (size_t k = 0; k < SCENE_AXES; ++k) {
            s->position[k * n + i] = d->disk[i].position[k];
            s->velocity[k * n + i] = d->disk[i].velocity[k];
        }
    }
    for (size_t k = 0; k < d->dimensions; ++k)
        set_walls(s, k, SCENE_HARD, 0, d->box[k]);
    return true;
}

/* Builds a gas with the functions of chapter 5. The scene four-disks
   therefore starts in exactly the same state as `disks --disks 4 --radius
   0.15 --box 1,1`, and the scene gas in the same state as `disks --disks
   250 --radius 0.1 --box 7.5,5 --start random`. A heavy disk is placed
   first, while the box is empty. It gets the kinetic energy of a light
   disk. */
static const char *fill_gas(struct scene *s, struct disks *d,
                            const double value[], double heavy,
                            double heavy_radius)
{
    struct random r;
    random_seed(&r, (uint64_t)value[GAS_SEED]);
    d->box[0] = value[GAS_WIDTH];
    d->box[1] = value[GAS_HEIGHT];
    for (size_t i = 0; i < d->count; ++i)
        d->disk[i].radius = value[GAS_RADIUS];
    if (heavy > 0) {
        d->mass[0] = heavy;
        d->disk[0].radius = heavy_radius;
    }
    if (!(value[GAS_LATTICE] > 0 ? disks_place_lattice(d)
                                 : disks_place_random(d, &r)))
        return "the disks find no place in the box";
    disks_set_speed(d, value[GAS_SPEED], &r);
    for (size_t k = 0; heavy > 0 && k < d->dimensions; ++k)
        d->disk[0].velocity[k] /= sqrt(heavy);
    if (!copy_disks(s, d, value[GAS_DT]))
        return no_memory;
    s->restitution = value[GAS_RESTITUTION];
    return NULL;
}

static const char *build_box(struct scene *s, const double value[],
                             double heavy, double heavy_radius)
{
    struct disks d;
    if (!disks_create(&d, 2, (size_t)value[GAS_DISKS] + (heavy > 0)))
        return no_memory;
    const char *wrong = fill_gas(s, &d, value, heavy, heavy_radius);
    disks_free(&d);
    return wrong;
}

static const char *build_gas(struct scene *s, const double value[])
{
    return build_box(s, value, 0, 0);
}

static const char *build_brownian(struct scene *s, const double value[])
{
    return build_box(s, value, value[GAS_HEAVY], value[GAS_HEAVY_RADIUS]);
}

enum { LINE_BODIES, LINE_RATIO, LINE_RADIUS, LINE_SEED, LINE_DT };

/* Copies the bodies of a start into a scene, beginning with body `first`.
   The bodies of the start are points, but (2.2, eq:rods) allows giving them
   a radius: body i is shifted to the right by 2i + 1 radii, and the right
   wall by 2n radii for n bodies. The motion is otherwise unchanged. */
static void copy_start(struct scene *s, const struct start *start,
                       size_t first, double radius)
{
    for (size_t i = 0; i < start->movers; ++i) {
        const size_t at = first + i;
        s->mass[at] = start->mass[i];
        s->position[at] = start->x[i] + (double)(2 * i + 1) * radius;
        s->velocity[at] = start->v[i];
        free_along(s, at, 1);
    }
}

/* Builds a scene from a start on a line. Galperin's start has a wall on one
   side only, but a box has walls on both sides. The first body of the
   scene, which is fixed, therefore represents the wall. */
static const char *build_line(struct scene *s, const double value[],
                              enum start_kind kind)
{
    struct start start;
    const struct start_request request = {
        .kind = kind,
        .movers = (size_t)value[LINE_BODIES],
        .ratio = value[LINE_RATIO],
        .seed = (uint64_t)value[LINE_SEED]};
    const double r = value[LINE_RADIUS];
    if (!start_allows(kind, request.movers))
        return "so many bodies are not possible: a piston needs as many on "
               "either side";
    if (!start_fill(&start, &request))
        return no_memory;
    const bool wall = isinf(start.wall[1]);
    const bool made = create(s, start.movers + wall, r, value[LINE_DT]);
    if (made) {
        copy_start(s, &start, wall, r);
        if (wall) {
            s->position[0] = start.wall[0] - r;
            free_along(s, 0, 0);
        } else
            set_walls(s, 0, SCENE_HARD, start.wall[0],
                      start.wall[1] + 2 * (double)start.movers * r);
    }
    start_free(&start);
    return made ? NULL : no_memory;
}

static const char *build_thermal(struct scene *s, const double value[])
{
    const double all[] = {value[0], 0, value[1], value[2], value[3]};
    return build_line(s, all, START_THERMAL);
}

static const char *build_piston(struct scene *s, const double value[])
{
    return build_line(s, value, START_PISTON);
}

static const char *build_galperin(struct scene *s, const double value[])
{
    const double all[] = {2, value[0], value[1], 1, value[2]};
    return build_line(s, all, START_GALPERIN);
}

/* Versions of clang-format differ on macros that begin with a brace. */
/* clang-format off */
#define GAS_KEYS                                                           \
    {"width", 7.5, 1e-9, 1e6, false, "of the box, m"},                     \
    {"height", 5, 1e-9, 1e6, false, "of the box, m"},                      \
    {"speed", 1, 0, 1e6, false, "of each disk, m/s"},                      \
    {"lattice", 0, 0, 1, true, "1: on a lattice; 0: at random"},           \
    {"seed", 1, 0, 9e15, true, "of the random numbers"},                   \
    {"restitution", 1, 0, 1, false, "of all collisions"},                  \
    {"dt", 0.01, 1e-9, 1, false, "step, s"}

#define LINE_KEYS                                                          \
    {"radius", 0.05, 0, 1, false, "of each body, m; 0: points"},           \
    {"seed", 1, 0, 9e15, true, "of the random numbers"},                   \
    {"dt", 0.01, 1e-9, 1, false, "step, s"}
/* clang-format on */
const struct gallery_scene hard_scenes[] = {
    {"cradle",
     "Newton's cradle between two walls, or on strings",
     {{"balls", 5, 2, 1000, true, "how many balls"},
      {"left", 1, 0, 1000, true, "how many fly in from the left"},
      {"right", 0, 0, 1000, true, "how many from the right"},
      {"gap", 0.01, 0, 10, false, "between neighbours, m"},
      {"first", 1, 1e-9, 1e9, false, "mass of the first ball, kg"},
      {"last", 1, 1e-9, 1e9, false, "mass of the last ball, kg"},
      {"middle", 1, 1e-9, 1e9, false, "mass of the middle ball, kg"},
      {"restitution", 1, 0, 1, false, "of all collisions"},
      {"string", 0, 0, 1000, false, "its length, m; 0: walls"},
      {"dt", 0.001, 1e-9, 1, false, "step, s"}},
     build_cradle},
    {"break",
     "the first shot at billiards",
     {{"gap", 1e-4, 0, 1, false, "between balls of the rack, m"},
      {"speed", 8, 0, 1000, false, "of the cue ball, m/s"},
      {"offset", 0, -1, 1, false, "of its path from the middle, m"},
      {"jitter", 0, 0, 0.01, false, "of places in the rack, at most, m"},
      {"seed", 1, 0, 9e15, true, "of the jitter"},
      {"restitution", 1, 0, 1, false, "of all collisions"},
      {"table", 0, 0, 1, true, "1: with cushions"},
      {"dt", 1e-5, 1e-12, 1, false, "step, s"}},
     build_break},
    {"gas",
     "the 250 disks of MPPhys, all of one speed",
     {{"particles", 250, 1, 1e6, true, "how many disks"},
      {"radius", 0.1, 1e-9, 1e3, false, "m"},
      GAS_KEYS},
     build_gas},
    {"brownian",
     "one heavy disk among light ones",
     {{"particles", 250, 1, 1e6, true, "how many light disks"},
      {"radius", 0.1, 1e-9, 1e3, false, "of the light ones, m"},
      GAS_KEYS,
      {"mass", 40, 1e-9, 1e9, false, "of the heavy one, kg"},
      {"heavy-radius", 0.5, 1e-9, 1e3, false, "of the heavy one, m"}},
     build_brownian},
    {"four-disks",
     "the four disks of chapter 5",
     {{"particles", 4, 1, 1e6, true, "how many disks"},
      {"radius", 0.15, 1e-9, 1e3, false, "m"},
      {"width", 1, 1e-9, 1e6, false, "of the box, m"},
      {"height", 1, 1e-9, 1e6, false, "of the box, m"},
      {"speed", 1, 0, 1e6, false, "of each disk, m/s"},
      {"lattice", 1, 0, 1, true, "1: on a lattice; 0: placed at random"},
      {"seed", 1, 0, 9e15, true, "of the random numbers"},
      {"restitution", 1, 0, 1, false, "of all collisions"},
      {"dt", 0.005, 1e-9, 1, false, "step, s"}},
     build_gas},
    {"thermal",
     "light bodies left, heavy ones right (chapter 3)",
     {{"particles", 10, 2, 1e6, true, "how many bodies"}, LINE_KEYS},
     build_thermal},
    {"piston",
     "a heavy body between two gases (chapter 4)",
     {{"particles", 11, 3, 999999, true, "how many bodies, odd"},
      {"mass-ratio", 30, 1e-9, 1e9, false,
       "of the piston to the others' mean"},
      LINE_KEYS},
     build_piston},
    {"galperin",
     "two bodies and a wall, which count the digits of pi",
     {{"mass-ratio", 100, 1e-9, 1e12, false, "of the second to the first"},
      {"radius", 0.05, 0, 1, false, "of each body, m; 0: points"},
      {"dt", 0.01, 1e-9, 1, false, "step, s"}},
     build_galperin},
    {0}};
/* Returns whether the bodies have different z or move along z. */
static bool is_deep(const struct scene *s)
{
    const double *z = s->position + 2 * s->bodies;
    const double *v = s->velocity + 2 * s->bodies;
    for (size_t i = 0; i < s->bodies; ++i)
        if (z[i] != z[0] || v[i] != 0)
            return true;
    return false;
}

/* The engine of chapter 5 also simulates spheres, so a scene that is not
   planar is given three axes. */
bool hard_disks(struct disks *d, const struct scene *s)
{
    const size_t n = s->bodies;
    if (!disks_create(d, is_deep(s) ? 3 : 2, n))
        return false;
    if (s->wall[0] == SCENE_PERIODIC)
        d->boundary = DISKS_PERIODIC;
    d->restitution = s->restitution;
    for (size_t k = 0; k < d->dimensions; ++k) {
        d->box[k] = s->high[k] - s->low[k];
        for (size_t i = 0; i < n; ++i) {
            d->disk[i].position[k] = s->position[k * n + i] - s->low[k];
            d->disk[i].velocity[k] = s->velocity[k * n + i];
        }
    }
    for (size_t i = 0; i < n; ++i) {
        d->mass[i] = s->mass[i];
        d->disk[i].radius = s->radius[i];
    }
    return true;
}

/* The engine of chapter 2 has no fixed bodies. The body that represents the
   wall in Galperin's scene therefore becomes the left wall again. */
bool hard_start(struct start *start, const struct scene *s)
{
    const size_t wall = s->bodies > 0 && !s->freedom[0];
    if (!start_create(start, s->bodies - wall))
        return false;
    for (size_t i = 0; i < start->movers; ++i) {
        start->mass[i] = s->mass[wall + i];
        start->radius[i] = s->radius[wall + i];
        start->x[i] = s->position[wall + i];
        start->v[i] = s->velocity[wall + i];
    }
    const bool hard = s->wall[0] == SCENE_HARD;
    start->wall[0] = hard   ? s->low[0]
                     : wall ? s->position[0] + s->radius[0]
                            : -INFINITY;
    start->wall[1] = hard ? s->high[0] : INFINITY;
    start->until = INFINITY;
    return true;
}
