/* States of disks written to tables and read again. */
#include "box/states.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const states_boundaries[] = {"walls", "periodic", "floor",
                                         NULL};

static void name_axes(struct table *out, size_t dimensions,
                      const char *format, const char *unit,
                      const char *meaning)
{
    for (size_t k = 0; k < dimensions; ++k) {
        char symbol[16];
        snprintf(symbol, sizeof symbol, format, "xyz"[k]);
        table_column(out, symbol, unit, meaning);
    }
}

void states_begin(struct table *out, const struct disks *d)
{
    table_print(out, "# box");
    for (size_t k = 0; k < d->dimensions; ++k)
        table_print(out, " %.17g", d->box[k]);
    table_print(out, " %s\n", states_boundaries[d->boundary]);
    table_column(out, "t", "s", "time");
    table_column(out, "disk", "", "its number");
    table_column(out, "mass", "kg", "its mass");
    table_column(out, "radius", "m", "its radius");
    name_axes(out, d->dimensions, "%c", "m", "place, in the box");
    name_axes(out, d->dimensions, "v%c", "m/s", "velocity");
    name_axes(out, d->dimensions, "%c0", "m", "at its last collision");
    table_column(out, "t0", "s", "time of its last collision");
}

/* Writes the present position, folded back into a periodic box. The
   position at the last collision is not folded, since a run that is
   continued must know how often a disk has crossed the box. It is written
   with all digits: from a rounded position a continued run would differ
   after some two dozen collisions of each disk. */
void states_write(struct table *out, const struct disks *d)
{
    const size_t D = d->dimensions;
    for (size_t i = 0; i < d->count; ++i) {
        const struct disk *a = &d->disk[i];
        const bool falls = d->gravity > 0;
        double place[DISKS_AXES], velocity[DISKS_AXES],
            row[14] = {d->now, (double)(i + 1), d->mass[i], a->radius};
        disks_position(d, i, place);
        disks_velocity(d, i, velocity);
        disks_fold(d, place);
        memcpy(row + 4, place, D * sizeof row[0]);
        memcpy(row + 4 + D, velocity, D * sizeof row[0]);
        memcpy(row + 4 + 2 * D, falls ? place : a->position,
               D * sizeof row[0]);
        row[4 + 3 * D] = falls ? d->now : a->since;
        table_row(out, 5 + 3 * D, row);
    }
}
/* The contents of a file of states, as read so far. */
struct file {
    const char *path;
    char *message;
    size_t line, rows, space, columns, axes;
    double (*row)[14];
    double box[DISKS_AXES];
    enum disks_boundary boundary;
};

/* Writes an error into the message, after the name of the file and the line
   if it is not 0. Returns false. */
static bool is_wrong(const struct file *f, const char *format, ...)
{
    int at = snprintf(f->message, STATES_MESSAGE, "%s:", f->path);
    va_list values;
    if (f->line > 0 && at < STATES_MESSAGE)
        at += snprintf(f->message + at, STATES_MESSAGE - (size_t)at,
                       "%zu:", f->line);
    va_start(values, format);
    if (at < STATES_MESSAGE)
        vsnprintf(f->message + at, STATES_MESSAGE - (size_t)at, format,
                  values);
    va_end(values);
    return false;
}

/* Reads `# box SIDE SIDE [SIDE] BOUNDARY`. Wrong sides count as missing. */
static void read_box(struct file *f, const char *text)
{
    char word[16] = "";
    double box[DISKS_AXES] = {0};
    int found =
        sscanf(text, "# box %lf %lf %lf", &box[0], &box[1], &box[2]);
    if (found < 2)
        return;
    f->axes = (size_t)found;
    for (size_t k = 0; k < f->axes; ++k)
        f->box[k] = box[k] > 0 && box[k] < 1e100 ? box[k] : 0;
    sscanf(text,
           found == 2 ? "# box %*f %*f %15s" : "# box %*f %*f %*f %15s",
           word);
    for (size_t k = 0; k < DISKS_BOUNDARIES; ++k)
        if (strcmp(word, states_boundaries[k]) == 0)
            f->boundary = (enum disks_boundary)k;
}

/* Reads a row: 8 numbers for disks and 10 for spheres, or 11 and 14 with
   position and time of the last collision. Returns false if the row is
   wrong. */
static bool read_row(struct file *f, const char *text)
{
    double *row = f->row[f->rows];
    size_t n = 0;
    char *end;
    for (; n < 14; ++n, text = end) {
        row[n] = strtod(text, &end);
        if (end == text || !isfinite(row[n]))
            break;
    }
    text += strspn(text, " \t\r\n");
    const bool allowed = n == 8 || n == 10 || n == 11 || n == 14;
    if (*text || !allowed || (f->rows > 0 && n != f->columns))
        return is_wrong(f,
                        " %zu numbers in the row, expected 8 or 10, or "
                        "11 or 14, and as many as before",
                        n);
    f->columns = n;
    ++f->rows;
    return true;
}

static bool make_room(struct file *f)
{
    if (f->rows < f->space)
        return true;
    f->space = 2 * f->space + 64;
    void *more = realloc(f->row, f->space * sizeof f->row[0]);
    if (!more)
        return is_wrong(f, " no memory for so many rows");
    f->row = more;
    return true;
}

/* Reads all lines. Returns false at the first wrong line. A blank line ends
   a block, and the next row starts a new block, which replaces the old
   one. */
static bool read_lines(struct file *f, FILE *file)
{
    char *line = NULL;
    size_t space = 0;
    bool good = true, ended = false;
    while (good && getline(&line, &space, file) > 0) {
        ++f->line;
        if (line[0] == '#') {
            read_box(f, line);
        } else if (line[strspn(line, " \t\r\n")] == '\0') {
            ended = true;
        } else {
            f->rows = ended ? 0 : f->rows;
            ended = false;
            good = make_room(f) && read_row(f, line);
        }
    }
    free(line);
    return good;
}

/* Places each disk at its last collision if the file contains that, or else
   at its present position. Returns false if the time of a row differs from
   that of the first row, or is before the last collision of its disk. */
static bool take_rows(struct disks *d, const struct file *f)
{
    const size_t D = d->dimensions;
    const bool whole = f->columns > 4 + 2 * D;
    d->now = f->row[0][0];
    for (size_t i = 0; i < d->count; ++i) {
        const double *row = f->row[i];
        struct disk *a = &d->disk[i];
        d->mass[i] = row[2];
        a->radius = row[3];
        a->since = whole ? row[4 + 3 * D] : row[0];
        for (size_t k = 0; k < D; ++k) {
            a->position[k] = row[4 + k + (whole ? 2 * D : 0)];
            a->velocity[k] = row[4 + D + k];
        }
        if (!(d->mass[i] > 0 && a->radius >= 0) || row[0] != d->now ||
            a->since > d->now)
            return is_wrong(
                f,
                " disk %zu has mass %g, radius %g and times %g, %g; "
                "expected a disk, at the time of the first one",
                i + 1, d->mass[i], a->radius, row[0], a->since);
    }
    return true;
}

/* Creates the disks from the rows. Returns false if the file as a whole is
   wrong. The message then names no line. */
static bool make_disks(struct disks *d, struct file *f)
{
    const size_t D = f->columns == 8 || f->columns == 11 ? 2 : 3;
    f->line = 0;
    if (f->rows == 0 || f->rows > DISKS_MOST)
        return is_wrong(f, " %zu rows of disks", f->rows);
    if (f->axes > 0 && f->axes != D)
        return is_wrong(f,
                        " the box has %zu sides, the rows have %zu "
                        "coordinates",
                        f->axes, D);
    if (!disks_create(d, D, f->rows))
        return is_wrong(f, " no memory for the disks");
    d->boundary = f->boundary;
    memcpy(d->box, f->box, D * sizeof d->box[0]);
    if (take_rows(d, f))
        return true;
    disks_free(d);
    return false;
}

bool states_read(struct disks *d, const char *path,
                 char message[STATES_MESSAGE])
{
    struct file f = {.path = path, .message = message};
    FILE *file = fopen(path, "r");
    if (!file)
        return is_wrong(&f, " %s", strerror(errno));
    const bool good = read_lines(&f, file) && make_disks(d, &f);
    fclose(file);
    free(f.row);
    return good;
}
