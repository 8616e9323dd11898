/* Builds scenes of bodies joined by springs: pairs, chains and grids. */
#include "forces/elastic.h"

#include <math.h>

static const char no_memory[] = "there is no memory";

/* Returns NULL if `made` is true. Otherwise frees the scene and returns
   the reason. */
static const char *finish(struct scene *s, bool made)
{
    if (!made)
        scene_free(s);
    return made ? NULL : no_memory;
}

/* Returns the sine of x, |x| <= pi, from its power series. The result is
   bit-identical on all machines, unlike the sine of libm. */
static double sine(double x)
{
    double term = x, sum = 0;
    for (int k = 1; k < 20; ++k) {
        sum += term;
        term *= -x * x / (2 * k * (2 * k + 1));
    }
    return sum + term;
}

/* Returns the cosine of x, |x| <= 2 pi, from the sine of x/2. */
static double cosine(double x)
{
    const double half = sine(x / 2);
    return 1 - 2 * half * half;
}

/* Returns sin(pi i r / n). The wave repeats after 2n, changes sign after n
   and is symmetric about n/2, so the angle is reduced to the first quarter
   of the wave. This makes a symmetric membrane exactly symmetric, and the
   result exactly 0 at multiples of n. */
static double sine_of_wave(size_t i, size_t r, size_t n)
{
    const double pi = 3.141592653589793;
    size_t k = i * r % (2 * n);
    const double sign = k > n ? -1 : 1;
    k = k > n ? k - n : k;
    k = 2 * k > n ? n - k : k;
    return sign * sine(pi * (double)k / (double)n);
}

enum { O_MASS, O_STIFFNESS, O_DAMPING, O_PLACE, O_VELOCITY, O_LENGTH };

/* Builds a fixed body and a body that is free along x. The rest length of
   their spring is their distance before the displacement. Refuses a
   displacement beyond the fixed body, where the force would reverse. */
static const char *oscillator(struct scene *s, const double value[])
{
    const double length = value[O_LENGTH];
    if (!(value[O_PLACE] > -length))
        return "the spring would be turned over: --length must be more";
    if (!scene_create(s, 2))
        return no_memory;
    s->mass[1] = value[O_MASS];
    s->position[1] = length;
    s->velocity[1] = value[O_VELOCITY];
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        s->freedom[2 * k] = 0;
        s->freedom[2 * k + 1] = k == 0;
    }
    s->dt = 0.01;
    const bool made =
        scene_add_kind(s, value[O_STIFFNESS], value[O_DAMPING]) &&
        scene_add_spring(s, 0, 1, 0, -1);
    s->position[1] += value[O_PLACE];
    return finish(s, made);
}

enum {
    P_STIFFNESS1,
    P_STIFFNESS2,
    P_ANGLE1,
    P_ANGLE2,
    P_LENGTH,
    P_MASS1,
    P_MASS2,
    P_GRAVITY,
    P_DAMPING
};

/* Puts body i at (x, z), free in the plane y = 0. */
static void hang(struct scene *s, size_t i, double mass, double x, double z)
{
    s->mass[i] = mass;
    s->position[i] = x;
    s->position[2 * s->bodies + i] = z;
    s->freedom[s->bodies + i] = 0;
}

/* Builds a double pendulum in the plane of x and z. The rest lengths of
   the springs are exactly the requested lengths. Lengths computed from the
   positions would contain rounding errors. */
static const char *double_pendulum(struct scene *s, const double value[])
{
    const double l = value[P_LENGTH];
    const double x = l * sine(value[P_ANGLE1]);
    const double z = l - l * cosine(value[P_ANGLE1]);
    if (!scene_create(s, 3))
        return no_memory;
    hang(s, 0, 1, 0, l);
    s->freedom[0] = s->freedom[6] = 0;
    hang(s, 1, value[P_MASS1], x, z);
    hang(s, 2, value[P_MASS2], x + l * sine(value[P_ANGLE2]),
         z - l * cosine(value[P_ANGLE2]));
    s->gravity[2] = -value[P_GRAVITY];
    s->dt = 1e-3;
    return finish(
        s, scene_add_kind(s, value[P_STIFFNESS1], value[P_DAMPING]) &&
               scene_add_kind(s, value[P_STIFFNESS2], value[P_DAMPING]) &&
               scene_add_spring(s, 0, 1, 0, l) &&
               scene_add_spring(s, 1, 2, 1, l));
}

/* Places the bodies of a grid in the plane z = 0, row by row. All springs
   of one direction then join bodies whose numbers differ by the same
   amount, so these springs form a band (springs.c). */
static void lay_out(struct scene *s, size_t nx, size_t ny, double x0,
                    double y0, double dx, double dy)
{
    for (size_t y = 0; y < ny; ++y)
        for (size_t x = 0; x < nx; ++x) {
            s->position[y * nx + x] = x0 + (double)x * dx;
            s->position[s->bodies + y * nx + x] = y0 + (double)y * dy;
        }
}

/* Joins each body of the grid to the body `right` columns to the right and
   `up` rows above, if there is one, by a spring of this rest length.
   `right` may be -1. Returns false if memory runs out. */
static bool join(struct scene *s, size_t nx, size_t ny, int right, int up,
                 double rest)
{
    const size_t first = right < 0, last = nx - (right > 0);
    for (size_t y = 0; y + (size_t)up < ny; ++y)
        for (size_t x = first; x < last; ++x) {
            const size_t a = y * nx + x;
            const size_t b = a + (size_t)up * nx + (size_t)right;
            if (!scene_add_spring(s, a, b, 0, rest))
                return false;
        }
    return true;
}

/* Sets the masses, fixes the bodies of the rim, and displaces the other
   bodies along z. */
static void excite(struct scene *s, const struct elastic_membrane *m)
{
    for (size_t y = 0; y < m->ny; ++y)
        for (size_t x = 0; x < m->nx; ++x) {
            const size_t i = y * m->nx + x;
            const bool rim =
                x == 0 || y == 0 || x + 1 == m->nx || y + 1 == m->ny;
            s->mass[i] = m->mass;
            s->freedom[i] = s->freedom[s->bodies + i] = !rim && m->free;
            s->freedom[2 * s->bodies + i] = !rim;
            s->position[2 * s->bodies + i] =
                m->amplitude * sine_of_wave(x, m->r, m->nx - 1) *
                sine_of_wave(y, m->s, m->ny - 1);
        }
}

/* The grid extends from -1 to 1 m along x, as in the MPPhys paper. The
   cells are square, which determines the height. */
const char *elastic_membrane(struct scene *s,
                             const struct elastic_membrane *m)
{
    const double d = 2 / (double)(m->nx - 1), rest = m->rest * d;
    if (!scene_create(s, m->nx * m->ny))
        return no_memory;
    lay_out(s, m->nx, m->ny, -1, -0.5 * d * (double)(m->ny - 1), d, d);
    excite(s, m);
    s->gravity[2] = -m->gravity;
    s->damping = m->friction;
    s->dt = 0.01;
    return finish(s, scene_add_kind(s, m->stiffness, m->damping) &&
                         join(s, m->nx, m->ny, 1, 0, rest) &&
                         join(s, m->nx, m->ny, 0, 1, rest));
}

/* The keys of the scene are in the order of the struct's members. */
static const char *membrane(struct scene *s, const double value[])
{
    const struct elastic_membrane m = {
        (size_t)value[0], (size_t)value[1], value[2],  value[3],
        value[4],         value[5],         value[6],  (size_t)value[7],
        (size_t)value[8], value[9] > 0,     value[10], value[11]};
    return elastic_membrane(s, &m);
}

enum {
    C_NX,
    C_NY,
    C_DX,
    C_DY,
    C_MASS,
    C_STIFFNESS,
    C_DAMPING,
    C_DIAGONALS,
    C_GRAVITY,
    C_FRICTION
};

/* Adds the springs of a truss: springs along both axes, and 0, 1 or 2
   diagonals in each cell. Returns false if memory runs out. */
static bool truss(struct scene *s, size_t nx, size_t ny, double dx,
                  double dy, int diagonals)
{
    const double slant = sqrt(dx * dx + dy * dy);
    return join(s, nx, ny, 1, 0, dx) && join(s, nx, ny, 0, 1, dy) &&
           (diagonals < 1 || join(s, nx, ny, 1, 1, slant)) &&
           (diagonals < 2 || join(s, nx, ny, -1, 1, slant));
}

/* Builds a beam in the plane of x and y, as in the figure of the MPPhys
   paper, with gravity along -y. */
static const char *cantilever(struct scene *s, const double value[])
{
    const size_t nx = (size_t)value[C_NX], ny = (size_t)value[C_NY];
    const double dx = value[C_DX], dy = value[C_DY];
    if (!scene_create(s, nx * ny))
        return no_memory;
    lay_out(s, nx, ny, 0, 0, dx, dy);
    for (size_t i = 0; i < s->bodies; ++i) {
        s->mass[i] = value[C_MASS];
        s->freedom[2 * s->bodies + i] = 0;
        if (i % nx == 0)
            s->freedom[i] = s->freedom[s->bodies + i] = 0;
    }
    s->gravity[1] = -value[C_GRAVITY];
    s->damping = value[C_FRICTION];
    s->dt = 1e-3;
    return finish(s,
                  scene_add_kind(s, value[C_STIFFNESS], value[C_DAMPING]) &&
                      truss(s, nx, ny, dx, dy, (int)value[C_DIAGONALS]));
}

#define OF_A_BODY "of each body, kg"
#define OF_SPRINGS "of the springs, N/m"
#define OF_DASHPOTS "of the dashpots, kg/s"
#define OF_ALL "that all feel, kg/s"

const struct gallery_scene elastic_scenes[] = {
    {"oscillator",
     "a mass on a spring, with a dashpot",
     {{"mass", 1, 1e-9, 1e9, false, OF_A_BODY},
      {"stiffness", 1, 0, 1e12, false, OF_SPRINGS},
      {"damping", 0.2, 0, 1e9, false, OF_DASHPOTS},
      {"displacement", 1, -1e6, 1e6, false, "from the place of rest, m"},
      {"velocity", 0, -1e6, 1e6, false, "m/s"},
      {"length", 4, 1e-6, 1e6, false, "of the spring at rest, m"}},
     oscillator},
    {"double-pendulum",
     "a stiff spring, and on it a soft one",
     {{"stiffness1", 5000, 0, 1e12, false, "of the upper spring, N/m"},
      {"stiffness2", 5, 0, 1e12, false, "of the lower spring, N/m"},
      {"angle1", 0.6, -3.14, 3.14, false, "of the upper one, rad"},
      {"angle2", 0.6, -3.14, 3.14, false, "of the lower one, rad"},
      {"length", 1, 1e-6, 1e6, false, "of both, m"},
      {"mass1", 1, 1e-9, 1e9, false, "of the upper body, kg"},
      {"mass2", 1, 1e-9, 1e9, false, "of the lower body, kg"},
      {"gravity", 1.8, -1e6, 1e6, false, "downwards, m/s^2"},
      {"damping", 0, 0, 1e9, false, OF_DASHPOTS}},
     double_pendulum},
    {"membrane",
     "a grid of springs 2 m wide, its rim held",
     {{"nx", 8, 3, ELASTIC_SIDE, true, "bodies along x"},
      {"ny", 8, 3, ELASTIC_SIDE, true, "bodies along y"},
      {"mass", 1, 1e-9, 1e9, false, OF_A_BODY},
      {"stiffness", 50, 0, 1e12, false, OF_SPRINGS},
      {"damping", 0.003, 0, 1e9, false, OF_DASHPOTS},
      {"rest", 1, 0, 10, false, "rest length over distance; less: taut"},
      {"amplitude", 0.1, -1e3, 1e3, false, "of the mode at the start, m"},
      {"r", 1, 1, ELASTIC_SIDE, true, "half waves along x"},
      {"s", 1, 1, ELASTIC_SIDE, true, "half waves along y"},
      {"free", 1, 0, 1, true, "1: moves in the plane, too; 0: across it"},
      {"gravity", 0, -1e6, 1e6, false, "along -z, m/s^2"},
      {"friction", 0, 0, 1e9, false, OF_ALL}},
     membrane},
    {"cantilever",
     "a beam of springs, held at its left end",
     {{"nx", 6, 2, ELASTIC_SIDE, true, "bodies along x"},
      {"ny", 2, 2, ELASTIC_SIDE, true, "bodies along y"},
      {"dx", 1, 1e-6, 1e6, false, "between neighbours along x, m"},
      {"dy", 1, 1e-6, 1e6, false, "between neighbours along y, m"},
      {"mass", 1, 1e-9, 1e9, false, OF_A_BODY},
      {"stiffness", 1000, 0, 1e12, false, OF_SPRINGS},
      {"damping", 0, 0, 1e9, false, OF_DASHPOTS},
      {"diagonals", 2, 0, 2, true, "in each cell: 0, 1 or 2"},
      {"gravity", 1, -1e6, 1e6, false, "along -y, m/s^2"},
      {"friction", 0, 0, 1e9, false, OF_ALL}},
     cantilever},
    {0}};
