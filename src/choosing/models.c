/* Holds the table of models, parses plans, and runs models row by row. */
#include "choosing/models_parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The price list, measured on a server with a fourth-generation AMD EPYC
   processor (vectors of eight numbers), with gcc 12 and the default flags
   of the makefile.

   No unit of work occurs alone. So `bonk-studies --study prices` runs a
   scene with much of one unit and little of the others, subtracts the cost
   of the others according to the list, and divides by the number of units.
   After a few rounds of this the prices converge. Then the prices, and the
   weights of body updates, examined pairs and springs, were fitted to the
   costs of more than two hundred scenes, each computed by all suitable
   models.

   Predicted costs are rarely wrong by more than a factor of 1.5. Costs do
   not add up exactly: operations that overlap in the processor cost less,
   and the memory addresses chosen by the linker matter.

   A nanosecond is about three cycles. The gravity of a single pair takes
   more than thirty cycles for a root and a division, but its price is only
   twenty cycles, because several pairs overlap. Collisions of two disks
   cannot overlap. */
const struct models_price models_prices[MODELS_UNITS] = {
    [MODELS_EVALUATION] = {"evaluation", "call of the forces", 18},
    [MODELS_BODY] = {"body", "body in a call of the forces", 3},
    [MODELS_PAIR] = {"pair", "pull between bodies", 6.5},
    [MODELS_SPRING] = {"spring", "force of a spring", 1.2},
    [MODELS_ROD] = {"rod", "correction of a rod", 15},
    [MODELS_CONTACT] = {"contact", "body looked at for contacts", 75},
    [MODELS_OVERLAP] = {"overlap", "pair looked at for a contact", 16},
    [MODELS_CURVE] = {"curve", "product for the curve of a gap", 4.9},
    [MODELS_ROOT] = {"root", "the same, if the curve has a root", 40},
    [MODELS_LINE_EVENT] = {"line-event", "collision on a line", 33},
    [MODELS_LINE_SCAN] = {"line-scan", "gap looked at for it", 0.3},
    [MODELS_DISK_EVENT] = {"disk-event", "collision of disks", 100},
    [MODELS_DISK_SCAN] = {"disk-scan", "disk looked at for it", 4.5},
    [MODELS_RENEWAL] = {"renewal", "list of a disk's neighbours", 450},
    [MODELS_ELLIPSE] = {"ellipse", "body moved along its ellipse", 210},
    [MODELS_FLIGHT] = {"flight", "coordinate moved freely", 3.6},
    [MODELS_ORDER] = {"order", "comparison of two bodies", 2.7},
    [MODELS_MODE] = {"mode", "operation on modes", 0.5},
    [MODELS_ROW] = {"row", "row of a run", 40}};

double models_cost(const double work[MODELS_UNITS])
{
    double sum = 0;
    for (size_t k = 0; k < MODELS_UNITS; ++k)
        sum += work[k] * models_prices[k].ns;
    return sum / 1e9;
}

const char models_no_memory[] = "there is no memory";

/* Why a scene is refused, in the order of the BEARS_ bits. Only the first
   reason that applies is shown, so the most useful come first. */
enum { ACTS = 6 };
static const char *const unsupported[ACTS] = {
    "it knows no rods", "it does not ask who pulls",
    "springs act",      "the bodies attract each other",
    "bodies may meet",  "there is friction"};

/* Returns NULL if the model can compute the scene, or why it cannot: an
   interaction that it does not support, or the result of its `refuses`. */
static const char *refusal(const struct models_run *r)
{
    const struct models_model *m = r->plan.model;
    const struct models_acts *a = &r->acts;
    const unsigned cuts = a->cuts;
    const bool acts[ACTS] = {cuts & MODELS_RODS, cuts & MODELS_NO_LIGHT,
                             a->springs,         a->gravity,
                             a->contact,         a->friction};
    for (unsigned k = 0; k < ACTS; ++k)
        if (acts[k] && !(m->bears >> k & 1))
            return unsupported[k];
    return m->refuses ? m->refuses(&r->scene, a) : NULL;
}

bool models_is_costly(const struct models_run *r)
{
    return models_cost(r->work) > r->limit;
}

void models_count_sorting(struct models_run *r, size_t n, double times)
{
    double bits = 1;
    for (size_t m = n; m > 2; m = (m + 1) / 2)
        ++bits;
    r->work[MODELS_ORDER] += times * (double)n * bits;
}

/* The models without time steps, roughly by cost: formulas, then
   event-driven models. The stepping methods follow them in the table. To
   add a model without steps, define its row next to its functions and add a
   line here. */
static const struct models_model *const stepless[] = {
    &models_free,  &models_kepler, &models_oscillator, &models_relabel,
    &models_modes, &models_line,   &models_disks};

enum { STEPLESS = sizeof stepless / sizeof *stepless };

const struct models_model *models_all(void)
{
    static struct models_model all[STEPLESS + STEPPING_MOST + 1];
    if (all->name)
        return all;
    size_t n = STEPLESS;
    for (const struct stepping_method *m = stepping_methods; m->name; ++m)
        all[n++] = models_of_method(m);
    for (size_t k = STEPLESS; k-- > 0;)
        all[k] = *stepless[k];
    return all;
}

const struct models_model *models_find(const char *name)
{
    for (const struct models_model *m = models_all(); m->name; ++m)
        if (strcmp(m->name, name) == 0)
            return m;
    return NULL;
}

void models_write(const struct models_plan *p, char text[MODELS_TEXT])
{
    size_t used = (size_t)snprintf(text, MODELS_TEXT, "%s", p->model->name);
    if (p->tolerance > 0)
        used += (size_t)snprintf(text + used, MODELS_TEXT - used, ":%g",
                                 p->tolerance);
    else if (p->steps > 0 && !p->model->method->adaptive)
        used += (size_t)snprintf(text + used, MODELS_TEXT - used, ":%llu",
                                 (unsigned long long)p->steps);
    for (size_t k = 0; k < MODELS_CUTS; ++k)
        if (p->cuts >> k & 1)
            used += (size_t)snprintf(text + used, MODELS_TEXT - used, ",%s",
                                     models_cut_names[k]);
}

/* Returns the name of the k-th simplification (if `cuts`) or model (if
   not), or NULL after the last. */
static const char *name_of(size_t k, bool cuts)
{
    return cuts ? models_cut_names[k] : models_all()[k].name;
}

/* Writes an error with the word found (at most 40 characters) and what was
   expected. If `what` is NULL, any name from a list was expected: of a
   simplification (if `cuts`) or of a model (if not). Returns false. */
static bool complain(char message[MODELS_MESSAGE], const char *word,
                     const char *what, bool cuts)
{
    int used =
        snprintf(message, MODELS_MESSAGE, "found '%.40s', expected %s",
                 word, what ? what : "one of ");
    for (size_t k = 0; !what && name_of(k, cuts); ++k)
        used += snprintf(message + used, MODELS_MESSAGE - (size_t)used,
                         "%s%s", k ? ", " : "", name_of(k, cuts));
    return false;
}

/* Parses the number after the colon of a plan. Returns NULL, or what was
   expected there. */
static const char *read_number(struct models_plan *p, const char *text)
{
    char *end;
    const double x = strtod(text, &end);
    const bool read = end != text && !*end;
    if (p->model->family != MODELS_STEPS)
        return "no steps with this model";
    p->steps = 1;
    p->tolerance = x;
    if (p->model->method->adaptive)
        return read && x >= 1e-16 && x <= 1
                   ? NULL
                   : "a tolerance of its own steps from 1e-16 to 1";
    p->tolerance = 0;
    if (!read || text[strspn(text, "0123456789")] || *text == '0' ||
        x > 1e12)
        return "a whole number of steps from 1 to 10^12";
    p->steps = (uint64_t)x;
    return NULL;
}

/* Ends a word at its first `mark`. Returns the text after the mark, or NULL
   if the word contains no mark. */
static char *end_word(char *word, char mark)
{
    char *const at = strchr(word, mark);
    if (at)
        *at = '\0';
    return at ? at + 1 : NULL;
}

bool models_read(struct models_plan *p, const char *text,
                 char message[MODELS_MESSAGE])
{
    char words[MODELS_TEXT], *next;
    *p = (struct models_plan){0};
    if (strlen(text) >= sizeof words)
        return complain(message, text, NULL, false);
    strcpy(words, text);
    next = end_word(words, ',');
    const char *const number = end_word(words, ':');
    if (!(p->model = models_find(words)))
        return complain(message, words, NULL, false);
    const char *const expected = number ? read_number(p, number) : NULL;
    if (expected)
        return complain(message, number, expected, false);
    for (char *word = next; word; word = next) {
        size_t k = 0;
        next = end_word(word, ',');
        while (k < MODELS_CUTS && strcmp(word, models_cut_names[k]) != 0)
            ++k;
        if (k == MODELS_CUTS)
            return complain(message, word, NULL, true);
        p->cuts |= 1u << k;
    }
    return true;
}

/* Copies the scene into the run and applies the simplifications of the
   plan. Sets velocities along fixed coordinates to 0. Returns NULL, or why
   the plan cannot compute the scene. */
static const char *copy_scene(struct models_run *r, const struct scene *s)
{
    struct scene *own = &r->scene;
    if (!scene_copy(own, s))
        return models_no_memory;
    for (size_t c = 0; c < 3 * s->bodies; ++c)
        if (!s->freedom[c])
            own->velocity[c] = 0;
    models_leave_out(own, r->plan.cuts);
    models_analyse(&r->acts, own);
    r->acts.cuts = r->plan.cuts;
    return refusal(r);
}

const char *models_refuse(const struct models_plan *p,
                          const struct scene *s)
{
    struct models_run r = {.plan = *p};
    const char *why = copy_scene(&r, s);
    scene_free(&r.scene);
    return why;
}

bool models_begin(struct models_run *r, const struct models_plan *p,
                  const struct scene *s, double every, const char **why)
{
    *r = (struct models_run){
        .plan = *p, .start = s->time, .every = every, .limit = INFINITY};
    *why = !(every > 0) ? "rows must be apart"
           : p->model->family == MODELS_STEPS && p->steps == 0
               ? "it needs a number of steps"
               : copy_scene(r, s);
    if (!*why) {
        r->engine = calloc(1, p->model->engine);
        if (!r->engine || !scene_copy(&r->origin, &r->scene))
            *why = models_no_memory;
        else if (p->model->begin)
            *why = p->model->begin(r);
    }
    if (*why) { /* models_end clears the run, so save its work */
        double work[MODELS_UNITS];
        memcpy(work, r->work, sizeof work);
        models_end(r);
        memcpy(r->work, work, sizeof work);
    }
    return !*why;
}

/* The time of a row is computed as a product, since adding up intervals
   would accumulate rounding errors. */
enum models_end models_row(struct models_run *r)
{
    r->elapsed = (double)(r->rows + 1) * r->every;
    const enum models_end end = r->plan.model->row(r);
    if (end != MODELS_DONE)
        return end;
    ++r->rows;
    ++r->work[MODELS_ROW];
    r->scene.time = r->start + r->elapsed;
    return models_is_costly(r) ? MODELS_COSTLY : MODELS_DONE;
}

uint64_t models_collisions(struct models_run *r)
{
    if (r->plan.model->count)
        r->plan.model->count(r);
    return r->collisions;
}

void models_end(struct models_run *r)
{
    if (r->engine && r->plan.model->end)
        r->plan.model->end(r);
    free(r->engine);
    scene_free(&r->origin);
    scene_free(&r->scene);
    *r = (struct models_run){0};
}
