/* Reads a scene in four passes, and writes it without loss of digits. */
#include "scenes/scene.h"

#include "scenes/decimal.h"
#include "toolbox/aligned.h"

#include <assert.h>
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool scene_create(struct scene *s, size_t bodies)
{
    const size_t axes = SCENE_AXES;
    *s = (struct scene){.bodies = bodies, .restitution = 1};
    s->mass = calloc(bodies, sizeof *s->mass);
    s->charge = calloc(bodies, sizeof *s->charge);
    s->radius = calloc(bodies, sizeof *s->radius);
    s->position = aligned_doubles(axes * bodies);
    s->velocity = aligned_doubles(axes * bodies);
    s->freedom = calloc(bodies, axes);
    s->colour = calloc(bodies, axes * sizeof *s->colour);
    s->species = calloc(bodies, sizeof *s->species);
    if (!s->mass || !s->charge || !s->radius || !s->position ||
        !s->velocity || !s->freedom || !s->colour || !s->species) {
        scene_free(s);
        return false;
    }
    memset(s->freedom, 1, axes * bodies);
    for (size_t i = 0; i < bodies; ++i)
        s->mass[i] = 1;
    return true;
}

void scene_free(struct scene *s)
{
    free(s->mass);
    free(s->charge);
    free(s->radius);
    free(s->position);
    free(s->velocity);
    free(s->freedom);
    free(s->colour);
    free(s->species);
    free(s->carry);
    free(s->kept);
    free(s->kind);
    free(s->spring);
    *s = (struct scene){0};
}

/* Returns a copy of a list, or NULL if memory runs out. The capacity of the
   copy is a power of two, as make_room expects. */
static void *copy_list(const void *list, size_t count, size_t size)
{
    size_t room = 1;
    while (room < count)
        room *= 2;
    void *copy = malloc(room * size);
    if (copy && count > 0)
        memcpy(copy, list, count * size);
    return copy;
}

/* Copies the lists that may be NULL. Returns false if memory runs out. */
static bool copy_rare(struct scene *to, const struct scene *from)
{
    const size_t n = from->bodies, size = sizeof(double);
    if (from->carry)
        to->carry = copy_list(from->carry, 6 * n, size);
    if (from->kept)
        to->kept = copy_list(from->kept, 3 * n, size);
    return !to->carry == !from->carry && !to->kept == !from->kept;
}

bool scene_copy(struct scene *to, const struct scene *from)
{
    const size_t n = from->bodies;
    struct scene c = *from;
    c.mass = copy_list(from->mass, n, sizeof *c.mass);
    c.charge = copy_list(from->charge, n, sizeof *c.charge);
    c.radius = copy_list(from->radius, n, sizeof *c.radius);
    c.position = copy_list(from->position, 3 * n, sizeof *c.position);
    c.velocity = copy_list(from->velocity, 3 * n, sizeof *c.velocity);
    c.freedom = copy_list(from->freedom, 3 * n, 1);
    c.colour = copy_list(from->colour, 3 * n, sizeof *c.colour);
    c.species = copy_list(from->species, n, sizeof *c.species);
    c.kind = copy_list(from->kind, from->kinds, sizeof *c.kind);
    c.spring = copy_list(from->spring, from->springs, sizeof *c.spring);
    const bool rare = copy_rare(&c, from);
    *to = c;
    if (c.mass && c.charge && c.radius && c.position && c.velocity &&
        c.freedom && c.colour && c.species && c.kind && c.spring && rare)
        return true;
    scene_free(to);
    return false;
}

void scene_take_state(struct scene *s, const struct scene *from)
{
    const size_t size = SCENE_AXES * s->bodies * sizeof *s->position;
    memcpy(s->position, from->position, size);
    memcpy(s->velocity, from->velocity, size);
}

/* Returns the list with room for one more item, or NULL if memory runs out.
   The capacity is always a power of two and need not be stored: a list is
   full if count is 0 or a power of two, that is, if count & (count - 1) is
   0. Doubling the capacity moves an item less than twice on average. */
static void *make_room(void *list, size_t count, size_t size)
{
    if ((count & (count - 1)) != 0)
        return list;
    return realloc(list, (count > 0 ? 2 * count : 1) * size);
}

bool scene_add_kind(struct scene *s, double stiffness, double damping)
{
    struct scene_kind *kind = make_room(s->kind, s->kinds, sizeof *s->kind);
    if (!kind)
        return false;
    s->kind = kind;
    kind[s->kinds++] =
        (struct scene_kind){.stiffness = stiffness, .damping = damping};
    return true;
}

static double distance(const struct scene *s, size_t a, size_t b)
{
    double sum = 0;
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        const double *x = s->position + k * s->bodies;
        sum += (x[b] - x[a]) * (x[b] - x[a]);
    }
    return sqrt(sum);
}

bool scene_add_spring(struct scene *s, size_t a, size_t b, size_t kind,
                      double rest)
{
    assert(a < s->bodies && b < s->bodies && kind < s->kinds);
    struct scene_spring *spring =
        make_room(s->spring, s->springs, sizeof *s->spring);
    if (!spring)
        return false;
    s->spring = spring;
    spring[s->springs++] =
        (struct scene_spring){(uint32_t)a, (uint32_t)b, (uint32_t)kind,
                              rest < 0 ? distance(s, a, b) : rest};
    return true;
}

struct piece {
    const char *start;
    size_t length;
};

/* The types of lines; those that describe a body come first. */
enum { POS, VEL, VFIX, DIS, SPECIES, CARRY, KEPT };
enum { S = KEPT + 1, SL, DASHPOT };
enum { GRAV = DASHPOT + 1, DAMP, K2, SOFT, DT, TIME };
enum { CONTACT = TIME + 1, RESTITUTION, LINEAR, HERTZ, BOX, WALLS, LINES };

enum { MOST_FIELDS = 10 };

struct reader {
    struct scene *scene;
    struct scene_error *error;
    const char *next, *end; /* the rest of the line */
    size_t line;            /* number of the line */
    struct piece first,     /* first word of the line */
        word[MOST_FIELDS];  /* the other words of the line */
    size_t lines[LINES],    /* number of lines of each type in the text */
        read[LINES];        /* number of lines of each type read so far */
    unsigned char *seen;    /* [bodies + kinds] bit t is set if a line of
                               type t was read for the body or kind */
};

/* Returns whether c separates words. Files from Windows contain \r. */
static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

/* Returns the next word of the line, of length 0 at the end of the line. */
static struct piece next_word(struct reader *r)
{
    while (r->next < r->end && is_blank(*r->next))
        ++r->next;
    const char *start = r->next;
    while (r->next < r->end && !is_blank(*r->next))
        ++r->next;
    return (struct piece){start, (size_t)(r->next - start)};
}

/* Copies the beginning of a word for a message, with ? in place of
   characters that cannot be printed. */
static void quote(struct piece p, char text[], size_t size)
{
    const size_t most = 40;
    if (p.length == 0) {
        snprintf(text, size, "the end of the line");
        return;
    }
    const int length = (int)(p.length < most ? p.length : most);
    snprintf(text, size, "'%.*s%s'", length, p.start,
             p.length > most ? "..." : "");
    for (char *c = text; *c; ++c)
        if (*c < ' ' || *c > '~')
            *c = '?';
}

/* Fills the error with what was found and what was expected, formatted as
   by printf. Returns false. */
static bool fail(struct reader *r, struct piece found, const char *format,
                 ...)
{
    char word[64];
    va_list values;
    quote(found, word, sizeof word);
    r->error->line = r->line;
    char *text = r->error->text;
    const size_t size = sizeof r->error->text;
    const int n = snprintf(text, size, "found %s, expected ", word);
    va_start(values, format);
    vsnprintf(text + n, size - (size_t)n, format, values);
    va_end(values);
    return false;
}

/* Describes one type of line in a scene file. `fields` names the values on
   the line. A mark before a name gives its type: @ a body, & a kind of
   spring, # a whole number, + not negative, > more than 0, % from 0 to 1,
   ! 0 or 1, | the type of a wall, = the word axial. Values after a ; are
   optional. */
struct line {
    const char *word, *fields;
    int pass; /* number of the pass over the text that reads such lines */
    /* Stores the values. If this pointer is NULL, the values are copied to
       the member of the scene at `offset`. If `list` is true, that member
       is a pointer to a list, and the values are stored in it as
       coordinates of a body. */
    bool (*store)(struct reader *r, const double value[], size_t count);
    size_t offset;
    bool list;
};

struct field {
    char mark; /* 0: none */
    const char *name;
    int length;
    bool optional;
};

/* Removes the next field from *fields and returns it. */
static struct field next_field(const char **fields)
{
    const char *c = *fields;
    struct field f = {.optional = *c == ';'};
    c += f.optional;
    if (strchr("@&#+>%!|=", *c))
        f.mark = *c++;
    f.name = c;
    f.length = (int)strcspn(c, " ");
    c += f.length;
    *fields = *c ? c + 1 : c;
    return f;
}

/* Reads a whole number of at most 32 bits, without a sign or a point. */
static bool read_whole(struct piece p, double *value)
{
    *value = 0;
    for (size_t i = 0; i < p.length; ++i) {
        const int digit = p.start[i] - '0';
        if (digit < 0 || digit > 9 || i >= 10)
            return false;
        *value = 10 * *value + digit;
    }
    return p.length > 0 && *value <= UINT32_MAX;
}

static bool is_word(struct piece p, const char *word)
{
    return strlen(word) == p.length && memcmp(word, p.start, p.length) == 0;
}

static bool read_choice(struct piece p, const char *const names[],
                        double *value)
{
    for (size_t i = 0; names[i]; ++i)
        if (is_word(p, names[i])) {
            *value = (double)i;
            return true;
        }
    return false;
}

static const char *const wall_names[] = {"open", "hard", "periodic", NULL};
static const char *const axial_names[] = {"axial", NULL};

/* Converts a word to a value of the type given by `mark`. Returns false if
   the word has another type. */
static bool read_value(const struct reader *r, char mark, struct piece p,
                       double *value)
{
    switch (mark) {
    case '@': return read_whole(p, value) && *value < r->lines[POS];
    case '&': return read_whole(p, value) && *value < r->lines[S];
    case '#': return read_whole(p, value);
    case '|': return read_choice(p, wall_names, value);
    case '=': return read_choice(p, axial_names, value);
    }
    return decimal_read(p.start, p.length, value) != DECIMAL_NONE &&
           (mark == '+'   ? *value >= 0
            : mark == '>' ? *value > 0
            : mark == '%' ? *value >= 0 && *value <= 1
            : mark == '!' ? *value == 0 || *value == 1
                          : true);
}

/* Returns a description of the values that a mark allows, for messages. */
static const char *describe(char mark)
{
    switch (mark) {
    case '#': return "a whole number";
    case '+': return "a number not below 0";
    case '>': return "a number above 0";
    case '%': return "a number from 0 to 1";
    case '!': return "0 (fixed) or 1 (free)";
    case '|': return "open, hard or periodic";
    case '=': return "axial";
    }
    return "a number";
}

/* Writes an error that states the allowed values of the field. For a body
   or a kind of spring, states the range of its numbers. Returns false. */
static bool refuse_value(struct reader *r, const struct field *f,
                         struct piece p)
{
    const bool body = f->mark == '@';
    const char *word = body ? "pos" : "s";
    const size_t n = r->lines[body ? POS : S];
    if (!body && f->mark != '&')
        return fail(r, p, "%.*s: %s", f->length, f->name,
                    describe(f->mark));
    if (n == 0)
        return fail(r, p, "%.*s, but there is no line %s", f->length,
                    f->name, word);
    return fail(r, p, "%.*s: 0 to %zu (lines %s: %zu)", f->length, f->name,
                n - 1, word, n);
}

/* Reads the values in the rest of a line, one for each of `fields`, into
   value[], and sets *count to their number. */
static bool read_fields(struct reader *r, const char *fields,
                        double value[], size_t *count)
{
    for (*count = 0; *fields; ++*count) {
        const struct field f = next_field(&fields);
        const struct piece p = next_word(r);
        r->word[*count] = p;
        if (p.length == 0 && f.optional)
            return true;
        if (!read_value(r, f.mark, p, &value[*count]))
            return refuse_value(r, &f, p);
    }
    const struct piece rest = next_word(r);
    return rest.length == 0 || fail(r, rest, "the end of the line");
}

/* Fills the error with a message that quotes no word. Returns false. */
static bool fail_text(struct reader *r, const char *what)
{
    r->error->line = r->line;
    snprintf(r->error->text, sizeof r->error->text, "%s", what);
    return false;
}

/* Stores value[1], value[2], ... as coordinates of body value[0]. If the
   list does not exist yet, allocates it and fills it with zeros: most
   scenes have no `carry` or `kept`. */
static bool store_axes(double **to, struct reader *r, const double value[],
                       size_t count)
{
    const size_t n = r->scene->bodies, i = (size_t)value[0];
    if (!*to)
        *to = calloc(n, (count - 1) * sizeof **to);
    if (!*to)
        return fail_text(r, "no memory for the scene");
    for (size_t k = 0; k + 1 < count; ++k)
        (*to)[k * n + i] = value[k + 1];
    return true;
}

static bool store_pos(struct reader *r, const double value[], size_t count)
{
    const size_t i = (size_t)value[0];
    store_axes(&r->scene->position, r, value, 4);
    r->scene->mass[i] = value[4];
    r->scene->charge[i] = value[5];
    r->scene->radius[i] = value[6];
    const double colour[] = {value[0], value[7], value[8], value[9]};
    if (count == 10)
        store_axes(&r->scene->colour, r, colour, 4);
    return true;
}

static bool store_vfix(struct reader *r, const double value[], size_t count)
{
    const size_t n = r->scene->bodies, i = (size_t)value[0];
    for (size_t k = 0; k + 1 < count; ++k)
        r->scene->freedom[k * n + i] = value[k + 1] == 1;
    return true;
}

/* Stores the species of a body. Its meaning depends on the program. */
static bool store_species(struct reader *r, const double value[],
                          size_t count)
{
    (void)count;
    r->scene->species[(size_t)value[0]] = (uint32_t)value[1];
    return true;
}

/* Adds a displacement to a position. Refuses an infinite sum. */
static bool store_dis(struct reader *r, const double value[], size_t count)
{
    const size_t n = r->scene->bodies, i = (size_t)value[0];
    for (size_t k = 0; k + 1 < count; ++k) {
        double *x = &r->scene->position[k * n + i];
        *x += value[k + 1];
        if (!isfinite(*x))
            return fail(r, r->word[k + 1],
                        "a place that is not beyond all numbers");
    }
    return true;
}

/* Stores the acceleration with which a body continues. If there is one line
   "kept", there must be one for each body: a body without it would feel no
   force for half a step. check_once refuses a second line for a body. */
static bool store_kept(struct reader *r, const double value[], size_t count)
{
    const size_t bodies = r->scene->bodies, lines = r->lines[KEPT];
    if (lines < bodies)
        return fail(r, r->first,
                    "one for each of the %zu bodies, or none (lines kept: "
                    "%zu)",
                    bodies, lines);
    return store_axes(&r->scene->kept, r, value, count);
}

static bool store_kind(struct reader *r, const double value[], size_t count)
{
    struct scene_kind *kind = &r->scene->kind[(size_t)value[0]];
    kind->stiffness = value[1];
    kind->damping = value[2];
    if (count == 6)
        memcpy(kind->colour, value + 3, sizeof kind->colour);
    return true;
}

/* Adds a spring, unless the square of its length would overflow. */
static bool store_spring(struct reader *r, const double value[],
                         size_t count)
{
    struct scene *s = r->scene;
    if (value[0] == value[1])
        return fail(r, r->word[1], "another body than the first");
    if (!scene_add_spring(s, (size_t)value[0], (size_t)value[1],
                          (size_t)value[2], count == 4 ? value[3] : -1))
        return fail_text(r, "no memory for the scene");
    return isfinite(s->spring[s->springs - 1].rest) ||
           fail(r, r->word[1], "a body not so far from the first");
}

static bool store_box(struct reader *r, const double value[], size_t count)
{
    struct scene *s = r->scene;
    for (size_t k = 0; 2 * k < count; ++k) {
        s->low[k] = value[2 * k];
        s->high[k] = value[2 * k + 1];
        if (s->low[k] > s->high[k])
            return fail(r, r->word[2 * k + 1],
                        "the high end of the axis not below the low one");
    }
    return true;
}

/* Stores the types of walls. A box may be flat, but an axis with walls must
   have a length. The box was read in an earlier pass. */
static bool store_walls(struct reader *r, const double value[],
                        size_t count)
{
    struct scene *s = r->scene;
    for (size_t k = 0; k < count; ++k) {
        s->wall[k] = (enum scene_wall)value[k];
        if (s->wall[k] != SCENE_OPEN && !(s->low[k] < s->high[k]))
            return fail(r, r->word[k],
                        "open, as no line box gives the axis a length");
    }
    return true;
}

static bool store_contact(struct reader *r, const double value[],
                          size_t count)
{
    (void)value, (void)count;
    return r->scene->contact = true;
}

static bool store_dashpot(struct reader *r, const double value[],
                          size_t count)
{
    (void)value, (void)count;
    return r->scene->axial = true;
}

/* Stores a law of soft contacts. The scene then needs no "contact" line. */
static bool store_law(struct reader *r, const double value[], size_t count)
{
    const bool hertz = is_word(r->first, "hertz");
    r->scene->law = hertz ? SCENE_HERTZ : SCENE_LINEAR;
    r->scene->stiffness = value[0];
    r->scene->dashpot = count > 1 ? value[1] : 0;
    return r->scene->contact = true;
}

#define TO(field) NULL, offsetof(struct scene, field), false
#define AXES(list) NULL, offsetof(struct scene, list), true
#define BY(function) function, 0, false
static const struct line forms[LINES] = {
    [POS] = {"pos", "@body x y z +mass charge +radius ;%red %green %blue",
             1, BY(store_pos)},
    [VEL] = {"vel", "@body vx vy vz", 1, AXES(velocity)},
    [VFIX] = {"vfix", "@body !x !y !z", 1, BY(store_vfix)},
    [DIS] = {"dis", "@body dx dy dz", 3, BY(store_dis)},
    [SPECIES] = {"species", "@body #species", 1, BY(store_species)},
    [CARRY] = {"carry", "@body x y z vx vy vz", 1, AXES(carry)},
    [KEPT] = {"kept", "@body ax ay az", 1, BY(store_kept)},
    [S] = {"s", "&kind +D +c ;%red %green %blue", 1, BY(store_kind)},
    [SL] = {"sl", "@body @body &kind ;+rest", 2, BY(store_spring)},
    [DASHPOT] = {"dashpot", "=way", 1, BY(store_dashpot)},
    [GRAV] = {"grav", "gx gy gz", 1, TO(gravity)},
    [DAMP] = {"damp", "+damping", 1, TO(damping)},
    [K2] = {"k2", "+k2", 1, TO(k2)},
    [SOFT] = {"soft", "+softening", 1, TO(softening)},
    [DT] = {"dt", ">step", 1, TO(dt)},
    [TIME] = {"time", "time", 1, TO(time)},
    [CONTACT] = {"contact", "", 1, BY(store_contact)},
    [RESTITUTION] = {"restitution", "%restitution", 1, TO(restitution)},
    [LINEAR] = {"linear", ">stiffness ;+dashpot", 1, BY(store_law)},
    [HERTZ] = {"hertz", ">stiffness", 1, BY(store_law)},
    [BOX] = {"box", "xlow xhigh ylow yhigh zlow zhigh", 1, BY(store_box)},
    [WALLS] = {"walls", "|x |y |z", 2, BY(store_walls)}};

/* Returns the type of line that begins with this word, or LINES if
   none. */
static size_t find_form(struct piece p)
{
    size_t i = 0;
    while (i < LINES && !is_word(p, forms[i].word))
        ++i;
    return i;
}

/* Fills the error with the words that may begin a line. Returns false. */
static bool refuse_word(struct reader *r)
{
    char list[160] = "";
    for (size_t i = 0; i < LINES; ++i) {
        const size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%s",
                 i == 0           ? ""
                 : i + 1 == LINES ? " or "
                                  : ", ",
                 forms[i].word);
    }
    return fail(r, r->first, "%s", list);
}

_Static_assert(S < 8, "a byte of `seen` has a bit for each sort");

/* Refuses a repeated line of a type that is allowed only once in the scene,
   or only once for each body or kind. This also ensures that no body is
   missing: n lines "pos" must have n different numbers below n. The same
   holds for kinds. */
static bool check_once(struct reader *r, size_t sort, const double value[])
{
    if (sort > S)
        return sort == SL || r->read[sort] == 0 ||
               fail(r, r->first, "it once only");
    const size_t i = (size_t)value[0] + (sort == S ? r->scene->bodies : 0);
    const unsigned char bit = (unsigned char)(1 << sort);
    if (r->seen[i] & bit)
        return fail(r, r->word[0], "one without a line %s so far",
                    forms[sort].word);
    r->seen[i] |= bit;
    return true;
}

static bool read_values(struct reader *r, size_t sort)
{
    const struct line *form = &forms[sort];
    double value[MOST_FIELDS] = {0};
    size_t count;
    if (!read_fields(r, form->fields, value, &count) ||
        !check_once(r, sort, value))
        return false;
    ++r->read[sort];
    if (form->store)
        return form->store(r, value, count);
    void *member = (char *)r->scene + form->offset;
    if (form->list)
        return store_axes(member, r, value, count);
    memcpy(member, value, count * sizeof value[0]);
    return true;
}

/* Reads a line if this pass reads lines of its type; pass 0 only
   counts. */
static bool read_line(struct reader *r, const char *start, const char *stop,
                      int pass)
{
    const char *comment = memchr(start, '#', (size_t)(stop - start));
    r->next = start;
    r->end = comment ? comment : stop;
    r->first = next_word(r);
    if (r->first.length == 0)
        return true;
    const size_t sort = find_form(r->first);
    if (sort == LINES)
        return refuse_word(r);
    r->lines[sort] += pass == 0;
    return forms[sort].pass != pass || read_values(r, sort);
}

/* Reads the lines of one pass. Lines may come in any order, but some need
   others to be read first: a velocity needs its body, a spring its kind and
   the positions of its two bodies, walls the box, and a displacement all
   springs. So pass 0 counts the lines, pass 2 reads sl and walls, pass 3
   reads dis, and pass 1 reads all others. */
static bool read_pass(struct reader *r, const char *text, size_t length,
                      int pass)
{
    const char *c = text, *end = text + length;
    for (r->line = 1; c < end; ++r->line) {
        const char *stop = memchr(c, '\n', (size_t)(end - c));
        stop = stop ? stop : end;
        if (!read_line(r, c, stop, pass))
            return false;
        c = stop < end ? stop + 1 : end;
    }
    return true;
}

/* Allocates the scene's lists, for as many items as pass 0 has counted. */
static bool prepare(struct reader *r)
{
    struct scene *s = r->scene;
    const size_t bodies = r->lines[POS], kinds = r->lines[S];
    if (bodies == 0)
        return fail_text(r,
                         "found no line pos, expected one for each body");
    if (bodies > UINT32_MAX || !scene_create(s, bodies))
        return fail_text(r, "no memory for the scene");
    for (size_t i = 0; i < kinds; ++i)
        if (!scene_add_kind(s, 0, 0))
            return fail_text(r, "no memory for the scene");
    r->seen = calloc(bodies + kinds, 1);
    return r->seen || fail_text(r, "no memory for the scene");
}

bool scene_parse(struct scene *s, const char *text, size_t length,
                 struct scene_error *e)
{
    struct reader r = {.scene = s, .error = e};
    *s = (struct scene){0};
    bool good = read_pass(&r, text, length, 0) && prepare(&r);
    for (int pass = 1; good && pass <= 3; ++pass)
        good = read_pass(&r, text, length, pass);
    free(r.seen);
    if (!good)
        scene_free(s);
    return good;
}

/* Returns the whole content of a stream, which the caller frees, or NULL
   with errno set. The buffer grows as needed, since a pipe has no size. */
static char *read_all(FILE *stream, size_t *length)
{
    size_t room = 1 << 16;
    char *text = malloc(room), *more;
    for (*length = 0; text; text = more) {
        *length += fread(text + *length, 1, room - *length, stream);
        if (*length < room) {
            if (!ferror(stream))
                return text;
            break;
        }
        room *= 2;
        more = realloc(text, room);
        if (!more)
            break;
    }
    free(text);
    return NULL;
}

/* Returns the text of a file or of standard input, or NULL with errno set.
   errno is saved, since fclose may change it. */
static char *load(const char *path, size_t *length)
{
    if (strcmp(path, "-") == 0)
        return read_all(stdin, length);
    FILE *stream = fopen(path, "r");
    if (!stream)
        return NULL;
    char *text = read_all(stream, length);
    const int error = errno;
    fclose(stream);
    errno = error;
    return text;
}

bool scene_read(struct scene *s, const char *program, const char *path)
{
    struct scene_error e;
    size_t length;
    char *text = load(path, &length);
    const char *name = strcmp(path, "-") == 0 ? "standard input" : path;
    if (!text) {
        fprintf(stderr, "%s: cannot read the scene %s: %s\n", program, name,
                strerror(errno));
        return false;
    }
    const bool good = scene_parse(s, text, length, &e);
    free(text);
    if (!good)
        fprintf(stderr, "%s: %s:%zu: %s\n", program, name, e.line, e.text);
    return good;
}

/* Returns whether the `count` numbers of a body are all +0, so that their
   line can be omitted. A number -0 is written, or it would become +0. */
static bool is_nothing(const double *x, size_t bodies, size_t i,
                       size_t count)
{
    for (size_t k = 0; k < count; ++k)
        if (x[k * bodies + i] != 0 || signbit(x[k * bodies + i]))
            return false;
    return true;
}

static void write_body(struct table *out, const char *word, const double *x,
                       size_t bodies, size_t i, size_t count)
{
    table_print(out, "%s %zu", word, i);
    for (size_t k = 0; k < count; ++k)
        table_print(out, " %.17g", x[k * bodies + i]);
    table_print(out, "\n");
}

static void write_places(const struct scene *s, struct table *out)
{
    const size_t n = s->bodies;
    const double *x = s->position, *c = s->colour;
    table_print(out, "# pos body x y z mass charge radius colour\n");
    for (size_t i = 0; i < n; ++i)
        table_print(out,
                    "pos %zu %.17g %.17g %.17g %.17g %.17g %.17g "
                    "%.17g %.17g %.17g\n",
                    i, x[i], x[n + i], x[2 * n + i], s->mass[i],
                    s->charge[i], s->radius[i], c[i], c[n + i],
                    c[2 * n + i]);
}

/* Writes the remainders of compensated sums, and the accelerations with
   which a damped leapfrog continues. A line "carry" is written for the
   first body even if its numbers are 0, so that the reader knows that the
   scene has remainders. A line "kept" is written for every body, even if
   its numbers are 0. */
static void write_carried(const struct scene *s, struct table *out)
{
    const size_t n = s->bodies;
    for (size_t i = 0; i < n && s->carry; ++i)
        if (i == 0 || !is_nothing(s->carry, n, i, 6))
            write_body(out, "carry", s->carry, n, i, 6);
    for (size_t i = 0; i < n && s->kept; ++i)
        write_body(out, "kept", s->kept, n, i, SCENE_AXES);
}

static void write_motion(const struct scene *s, struct table *out)
{
    const size_t n = s->bodies;
    for (size_t i = 0; i < n; ++i)
        if (!is_nothing(s->velocity, n, i, SCENE_AXES))
            write_body(out, "vel", s->velocity, n, i, SCENE_AXES);
    for (size_t i = 0; i < n; ++i) {
        const unsigned char *f = s->freedom + i;
        if (!f[0] || !f[n] || !f[2 * n])
            table_print(out, "vfix %zu %d %d %d\n", i, f[0] != 0, f[n] != 0,
                        f[2 * n] != 0);
    }
    for (size_t i = 0; i < n; ++i)
        if (s->species[i] != 0)
            table_print(out, "species %zu %" PRIu32 "\n", i, s->species[i]);
    write_carried(s, out);
}

static void write_springs(const struct scene *s, struct table *out)
{
    if (s->kinds > 0)
        table_print(out, "# s kind D c colour; sl body body kind rest\n");
    for (size_t i = 0; i < s->kinds; ++i) {
        const struct scene_kind *k = &s->kind[i];
        table_print(out, "s %zu %.17g %.17g %.17g %.17g %.17g\n", i,
                    k->stiffness, k->damping, k->colour[0], k->colour[1],
                    k->colour[2]);
    }
    for (size_t i = 0; i < s->springs; ++i) {
        const struct scene_spring *l = &s->spring[i];
        table_print(out, "sl %" PRIu32 " %" PRIu32 " %" PRIu32 " %.17g\n",
                    l->a, l->b, l->kind, l->rest);
    }
    if (s->axial)
        table_print(out, "dashpot axial\n");
}

/* Writes a line of numbers, unless they are all +0. */
static void write_numbers(struct table *out, const char *word,
                          const double *x, size_t count)
{
    if (is_nothing(x, 1, 0, count))
        return;
    table_print(out, "%s", word);
    for (size_t k = 0; k < count; ++k)
        table_print(out, " %.17g", x[k]);
    table_print(out, "\n");
}

static void write_box(const struct scene *s, struct table *out)
{
    double box[2 * SCENE_AXES];
    for (size_t k = 0; k < SCENE_AXES; ++k) {
        box[2 * k] = s->low[k];
        box[2 * k + 1] = s->high[k];
    }
    write_numbers(out, "box", box, 2 * SCENE_AXES);
    if (s->wall[0] || s->wall[1] || s->wall[2])
        table_print(out, "walls %s %s %s\n", wall_names[s->wall[0]],
                    wall_names[s->wall[1]], wall_names[s->wall[2]]);
    if (s->contact)
        table_print(out, "contact\n");
    if (s->restitution != 1)
        table_print(out, "restitution %.17g\n", s->restitution);
    if (s->law == SCENE_LINEAR)
        table_print(out, "linear %.17g %.17g\n", s->stiffness, s->dashpot);
    if (s->law == SCENE_HERTZ)
        table_print(out, "hertz %.17g\n", s->stiffness);
}

void scene_write(const struct scene *s, struct table *out)
{
    write_places(s, out);
    write_motion(s, out);
    write_springs(s, out);
    write_numbers(out, "grav", s->gravity, SCENE_AXES);
    write_numbers(out, "damp", &s->damping, 1);
    write_numbers(out, "k2", &s->k2, 1);
    write_numbers(out, "soft", &s->softening, 1);
    write_box(s, out);
    write_numbers(out, "dt", &s->dt, 1);
    write_numbers(out, "time", &s->time, 1);
}
