/* Scene player: reads a scene, runs it, changes it and saves it. */
#include "forces/motion.h"
#include "forces/observables.h"
#include "page/page.h"
#include "page/table.h"
#include "scenes/gallery.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The kinds of words. The argument of page_word is kind * 1000 + number. */
enum word { SCENES, ABOUT, KEYS, HELP, METHODS, NAMES, MESSAGE, WRITTEN };

/* The arrays that page_array returns. */
enum array { PLACES, RADII, COLOURS, MASSES, FREE, SPRINGS, OBSERVED };

/* The values that can be changed while the scene runs. */
enum change { METHOD, DT, GRAVITY, DAMPING = GRAVITY + 3, RESTITUTION, K2 };

char *page_text(double size);
bool page_observe(void);
bool page_change(double what, double value);
bool page_save(bool table, double every);

/* Parameters. page_begin reads the index of the method; page_make reads the
   values of a scene's keys. The player runs a scene as the program `step`
   does (forces/motion.h), but the reader of the page supplies the scene,
   and rows are drawn. Saved files are byte for byte those of `step`. */
double page_number[PAGE_NUMBERS];

static struct scene start, scene; /* initial and present scene */
static struct motion motion;
static bool moving;
static enum stepping_end stopped;
static struct observables observed;
static char *given, *written; /* text from the script; text for the
                                 script */
static char message[320];
static size_t line; /* line of an error in the text; 0: none */

/* Returns memory for a text of `size` bytes and frees the previous text.
   The script fills it before it calls the function that reads it. */
char *page_text(double size)
{
    free(given);
    given = calloc((size_t)size + 1, 1);
    return given;
}

/* Closes a table and keeps its text for the script. */
static bool finish(struct table *t)
{
    free(written);
    written = t ? page_table_close(t) : NULL;
    return written != NULL;
}

/* Returns scene `number` of the whole gallery, NULL after the last. */
static const struct gallery_scene *scene_of(size_t number)
{
    static const struct gallery_scene *const lists[] = {
        celestial_scenes, elastic_scenes, hard_scenes};
    for (size_t i = 0; i < sizeof lists / sizeof lists[0]; ++i)
        for (const struct gallery_scene *g = lists[i]; g->name; ++g)
            if (number-- == 0)
                return g;
    return NULL;
}

static const struct gallery_scene *chosen; /* the scene last named by
                                              page_word */

/* Returns key k of the chosen scene as five words: name, usual value, lower
   limit, upper limit, and 1 if it is a whole number. */
static const char *describe_key(size_t k)
{
    const struct gallery_key *key = chosen ? &chosen->key[k] : NULL;
    if (!key || !key->name)
        return NULL;
    snprintf(message, sizeof message, "%s %.17g %.17g %.17g %d", key->name,
             key->usual, key->low, key->high, key->whole);
    return message;
}

/* Returns the name of observable k, with numbers for the bodies it needs,
   such as :0:1. */
static const char *name_of(size_t k)
{
    size_t bodies;
    const char *name = observables_name(k, &bodies);
    snprintf(message, sizeof message, "%s%s", name ? name : "",
             bodies == 0   ? ""
             : bodies == 1 ? ":0"
                           : ":0:1");
    return name ? message : NULL;
}

/* Returns a word of one of the lists. The methods include those with steps
   of variable length, which the other figures leave out. */
const char *page_word(double number)
{
    const size_t k = (size_t)number % 1000;
    const struct gallery_scene *g;
    switch ((enum word)(number / 1000)) {
    case SCENES:
        g = scene_of(k);
        chosen = g ? g : chosen;
        return g ? g->name : NULL;
    case ABOUT: return scene_of(k) ? scene_of(k)->about : NULL;
    case KEYS: return describe_key(k);
    case HELP: return chosen ? chosen->key[k].help : NULL;
    case METHODS: return stepping_methods[k].name;
    case NAMES: return name_of(k);
    case MESSAGE: return message;
    case WRITTEN: return written;
    }
    return NULL;
}

/* Makes the text of scene `number` of the gallery, which the reader sees
   and may change before it runs. */
bool page_make(double number)
{
    const struct gallery_scene *g = scene_of((size_t)number);
    struct scene made;
    const char *wrong = g ? g->build(&made, page_number) : "no such scene";
    if (wrong) {
        snprintf(message, sizeof message, "%s", wrong);
        return false;
    }
    struct table *t = page_table_open("scene");
    if (t) {
        table_print(t, "# %s: %s\n", g->name, g->about);
        scene_write(&made, t);
    }
    scene_free(&made);
    return finish(t);
}

static void stop(void)
{
    if (moving)
        motion_end(&motion);
    moving = false;
}

/* Begins a motion as the program step does. */
static bool begin_motion(struct motion *m, struct scene *s)
{
    const char *method = stepping_methods[(size_t)page_number[0]].name;
    const bool begun = motion_begin(m, "page", s, method, 0);
    m->stepping.tolerance = 1e-13;
    return begun;
}

/* Begins a run of a copy of `start`, so that page_save can run the scene
   again from the first row. */
static bool begin_anew(void)
{
    stop();
    scene_free(&scene);
    stopped = STEPPING_DONE;
    if (!scene_copy(&scene, &start)) {
        snprintf(message, sizeof message, "no memory for the scene");
        return false;
    }
    moving = begin_motion(&motion, &scene);
    return moving;
}

/* Reads the scene from the given text and begins a run. If the text is
   wrong, stores the line of the error. If the scene cannot be stepped, the
   reason is printed on standard error, which the script reads. */
bool page_begin(void)
{
    struct scene_error e;
    struct scene read;
    stop();
    line = 0;
    message[0] = '\0';
    if (!given || !scene_parse(&read, given, strlen(given), &e)) {
        line = given ? e.line : 0;
        snprintf(message, sizeof message, "%s", given ? e.text : "no text");
        return false;
    }
    scene_free(&start);
    start = read;
    observed.count = observed.columns = 0;
    return begin_anew();
}

/* Runs the scene; an event is a step. */
double page_run(double until, double events)
{
    double steps = 0;
    while (moving && stopped == STEPPING_DONE && steps < events &&
           motion_time(&motion) + motion.stepping.dt <= until) {
        stopped = motion_run(&motion, 1);
        ++steps;
    }
    return steps;
}

static void set(struct scene *s, double *method, enum change what,
                double value)
{
    switch (what) {
    case METHOD: *method = value; break;
    case DT: s->dt = value; break;
    case DAMPING: s->damping = value; break;
    case RESTITUTION: s->restitution = value; break;
    case K2: s->k2 = value; break;
    default: s->gravity[what - GRAVITY] = value;
    }
}

/* Changes one value and begins a new run at the present state. A table
   saved later begins at this state. */
bool page_change(double what, double value)
{
    struct scene now;
    message[0] = '\0';
    if (!moving || !motion_note(&motion) || !scene_copy(&now, &scene))
        return false;
    set(&now, &page_number[0], (enum change)what, value);
    scene_free(&start);
    start = now;
    return begin_anew();
}

enum { HEAD = 29 };
static double seen[HEAD + 4 * OBSERVABLES_MOST];
static double *listed; /* for each spring its ends and its colour */

/* Returns the time; the numbers of steps, bodies and springs; how the last
   step ended (enum stepping_end, -1 without a scene); the number of
   collisions; the line with an error; dt, gravity, damping, restitution,
   k2, contact; walls and box, axis by axis; the number of observed values;
   whether contacts are instantaneous. The values of each body come from
   page_array. */
const double *page_look(void)
{
    const struct scene *s = &scene;
    const struct spheres *p = moving ? motion_contacts(&motion) : NULL;
    const double head[] = {moving ? motion_time(&motion) : 0,
                           moving ? (double)motion.stepping.steps : 0,
                           (double)s->bodies,
                           (double)s->springs,
                           moving ? (double)stopped : -1,
                           (double)motion.collisions,
                           (double)line,
                           s->dt,
                           s->gravity[0],
                           s->gravity[1],
                           s->gravity[2],
                           s->damping,
                           s->restitution,
                           s->k2,
                           s->contact};
    memcpy(seen, head, sizeof head);
    for (size_t k = 0; k < 3; ++k) {
        seen[15 + k] = s->wall[k];
        seen[18 + k] = s->low[k];
        seen[21 + k] = s->high[k];
    }
    seen[24] = (double)observed.columns;
    seen[25] = s->contact && s->law == SCENE_SUDDEN;
    seen[26] = p ? (double)p->passed : 0;
    seen[27] = p ? p->through[0] : 0;
    seen[28] = p ? p->through[1] : 0;
    return seen;
}

/* Chooses the observables by their names in the program step; an empty text
   means none. Their values are computed only when page_array is called for
   them, since the energy of many bodies costs as much as a step. */
bool page_observe(void)
{
    struct observables o = {0};
    message[0] = '\0';
    if (!given ||
        (*given && !observables_read(&o, given, scene.bodies, message)))
        return false;
    observed = o;
    return true;
}

static const double *list_springs(void)
{
    double *next = realloc(listed, (5 * scene.springs + 1) * sizeof *next);
    if (!next)
        return NULL;
    listed = next;
    for (size_t i = 0; i < scene.springs; ++i) {
        const struct scene_spring *s = &scene.spring[i];
        *next++ = s->a;
        *next++ = s->b;
        for (size_t k = 0; k < 3; ++k)
            *next++ = scene.kind[s->kind].colour[k];
    }
    return listed;
}

static const double *list_free(void)
{
    static double *free_ones;
    double *all = realloc(free_ones, (scene.bodies + 1) * sizeof *all);
    const unsigned char *f = scene.freedom;
    const size_t n = scene.bodies;
    if (!all)
        return NULL;
    free_ones = all;
    for (size_t i = 0; i < n; ++i)
        all[i] = f[i] || f[n + i] || f[2 * n + i];
    return all;
}

const double *page_array(double which)
{
    switch ((enum array)which) {
    case PLACES: return scene.position;
    case RADII: return scene.radius;
    case COLOURS: return scene.colour;
    case MASSES: return scene.mass;
    case FREE: return list_free();
    case SPRINGS: return list_springs();
    case OBSERVED:
        if (moving)
            observables_values(&observed, &motion, seen + HEAD);
        return seen + HEAD;
    }
    return NULL;
}

/* Runs the motion m again up to the present step. Writes a row every
   `every` steps: the observables or, if none are chosen, all states. The
   head contains the command of step that makes this table, which the script
   provides. */
static void write_rows(struct table *t, struct motion *m, uint64_t every,
                       double row[])
{
    const size_t n = observed.count > 0 ? 0 : m->scene->bodies;
    const size_t columns = 1 + observed.columns + 6 * n;
    const uint64_t last = motion.stepping.steps;
    table_begin(t, given, 0);
    table_column(t, "t", "time", "time, in the units of the scene");
    observables_head(&observed, t);
    observables_head_states(t, n, NULL);
    do {
        row[0] = motion_time(m);
        observables_values(&observed, m, row + 1);
        observables_states(m, n, NULL, row + 1 + observed.columns);
        table_row(t, columns, row);
    } while (m->stepping.steps + every <= last &&
             motion_run(m, every) == STEPPING_DONE);
}

static bool write_table(struct table *t, uint64_t every)
{
    struct scene s;
    struct motion m;
    const size_t room = 1 + 4 * OBSERVABLES_MOST + 6 * start.bodies;
    if (!scene_copy(&s, &start))
        return false;
    double *row = malloc(room * sizeof *row);
    const bool good = row && begin_motion(&m, &s);
    if (good) {
        write_rows(t, &m, every, row);
        motion_end(&m);
    }
    free(row);
    scene_free(&s);
    return good;
}

/* Writes a table of the run or, if `table` is false, the present scene,
   with all that the method needs for a bitwise identical continuation. */
bool page_save(bool table, double every)
{
    struct table *t = moving ? page_table_open("step") : NULL;
    if (!t)
        return false;
    if (table && !write_table(t, (uint64_t)every))
        table_print(t, "# no memory for the rows\n");
    if (!table && motion_note(&motion))
        scene_write(&scene, t);
    return finish(t);
}
