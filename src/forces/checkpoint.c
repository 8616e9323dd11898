/* Writes and reads checkpoints, and the rows of an unfinished table. */
#include "forces/checkpoint.h"

#include "forces/adaptive.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Returns false for pipes, terminals, and all files under /dev or /proc
   except /dev/shm, even if the name leads to a regular file, as /dev/stdout
   may. */
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

/* Returns a followed by b, to be freed, or NULL if memory runs out. */
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

/* Prints an error message unless one was printed before, and returns false.
   On a full disk every further row would repeat the message. */
static bool complain(struct checkpoint *c, const char *path,
                     const char *reason)
{
    if (!c->failed)
        fprintf(stderr, "%s: %s: %s\n", c->program, path, reason);
    c->failed = true;
    return false;
}

/* Reports an error in writing rows, and returns false. On a full disk part
   of a row may have been written, and the C library drops the rest. No
   further checkpoint is then written, so the previous checkpoint, if any,
   remains the last one whose rows are complete. */
static bool lose(struct checkpoint *c)
{
    c->lost = true;
    return complain(c, c->rows_path, strerror(errno));
}

/* --resume compares this checksum to see whether a scene has changed since
   its run began. The checksum is 0 for a pipe, which can be read only
   once. */
double checkpoint_sum(const char *path)
{
    static char piece[65536];
    uint64_t sum = TABLE_NOTHING;
    struct stat status;
    const bool regular =
        stat(path, &status) == 0 && S_ISREG(status.st_mode);
    FILE *file = regular ? fopen(path, "r") : NULL;
    if (!file)
        return 0;
    for (size_t n; (n = fread(piece, 1, sizeof piece, file)) > 0;)
        sum = table_sum(sum, piece, n);
    fclose(file);
    return (double)(sum >> 11);
}

static bool name_files(struct checkpoint *c, const char *program,
                       const char *command, const char *output)
{
    *c = (struct checkpoint){
        .program = program, .command = command, .sum = TABLE_NOTHING};
    c->path = join(output, ".checkpoint");
    c->rows_path = join(output, ".rows");
    return c->path && c->rows_path ? true
                                   : complain(c, output, "no memory");
}

/* Removes the checkpoint before the rows, in case the program is killed in
   between: a checkpoint without rows would be an error, but rows without a
   checkpoint are harmless. If a run ends before its first checkpoint, its
   rows are removed, too. */
void checkpoint_end(struct checkpoint *c, bool keep)
{
    const bool locked = c->locked;
    if (c->rows && !locked && (!keep || access(c->path, F_OK) != 0)) {
        unlink(c->path);
        unlink(c->rows_path);
    }
    if (c->rows)
        fclose(c->rows);
    free(c->path);
    free(c->rows_path);
    free(c->own);
    *c = (struct checkpoint){.locked = locked};
}

/* The first lines of the two files. A file of the same name that begins
   with another line is not ours and stays unchanged. */
static const char rows_begin[] = "# rows of step\n";
static const char checkpoint_begins[] =
    "# a checkpoint, and a scene: --resume goes on\n";

/* Opens the file of rows and locks it until the run ends. Without the lock,
   two runs that write the same table would mix their rows without an error.
   The inodes of the open file and of the name are compared because another
   run that has just ended may have removed the name after we opened the
   file. */
static bool take_rows(struct checkpoint *c, int flags)
{
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    struct stat ours, named;
    const int file = open(c->rows_path, O_RDWR | flags, 0666);
    c->rows = file == -1 ? NULL : fdopen(file, "r+");
    if (!c->rows)
        return complain(c, c->rows_path, strerror(errno));
    c->locked = (fcntl(file, F_SETLK, &whole) != 0 &&
                 (errno == EACCES || errno == EAGAIN)) ||
                fstat(file, &ours) != 0 ||
                stat(c->rows_path, &named) != 0 ||
                ours.st_ino != named.st_ino;
    return !c->locked ||
           complain(c, c->rows_path, "another run is writing it");
}

/* Returns whether a file does not exist, is empty, or begins with the line
   `beginning`. Otherwise prints an error. */
static bool is_ours(struct checkpoint *c, const char *path,
                    const char *beginning)
{
    char line[64] = "";
    FILE *file = fopen(path, "r");
    const bool some = file && fgets(line, sizeof line, file);
    if (file)
        fclose(file);
    c->locked = some && strcmp(line, beginning) != 0;
    return !c->locked ||
           complain(c, path, "is not step's and stays: another -o will do");
}

/* Removes the checkpoint of an older run, whose rows are lost, and writes
   the first line of the file of rows. */
static bool start_rows(struct checkpoint *c)
{
    unlink(c->path);
    c->sum = table_sum(c->sum, rows_begin, strlen(rows_begin));
    if (ftruncate(fileno(c->rows), 0) == 0 &&
        fputs(rows_begin, c->rows) >= 0)
        return true;
    return complain(c, c->rows_path, strerror(errno));
}

bool checkpoint_begin(struct checkpoint *c, const char *program,
                      const char *command, const char *output)
{
    if (name_files(c, program, command, output) &&
        is_ours(c, c->rows_path, rows_begin) &&
        is_ours(c, c->path, checkpoint_begins) && take_rows(c, O_CREAT) &&
        start_rows(c))
        return true;
    checkpoint_end(c, true);
    return false;
}

/* Formats numbers, and nan, exactly as table_row does. */
bool checkpoint_row(struct checkpoint *c, size_t n, const double values[])
{
    for (size_t i = 0; i < n; ++i) {
        char text[32] = "nan ";
        if (!isnan(values[i]))
            snprintf(text, sizeof text, "%.17g ", values[i]);
        const size_t length = strlen(text);
        text[length - 1] = i + 1 < n ? ' ' : '\n';
        fputs(text, c->rows);
        c->sum = table_sum(c->sum, text, length);
    }
    return !ferror(c->rows) || lose(c);
}

/* Writes out all buffered rows and moves to the end of the file. Called
   before the rows are counted or copied. */
static bool flush_rows(struct checkpoint *c)
{
    if (c->lost || fflush(c->rows) != 0 || fseek(c->rows, 0, SEEK_END) != 0)
        return lose(c);
    return true;
}

/* Copies the rows and computes their checksum again. The caller keeps the
   table only if the checksum is unchanged. */
bool checkpoint_copy(struct checkpoint *c, struct table *t)
{
    static char piece[65536];
    const size_t skip = strlen(rows_begin);
    uint64_t sum = table_sum(TABLE_NOTHING, rows_begin, skip);
    size_t n;
    bool good = flush_rows(c) && fseek(c->rows, (long)skip, SEEK_SET) == 0;
    while (good && (n = fread(piece, 1, sizeof piece, c->rows)) > 0) {
        sum = table_sum(sum, piece, n);
        good = table_print(t, "%.*s", (int)n, piece);
    }
    if (!good || ferror(c->rows))
        return complain(c, c->rows_path, strerror(errno));
    return sum == c->sum ||
           complain(c, c->rows_path, "has other rows than were written");
}

/* The names of the numbers in a checkpoint, for writing and reading. */
#define PLACE(field) #field, offsetof(struct checkpoint_numbers, field)
static const struct {
    const char *name;
    size_t offset;
    bool count; /* must be a whole number >= 0 */
} numbers[] = {{PLACE(start), false},     {PLACE(steps), true},
               {PLACE(collisions), true}, {PLACE(evaluations), true},
               {PLACE(rows), true},       {PLACE(energy), false},
               {PLACE(depth), false},     {PLACE(worst), false},
               {PLACE(passed), true},     {PLACE(overlap), false},
               {PLACE(last), false},      {PLACE(scene), true}};

enum { NUMBERS = sizeof numbers / sizeof numbers[0] };

static double *number(struct checkpoint_numbers *n, size_t k)
{
    return (double *)(void *)((char *)n + numbers[k].offset);
}

/* Saves the state of m's adaptive method, if it has one, in *c. Returns
   false if memory runs out. */
static bool note_own(struct checkpoint *c, const struct motion *m)
{
    const struct adaptive *const own = m->stepping.own;
    free(c->own);
    c->owned = own ? adaptive_notes(own) : 0;
    c->own = own ? malloc(c->owned * sizeof *c->own) : NULL;
    if (c->own)
        adaptive_note(own, c->own);
    return !c->own == !own;
}

/* Flushes the rows before writing the checkpoint that refers to them. The
   last line of the checkpoint is the checksum of all lines before it, and
   shows whether the file was truncated or changed. */
bool checkpoint_write(struct checkpoint *c, struct motion *m,
                      struct checkpoint_numbers n)
{
    if (!flush_rows(c))
        return false;
    if (!motion_note(m) || !note_own(c, m))
        return complain(c, c->path, "no memory");
    const long length = ftell(c->rows);
    struct table *t = table_open(c->program, c->path);
    if (!t)
        return false;
    table_print(t, "%s", checkpoint_begins);
    table_print(t, "#= command %s\n", c->command);
    table_print(t, "#= length %ld\n", length);
    table_print(t, "#= sum %" PRIu64 "\n", c->sum);
    for (size_t k = 0; k < NUMBERS; ++k)
        table_print(t, "#= %s %.17g\n", numbers[k].name, *number(&n, k));
    for (size_t k = 0; k < c->owned; ++k)
        table_print(t, "#= own %.17g\n", c->own[k]);
    scene_write(m->scene, t);
    uint64_t sum;
    if (!table_sum_so_far(t, &sum)) {
        table_discard(t);
        return complain(c, c->path, strerror(errno));
    }
    table_print(t, "#= end %" PRIu64 "\n", sum);
    return table_close(t);
}

enum { COUNTS = 3 }; /* the lines `length`, `sum` and `end` */

/* The contents of the lines "#= KEY VALUE" of a checkpoint. All of them are
   checked, so an edited file is refused. */
struct head {
    char *line;           /* buffer of getline, `room` bytes long */
    size_t room, found;   /* found: how many numbers and counts were read */
    bool command, end;    /* the line was found with the right value */
    uint64_t length, sum; /* length and checksum of the rows */
    uint64_t own;         /* checksum of the lines read so far */
};

/* Returns the value of a line that begins with this key, or NULL for
   another key. The line is passed without its "#= ". */
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

/* Appends a number of an adaptive method to c->own. Doubles the array when
   it is full, since the file does not say how many numbers follow. */
static bool take_own(struct checkpoint *c, const char *value)
{
    if ((c->owned & (c->owned - 1)) == 0) { /* full at 0, 1, 2, 4, 8 ... */
        const size_t room = c->owned > 0 ? 2 * c->owned : 1;
        double *const more = realloc(c->own, room * sizeof *more);
        if (!more)
            return false;
        c->own = more;
    }
    return take_number(value, false, &c->own[c->owned++]);
}

bool checkpoint_recall(const struct checkpoint *c, struct motion *m)
{
    struct adaptive *const own = m->stepping.own;
    if (c->owned != (own ? adaptive_notes(own) : 0))
        return false;
    if (own)
        adaptive_recall(own, c->own);
    return true;
}

/* Reads a line of the head. Returns false if the value is wrong or the key
   is unknown, as in a file from a later version or another program. */
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
    if ((value = after(line, "own")))
        return take_own(c, value);
    for (size_t k = 0; k < NUMBERS; ++k)
        if ((value = after(line, numbers[k].name))) {
            ++h->found;
            return take_number(value, numbers[k].count, number(n, k));
        }
    uint64_t own;
    value = after(line, "end");
    return h->end = value && take_count(h, value, &own) && own == h->own;
}

/* Reads the head up to its last line, whose key is `end`, and skips the
   lines of the scene. Returns false, after an error message, if a line is
   missing or wrong. */
static bool read_head(struct checkpoint *c, struct head *h,
                      struct checkpoint_numbers *n)
{
    FILE *file = fopen(c->path, "r");
    bool good = file != NULL;
    ssize_t length;
    while (good && !h->end &&
           (length = getline(&h->line, &h->room, file)) > 0) {
        const uint64_t sum = table_sum(h->own, h->line, (size_t)length);
        if (h->line[length - 1] == '\n')
            h->line[length - 1] = '\0';
        if (strncmp(h->line, "#= ", 3) == 0)
            good = take_line(c, h, n, h->line + 3);
        h->own = sum;
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

/* Adds the next `length` bytes of the rows to the checksum. Returns the
   number of bytes read. */
static uint64_t read_rows(struct checkpoint *c, uint64_t length)
{
    static char piece[65536];
    uint64_t done = 0;
    size_t n = 1;
    while (n > 0 && done < length) {
        const uint64_t left = length - done;
        n = fread(piece, 1, left < sizeof piece ? left : sizeof piece,
                  c->rows);
        c->sum = table_sum(c->sum, piece, n);
        done += n;
    }
    return done;
}

/* Checks that all rows counted by the checkpoint are in the file,
   unchanged. Removes later rows, which will be computed again. */
static bool open_rows(struct checkpoint *c, const struct head *h)
{
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
    struct head h = {.own = TABLE_NOTHING};
    const bool good = name_files(c, program, command, output) &&
                      take_rows(c, 0) && read_head(c, &h, n) &&
                      open_rows(c, &h) && scene_read(s, program, c->path);
    free(h.line);
    if (!good)
        checkpoint_end(c, true);
    return good;
}
