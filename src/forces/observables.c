/* Reads a list of observables, and computes their columns. */
#include "forces/observables.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void time_now(const struct motion *m, const size_t body[],
                     double out[])
{
    (void)body;
    out[0] = motion_time(m);
}

static void parts(const struct motion *m, const size_t body[], double out[])
{
    (void)body;
    const struct motion_energy e = motion_energy(m);
    out[0] = e.kinetic;
    out[1] = e.gravity;
    out[2] = e.springs;
    out[3] = e.weight;
}

static void kinetic(const struct motion *m, const size_t body[],
                    double out[])
{
    (void)body;
    out[0] = motion_kinetic(m);
}

static void potential(const struct motion *m, const size_t body[],
                      double out[])
{
    (void)body;
    out[0] = motion_potential(m);
}

static void energy(const struct motion *m, const size_t body[],
                   double out[])
{
    (void)body;
    const struct motion_energy e = motion_energy(m);
    out[0] = e.kinetic + (e.gravity + e.springs + e.weight);
}

static void momentum(const struct motion *m, const size_t body[],
                     double out[])
{
    (void)body;
    const struct scene *s = m->scene;
    for (size_t k = 0; k < 3; ++k) {
        out[k] = 0;
        for (size_t i = 0; i < s->bodies; ++i)
            out[k] += s->mass[i] * s->velocity[k * s->bodies + i];
    }
}

static void centre(const struct motion *m, const size_t body[],
                   double out[])
{
    (void)body;
    const struct scene *s = m->scene;
    double mass = 0;
    out[0] = out[1] = out[2] = 0;
    for (size_t i = 0; i < s->bodies; ++i) {
        mass += s->mass[i];
        for (size_t k = 0; k < 3; ++k)
            out[k] += s->mass[i] * s->position[k * s->bodies + i];
    }
    for (size_t k = 0; k < 3; ++k)
        out[k] /= mass;
}

/* Component k of the cross product of x and v uses the two axes that follow
   k in the cyclic order x, y, z, x. */
static void angular_momentum(const struct motion *m, const size_t body[],
                             double out[])
{
    (void)body;
    const struct scene *s = m->scene;
    const size_t n = s->bodies;
    const double *x = s->position, *v = s->velocity;
    for (size_t k = 0; k < 3; ++k) {
        const size_t p = (k + 1) % 3 * n, q = (k + 2) % 3 * n;
        out[k] = 0;
        for (size_t i = 0; i < n; ++i)
            out[k] +=
                s->mass[i] * (x[p + i] * v[q + i] - x[q + i] * v[p + i]);
    }
}

/* Returns whether the momentum along axis k is conserved: there is no wall,
   uniform gravity, friction or fixed body along this axis. */
static bool keeps_momentum(const struct scene *s, size_t k)
{
    bool free =
        s->wall[k] != SCENE_HARD && s->gravity[k] == 0 && s->damping == 0;
    for (size_t i = 0; i < s->bodies; ++i)
        free = free && s->freedom[k * s->bodies + i];
    return free;
}

/* Returns the kinetic energy of the motion along axis k. If the momentum is
   conserved, uses the velocities relative to the centre of mass. The
   momentum is summed relative to body 0, so that equal velocities give an
   energy of exactly 0. */
static double heat_along(const struct scene *s, size_t k)
{
    const double *v = s->velocity + k * s->bodies;
    double mass = 0, sum = 0, energy = 0;
    for (size_t i = 0; i < s->bodies; ++i) {
        mass += s->mass[i];
        sum += s->mass[i] * (v[i] - v[0]);
    }
    const double drift =
        mass > 0 && keeps_momentum(s, k) ? v[0] + sum / mass : 0;
    for (size_t i = 0; i < s->bodies; ++i)
        energy += s->mass[i] * (v[i] - drift) * (v[i] - drift) / 2;
    return energy;
}

/* Computes kT from equipartition: the mean kinetic energy of each free
   coordinate is kT/2, also with springs.

   Along axes with conserved momentum only the motion relative to the centre
   of mass counts. The energy is still divided by the number of all free
   coordinates, so a scene without drift keeps its kT. In a periodic box
   with N bodies, which have only N - 1 relative velocities along each axis,
   kT should therefore be larger by the factor N/(N - 1).

   A drift is ignored if its energy is less than the rounding error of the
   sum. */
static void temperature(const struct motion *m, const size_t body[],
                        double out[])
{
    (void)body;
    const struct scene *s = m->scene;
    const size_t free = 3 * s->bodies - m->fixed;
    const double all = motion_kinetic(m);
    const double heat =
        heat_along(s, 0) + heat_along(s, 1) + heat_along(s, 2);
    const double rounding = DBL_EPSILON * (double)free * all;
    out[0] = 2 * (all - heat > rounding ? heat : all) / (double)free;
}

static void collisions(const struct motion *m, const size_t body[],
                       double out[])
{
    (void)body;
    out[0] = (double)m->collisions;
}

static void speed(const struct motion *m, const size_t body[], double out[])
{
    const double *v = m->scene->velocity + body[0];
    const size_t n = m->scene->bodies;
    out[0] = sqrt(v[0] * v[0] + v[n] * v[n] + v[2 * n] * v[2 * n]);
}

static void distance(const struct motion *m, const size_t body[],
                     double out[])
{
    const double *x = m->scene->position;
    double sum = 0;
    for (size_t k = 0; k < 3; ++k) {
        const size_t axis = k * m->scene->bodies;
        const double d = x[axis + body[1]] - x[axis + body[0]];
        sum += d * d;
    }
    out[0] = sqrt(sum);
}

/* A kind of observable. To add one, add a row to kinds, and a function that
   computes its columns. */
struct observables_kind {
    const char *name;
    size_t bodies, width; /* numbers of arguments (bodies) and of columns */
    const char *symbols, *unit, *meaning; /* symbols: one for each column,
                                             separated by spaces */
    void (*values)(const struct motion *m, const size_t body[],
                   double out[]); /* NULL: component() is used */
};

#define ENERGY "mass length^2/time^2"
#define SPEED "length/time"

static const struct observables_kind kinds[] = {
    {"t", 0, 1, "t", "time", "time", time_now},
    {"energy", 0, 1, "E", ENERGY, "energy", energy},
    {"kinetic", 0, 1, "K", ENERGY, "kinetic energy", kinetic},
    {"potential", 0, 1, "U", ENERGY, "potential energy", potential},
    {"parts", 0, 4, "K U_gravity U_springs U_weight", ENERGY,
     "part of the energy", parts},
    {"momentum", 0, 3, "px py pz", "mass " SPEED, "momentum", momentum},
    {"angular-momentum", 0, 3, "Lx Ly Lz", "mass length^2/time",
     "angular momentum about the origin", angular_momentum},
    {"centre", 0, 3, "X Y Z", "length", "centre of mass", centre},
    {"temperature", 0, 1, "kT", ENERGY,
     "2 K/free coordinates, relative to a drift", temperature},
    {"collisions", 0, 1, "n", "", "collisions so far", collisions},
    {"x", 1, 1, "x", "length", "coordinate of a body", NULL},
    {"y", 1, 1, "y", "length", "coordinate of a body", NULL},
    {"z", 1, 1, "z", "length", "coordinate of a body", NULL},
    {"vx", 1, 1, "vx", SPEED, "velocity of a body", NULL},
    {"vy", 1, 1, "vy", SPEED, "velocity of a body", NULL},
    {"vz", 1, 1, "vz", SPEED, "velocity of a body", NULL},
    {"speed", 1, 1, "v", SPEED, "speed of a body", speed},
    {"distance", 2, 1, "d", "length", "distance of two bodies", distance}};

enum { KINDS = sizeof kinds / sizeof kinds[0] };

static const struct observables_kind *find_kind(const char *name, size_t n)
{
    for (size_t k = 0; k < KINDS; ++k)
        if (strlen(kinds[k].name) == n && !strncmp(kinds[k].name, name, n))
            return &kinds[k];
    return NULL;
}

/* Reads a colon and the number of a body. Returns the end of the number, or
   NULL if there is no such body. */
static const char *read_body(const char *text, size_t bodies, size_t *body)
{
    char *end;
    if (text[0] != ':' || text[1] < '0' || text[1] > '9')
        return NULL;
    const unsigned long long number = strtoull(text + 1, &end, 10);
    *body = (size_t)number;
    return number < bodies ? end : NULL;
}

/* Reads a name and its bodies, up to the comma or the end of the text, and
   returns that position. On failure writes the expected form into message
   and returns NULL. */
static const char *read_one(struct observable *o, const char *text,
                            size_t bodies,
                            char message[OBSERVABLES_MESSAGE])
{
    const int width = (int)strcspn(text, ",");
    const size_t name = strcspn(text, ":,");
    const char *at = text + name;
    o->kind = find_kind(text, name);
    for (size_t k = 0; o->kind && at && k < o->kind->bodies; ++k)
        at = read_body(at, bodies, &o->body[k]);
    if (o->kind && at == text + width)
        return at;
    snprintf(message, OBSERVABLES_MESSAGE,
             o->kind == NULL ? "'%.*s' is no observable: energy, parts, "
                               "momentum, centre, z:30 and others are"
             : o->kind->bodies == 0
                 ? "'%.*s': %s is asked of no body"
                 : "'%.*s': %s needs %zu of the bodies 0 to %zu, as in "
                   "%s:0%s",
             width > 40 ? 40 : width, text, o->kind ? o->kind->name : "",
             o->kind ? o->kind->bodies : 0, bodies - 1,
             o->kind ? o->kind->name : "",
             o->kind && o->kind->bodies == 2 ? ":1" : "");
    return NULL;
}

bool observables_read(struct observables *o, const char *text,
                      size_t bodies, char message[OBSERVABLES_MESSAGE])
{
    *o = (struct observables){0};
    for (;; ++text) {
        if (o->count == OBSERVABLES_MOST) {
            snprintf(message, OBSERVABLES_MESSAGE,
                     "more than %d observables", OBSERVABLES_MOST);
            return false;
        }
        struct observable *next = &o->list[o->count++];
        text = read_one(next, text, bodies, message);
        if (!text)
            return false;
        o->columns += next->kind->width;
        if (*text == '\0')
            return true;
    }
}

/* Writes the symbol of column k, followed by the numbers of its bodies, as
   in z:30. `make inspect` labels the axes of its plots with this symbol. */
static void symbol_of(const struct observable *o, size_t k, char *symbol,
                      size_t size)
{
    const char *name = o->kind->symbols;
    for (; k > 0; --k)
        name = strchr(name, ' ') + 1;
    int length =
        snprintf(symbol, size, "%.*s", (int)strcspn(name, " "), name);
    for (size_t i = 0; i < o->kind->bodies; ++i)
        length += snprintf(symbol + length, size - (size_t)length, ":%zu",
                           o->body[i]);
}

void observables_head(const struct observables *o, struct table *t)
{
    char symbol[64];
    for (size_t i = 0; i < o->count; ++i)
        for (size_t k = 0; k < o->list[i].kind->width; ++k) {
            symbol_of(&o->list[i], k, symbol, sizeof symbol);
            table_column(t, symbol, o->list[i].kind->unit,
                         o->list[i].kind->meaning);
        }
}

struct observables_sort observables_sort(const struct observable *o)
{
    const struct observables_kind *k = o->kind;
    const size_t axis = (size_t)(k->name[0] - 'x');
    return (struct observables_sort){
        k->width, k->name[1] == '\0' && axis < 3 ? axis : 3, k->unit};
}

/* Returns the coordinate or velocity of a body with the name x, y, z, vx,
   vy or vz. */
static double component(const struct scene *s, const struct observable *o)
{
    const bool moves = o->kind->name[0] == 'v';
    const size_t axis = (size_t)(o->kind->name[moves] - 'x');
    const double *x = moves ? s->velocity : s->position;
    return x[axis * s->bodies + o->body[0]];
}

void observables_values(const struct observables *o, const struct motion *m,
                        double values[])
{
    for (size_t i = 0; i < o->count; ++i) {
        const struct observable *one = &o->list[i];
        if (one->kind->values)
            one->kind->values(m, one->body, values);
        else
            values[0] = component(m->scene, one);
        values += one->kind->width;
    }
}

void observables_head_states(struct table *t, size_t n, const size_t body[])
{
    static const char *const symbol[] = {"x", "y", "z", "vx", "vy", "vz"};
    char name[32];
    for (size_t j = 0; j < n; ++j)
        for (size_t k = 0; k < 6; ++k) {
            snprintf(name, sizeof name, "%s:%zu", symbol[k],
                     body ? body[j] : j);
            table_column(t, name, k < 3 ? "length" : "length/time",
                         k < 3 ? "place" : "velocity");
        }
}

void observables_states(const struct motion *m, size_t n,
                        const size_t body[], double values[])
{
    const struct scene *s = m->scene;
    for (size_t j = 0; j < n; ++j, values += 6)
        for (size_t k = 0; k < 3; ++k) {
            const size_t c = k * s->bodies + (body ? body[j] : j);
            values[k] = s->position[c];
            values[3 + k] = s->velocity[c];
        }
}

const char *observables_name(size_t k, size_t *bodies)
{
    *bodies = k < KINDS ? kinds[k].bodies : 0;
    return k < KINDS ? kinds[k].name : NULL;
}
