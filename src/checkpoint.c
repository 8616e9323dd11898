/* From chapters/11-step.nw: edit there, then run make tangle. */
/* checksum 3384183398 of the lines below */
#include "checkpoint.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

bool checkpoint_possible(const char *output)
{
    struct stat file;
    if (!output || strcmp(output, "-") == 0 ||
        strncmp(output, "/proc/", 6) == 0)
        return false;
    if (strncmp(output, "/dev/", 5) == 0 &&
        strncmp(output, "/dev/shm/", 9) != 0)
        return false;
    return stat(output, &file) != 0 || S_ISREG(file.st_mode);
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

static bool lose(struct checkpoint *c)
{
    c->lost = true;
    return complain(c, c->rows_path, strerror(errno));
}

#define NO_ROWS UINT64_C(14695981039346656037)

/* Adds a text to the sum of what stood before it. */
static uint64_t add_up(uint64_t sum, const char *text, size_t n)
{
    for (size_t i = 0; i < n; ++i)
        sum = (sum ^ (unsigned char)text[i]) * UINT64_C(1099511628211);
    return sum;
}

double checkpoint_sum(const char *path)
{
    static char piece[65536];
    uint64_t sum = NO_ROWS;
    struct stat status;
    const bool regular =
        stat(path, &status) == 0 && S_ISREG(status.st_mode);
    FILE *file = regular ? fopen(path, "r") : NULL;
    if (!file)
        return 0;
    for (size_t n; (n = fread(piece, 1, sizeof piece, file)) > 0;)
        sum = add_up(sum, piece, n);
    fclose(file);
    return (double)(sum >> 11);
}

static bool name_files(struct checkpoint *c, const char *program,
                       const char *command, const char *output)
{
    *c = (struct checkpoint){
        .program = program, .command = command, .sum = NO_ROWS};
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
        char text[32] = "nan ";
        if (!isnan(values[i]))
            snprintf(text, sizeof text, "%.17g ", values[i]);
        const size_t length = strlen(text);
        text[length - 1] = i + 1 < n ? ' ' : '\n';
        fputs(text, c->rows);
        c->sum = add_up(c->sum, text, length);
    }
    return !ferror(c->rows) || lose(c);
}

/* Sees to it that the file has all rows, and stands at its end. */
static bool flush_rows(struct checkpoint *c)
{
    if (c->lost || fflush(c->rows) != 0 || fseek(c->rows, 0, SEEK_END) != 0)
        return lose(c);
    return true;
}

bool checkpoint_copy(struct checkpoint *c, struct table *t)
{
    static char piece[65536];
    size_t n;
    bool good = flush_rows(c);
    rewind(c->rows);
    while (good && (n = fread(piece, 1, sizeof piece, c->rows)) > 0)
        good = table_print(t, "%.*s", (int)n, piece);
    return (good && !ferror(c->rows)) ||
           complain(c, c->rows_path, strerror(errno));
}

#define PLACE(field) #field, offsetof(struct checkpoint_numbers, field)
static const struct {
    const char *name;
    size_t offset;
    bool count; /* whole, and not below zero */
} numbers[] = {{PLACE(start), false},     {PLACE(steps), true},
               {PLACE(collisions), true}, {PLACE(evaluations), true},
               {PLACE(rows), true},       {PLACE(energy), false},
               {PLACE(depth), false},     {PLACE(worst), false},
               {PLACE(last), false},      {PLACE(scene), true}};

enum { NUMBERS = sizeof numbers / sizeof numbers[0] };

static double *number(struct checkpoint_numbers *n, size_t k)
{
    return (double *)(void *)((char *)n + numbers[k].offset);
}

bool checkpoint_write(struct checkpoint *c, struct motion *m,
                      struct checkpoint_numbers n)
{
    if (!flush_rows(c))
        return false;
    if (!motion_note(m))
        return complain(c, c->path, "no memory");
    const long length = ftell(c->rows);
    struct table *t = table_open(c->program, c->path);
    if (!t)
        return false;
    table_print(t, "# a checkpoint, and a scene: --resume goes on\n");
    table_print(t, "#= command %s\n", c->command);
    table_print(t, "#= length %ld\n", length);
    table_print(t, "#= sum %" PRIu64 "\n", c->sum);
    for (size_t k = 0; k < NUMBERS; ++k)
        table_print(t, "#= %s %.17g\n", numbers[k].name, *number(&n, k));
    scene_write(m->scene, t);
    table_print(t, "#= end\n");
    return table_close(t);
}

enum { COUNTS = 2 }; /* besides the numbers */

struct head {
    char *line;         /* of getline */
    size_t room, found; /* numbers and counts */
    bool command, end;
    uint64_t length, sum; /* of the rows */
};

/* What follows "#= KEY " in this line, or NULL if it is not that key. */
static const char *after(const char *line, const char *key)
{
    const size_t n = strlen(key);
    return strncmp(line, key, n) == 0 && line[n] == ' ' ? line + n + 1
                                                        : NULL;
}

static bool take_count(struct head *h, const char *value, uint64_t *count)
{
    char *end;
    *count = strtoull(value, &end, 10);
    ++h->found;
    return *value >= '0' && *value <= '9' && *end == '\0';
}

static bool take_number(const char *value, bool count, double *number)
{
    char *end;
    *number = strtod(value, &end);
    return end != value && *end == '\0' && isfinite(*number) &&
           (!count || (*number >= 0 && *number < 0x1p53 &&
                       *number == floor(*number)));
}

static bool take_line(struct checkpoint *c, struct head *h,
                      struct checkpoint_numbers *n, const char *line)
{
    const char *value = after(line, "command");
    if (value)
        return h->command = strcmp(value, c->command) == 0;
    if ((value = after(line, "length")))
        return take_count(h, value, &h->length);
    if ((value = after(line, "sum")))
        return take_count(h, value, &h->sum);
    for (size_t k = 0; k < NUMBERS; ++k)
        if ((value = after(line, numbers[k].name))) {
            ++h->found;
            return take_number(value, numbers[k].count, number(n, k));
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
    if (good && h->end && h->command && h->found == NUMBERS + COUNTS)
        return true;
    return complain(c, c->path,
                    !file ? strerror(errno)
                    : good || h->command
                        ? "no checkpoint, or a damaged one"
                        : "is of another command; without --resume the run "
                          "begins anew");
}

/* Reads so many bytes of the rows into the sum; returns how many. */
static uint64_t read_rows(struct checkpoint *c, uint64_t length)
{
    static char piece[65536];
    uint64_t done = 0;
    size_t n = 1;
    while (n > 0 && done < length) {
        const uint64_t left = length - done;
        n = fread(piece, 1, left < sizeof piece ? left : sizeof piece,
                  c->rows);
        c->sum = add_up(c->sum, piece, n);
        done += n;
    }
    return done;
}

static bool open_rows(struct checkpoint *c, const struct head *h)
{
    c->rows = fopen(c->rows_path, "r+");
    if (!c->rows)
        return complain(c, c->rows_path, strerror(errno));
    if (read_rows(c, h->length) < h->length)
        return complain(c, c->rows_path,
                        "has fewer rows than the checkpoint says");
    if (c->sum != h->sum)
        return complain(c, c->rows_path,
                        "has other rows than the checkpoint says");
    if (ftruncate(fileno(c->rows), (off_t)h->length) != 0 ||
        fseek(c->rows, 0, SEEK_END) != 0)
        return complain(c, c->rows_path, strerror(errno));
    return true;
}

bool checkpoint_resume(struct checkpoint *c, const char *program,
                       const char *command, const char *output,
                       struct scene *s, struct checkpoint_numbers *n)
{
    struct head h = {0};
    const bool good = name_files(c, program, command, output) &&
                      read_head(c, &h, n) && open_rows(c, &h) &&
                      scene_read(s, program, c->path);
    free(h.line);
    if (!good)
        checkpoint_end(c, true);
    return good;
}
