/* From chapters/11-step.nw: edit there, then run make tangle. */
/* checksum 3717306696 of the lines below */
#include "checkpoint.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

bool checkpoint_possible(const char *output)
{
    struct stat file;
    if (!output || strcmp(output, "-") == 0)
        return false;
    if (stat(output, &file) == 0)
        return S_ISREG(file.st_mode);
    return strncmp(output, "/dev/", 5) != 0 &&
           strncmp(output, "/proc/", 6) != 0;
}

/* Both strings together, to be freed, or NULL. */
static char *join(const char *a, const char *b)
{
    const size_t size = strlen(a) + strlen(b) + 1;
    char *both = malloc(size);
    if (both)
        snprintf(both, size, "%s%s", a, b);
    return both;
}

bool checkpoint_exists(const char *output)
{
    char *path = join(output, ".checkpoint");
    const bool there = path && access(path, F_OK) == 0;
    free(path);
    return there;
}

static bool complain(struct checkpoint *c, const char *path,
                     const char *reason)
{
    if (!c->failed)
        fprintf(stderr, "%s: %s: %s\n", c->program, path, reason);
    c->failed = true;
    return false;
}

static bool name_files(struct checkpoint *c, const char *program,
                       const char *command, const char *output)
{
    *c = (struct checkpoint){.program = program, .command = command};
    c->path = join(output, ".checkpoint");
    c->rows_path = join(output, ".rows");
    return c->path && c->rows_path ? true
                                   : complain(c, output, "no memory");
}

void checkpoint_end(struct checkpoint *c, bool keep)
{
    if (c->rows)
        fclose(c->rows);
    if (!keep && c->path && c->rows_path) {
        unlink(c->path); /* first: without it the rows are nothing */
        unlink(c->rows_path);
    }
    free(c->path);
    free(c->rows_path);
    *c = (struct checkpoint){0};
}

bool checkpoint_begin(struct checkpoint *c, const char *program,
                      const char *command, const char *output)
{
    if (name_files(c, program, command, output)) {
        unlink(c->path);
        c->rows = fopen(c->rows_path, "w+");
        if (c->rows)
            return true;
        complain(c, c->rows_path, strerror(errno));
    }
    checkpoint_end(c, true);
    return false;
}

bool checkpoint_row(struct checkpoint *c, size_t n, const double values[])
{
    for (size_t i = 0; i < n; ++i) {
        const char *format = i + 1 < n ? "%.17g " : "%.17g\n";
        if (isnan(values[i]))
            fputs(i + 1 < n ? "nan " : "nan\n", c->rows);
        else
            fprintf(c->rows, format, values[i]);
    }
    return !ferror(c->rows) || complain(c, c->rows_path, strerror(errno));
}

bool checkpoint_copy(struct checkpoint *c, struct table *t)
{
    static char piece[65536];
    size_t n;
    bool good = fflush(c->rows) == 0;
    rewind(c->rows);
    while (good && (n = fread(piece, 1, sizeof piece, c->rows)) > 0)
        good = table_print(t, "%.*s", (int)n, piece);
    return (good && !ferror(c->rows)) ||
           complain(c, c->rows_path, strerror(errno));
}

static const struct {
    const char *name;
    size_t offset;
} numbers[] = {
    {"start", offsetof(struct checkpoint_numbers, start)},
    {"steps", offsetof(struct checkpoint_numbers, steps)},
    {"collisions", offsetof(struct checkpoint_numbers, collisions)},
    {"evaluations", offsetof(struct checkpoint_numbers, evaluations)},
    {"rows", offsetof(struct checkpoint_numbers, rows)},
    {"energy", offsetof(struct checkpoint_numbers, energy)},
    {"depth", offsetof(struct checkpoint_numbers, depth)},
    {"worst", offsetof(struct checkpoint_numbers, worst)}};

enum { NUMBERS = sizeof numbers / sizeof numbers[0] };

static double *number(struct checkpoint_numbers *n, size_t k)
{
    return (double *)(void *)((char *)n + numbers[k].offset);
}

bool checkpoint_write(struct checkpoint *c, struct motion *m,
                      struct checkpoint_numbers n)
{
    if (fflush(c->rows) != 0)
        return complain(c, c->rows_path, strerror(errno));
    const long length = ftell(c->rows);
    struct table *t = table_open(c->program, c->path);
    if (!t)
        return false;
    table_print(t, "# a checkpoint, and a scene: --resume goes on\n");
    table_print(t, "#= command %s\n", c->command);
    table_print(t, "#= length %ld\n", length);
    for (size_t k = 0; k < NUMBERS; ++k)
        table_print(t, "#= %s %.17g\n", numbers[k].name, *number(&n, k));
    const struct stepping *s = &m->stepping;
    const size_t size = s->forces.damped && s->fresh ? s->forces.size : 0;
    for (size_t i = 0; i < size; ++i)
        table_print(t, "#= acceleration %.17g\n", s->acceleration[i]);
    table_print(t, "#= end\n");
    motion_note(m);
    scene_write(m->scene, t);
    return table_close(t);
}

struct head {
    char *line; /* of getline */
    size_t room;
    bool command, end;
    long length;
    size_t found, accelerations; /* numbers; coordinates */
    double *acceleration;
};

static bool add_acceleration(struct head *h, double value)
{
    const size_t n = h->accelerations;
    if ((n & (n - 1)) == 0) {
        double *more =
            realloc(h->acceleration, (n ? 2 * n : 1) * sizeof *more);
        if (!more)
            return false;
        h->acceleration = more;
    }
    h->acceleration[h->accelerations++] = value;
    return true;
}

/* What follows "#= KEY " in this line, or NULL if it is not that key. */
static const char *after(const char *line, const char *key)
{
    const size_t n = strlen(key);
    return strncmp(line, key, n) == 0 && line[n] == ' ' ? line + n + 1
                                                        : NULL;
}

static bool take_line(struct checkpoint *c, struct head *h,
                      struct checkpoint_numbers *n, const char *line)
{
    const char *value = after(line, "command");
    if (value)
        return h->command = strcmp(value, c->command) == 0;
    if ((value = after(line, "length")))
        return (h->length = strtol(value, NULL, 10)) >= 0;
    if ((value = after(line, "acceleration")))
        return add_acceleration(h, strtod(value, NULL));
    for (size_t k = 0; k < NUMBERS; ++k)
        if ((value = after(line, numbers[k].name))) {
            *number(n, k) = strtod(value, NULL);
            ++h->found;
            return true;
        }
    return h->end = strcmp(line, "end") == 0;
}

static bool read_head(struct checkpoint *c, struct head *h,
                      struct checkpoint_numbers *n)
{
    FILE *file = fopen(c->path, "r");
    bool good = file != NULL;
    ssize_t length;
    while (good && !h->end &&
           (length = getline(&h->line, &h->room, file)) > 0) {
        if (h->line[length - 1] == '\n')
            h->line[length - 1] = '\0';
        if (strncmp(h->line, "#= ", 3) == 0)
            good = take_line(c, h, n, h->line + 3);
    }
    if (file)
        fclose(file);
    if (good && h->end && h->command && h->found == NUMBERS)
        return true;
    return complain(c, c->path,
                    !file ? strerror(errno)
                    : good || h->command
                        ? "no checkpoint, or a damaged one"
                        : "is of another command; without --resume the run "
                          "begins anew");
}

static bool open_rows(struct checkpoint *c, long length)
{
    struct stat file;
    c->rows = fopen(c->rows_path, "r+");
    if (!c->rows || fstat(fileno(c->rows), &file) != 0)
        return complain(c, c->rows_path, strerror(errno));
    if (file.st_size < length)
        return complain(c, c->rows_path,
                        "has fewer rows than the checkpoint says");
    if (ftruncate(fileno(c->rows), length) != 0 ||
        fseek(c->rows, 0, SEEK_END) != 0)
        return complain(c, c->rows_path, strerror(errno));
    return true;
}

bool checkpoint_resume(struct checkpoint *c, const char *program,
                       const char *command, const char *output,
                       struct scene *s, struct checkpoint_numbers *n,
                       double **acceleration)
{
    struct head h = {0};
    bool good = name_files(c, program, command, output) &&
                read_head(c, &h, n) && open_rows(c, h.length) &&
                scene_read(s, program, c->path);
    if (good && h.acceleration && h.accelerations != 3 * s->bodies) {
        scene_free(s);
        good = complain(c, c->path, "no checkpoint, or a damaged one");
    }
    free(h.line);
    *acceleration = good ? h.acceleration : NULL;
    if (good)
        return true;
    free(h.acceleration);
    checkpoint_end(c, true);
    return false;
}
