/* Opens and closes tables; a file gets its name when it is complete. */
#define _XOPEN_SOURCE 700 /* for realpath, which follows links */

#include "toolbox/lines.h"
#include "toolbox/replace.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static struct table *tables; /* list of the open tables */

static void complain(const char *program, const char *path,
                     const char *reason)
{
    fprintf(stderr, "%s: cannot write %s%s%s: %s\n", program,
            path ? "'" : "", path ? path : "standard output",
            path ? "'" : "", reason);
}

uint64_t table_sum(uint64_t sum, const char *bytes, size_t n)
{
    for (size_t i = 0; i < n; ++i)
        sum = (sum ^ (unsigned char)bytes[i]) * UINT64_C(1099511628211);
    return sum;
}

bool table_sum_so_far(struct table *t, uint64_t *sum)
{
    char piece[BUFSIZ];
    lines_release_head(t);
    ssize_t n = fflush(t->stream) == 0 ? 1 : -1;
    *sum = TABLE_NOTHING;
    for (off_t done = 0; n > 0; done += n) {
        n = pread(fileno(t->stream), piece, sizeof piece, done);
        *sum = table_sum(*sum, piece, n > 0 ? (size_t)n : 0);
    }
    return n == 0;
}

static void free_table(struct table *t)
{
    if (!t)
        return;
    for (struct table **link = &tables; *link; link = &(*link)->next)
        if (*link == t) {
            *link = t->next;
            break;
        }
    free(t->name);
    free(t->path);
    replace_cancel(t->temporary);
    free(t);
}

static bool open_stream(struct table *t, int file)
{
    file = replace_above(file);
    t->stream = file == -1 ? NULL : fdopen(file, "w");
    return t->stream != NULL;
}

static bool is_same(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

/* Returns whether another open table writes to the same file, and sets
   errno to 0. Two tables on one file would replace each other silently.
   Their names may differ (x, ./x, a link), so resolved names are compared,
   and also device and inode if the files exist. A device may be opened
   twice. */
static bool is_taken(const struct table *t)
{
    errno = 0;
    for (const struct table *u = tables; u; u = u->next) {
        if (t->path && u->path && strcmp(t->path, u->path) == 0)
            return true;
        if (t->exists && u->exists && !S_ISCHR(t->file.st_mode) &&
            is_same(&t->file, &u->file))
            return true;
    }
    return false;
}

/* Returns a descriptor through which this file is open for writing, or -1.
   Tries 0 to 9, those that a shell can pass. Such a file must not be
   replaced: with `-o /dev/stdout >>log` the content of log would be lost.
   Read-only descriptors do not count: with `-o gas.dat <gas.dat` the old
   table can be read to its end while the new table is written to a
   temporary file. */
static int find_descriptor(const struct stat *file)
{
    struct stat status;
    for (int i = 0; i < 10; ++i)
        if (fstat(i, &status) == 0 && is_same(&status, file) &&
            (fcntl(i, F_GETFL) & O_ACCMODE) != O_RDONLY)
            return i;
    return -1;
}

/* Returns whether path leads to a device or a process, which is written
   directly. Files in /dev/shm are ordinary files in memory. */
static bool is_special(const char *path)
{
    if (strncmp(path, "/dev/shm/", 9) == 0)
        return false;
    return strncmp(path, "/dev/", 5) == 0 ||
           strncmp(path, "/proc/", 6) == 0;
}

/* Returns the final name of a file that does not exist yet, or NULL. The
   caller frees the name. Resolves only the folder, because realpath needs
   an existing file. */
static char *resolve_new(const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *last = slash ? slash + 1 : path;
    char *folder = strndup(path, (size_t)(last - path)), *name = NULL;
    char *real = folder ? realpath(slash ? folder : ".", NULL) : NULL;
    const size_t size = real ? strlen(real) + strlen(last) + 2 : 0;
    if (real && (name = malloc(size)))
        snprintf(name, size, "%s/%s", real, last);
    free(folder);
    free(real);
    return name;
}

/* Opens the file or device `path` (NULL: standard output). On failure
   returns false and sets errno; errno is 0 if another table writes to the
   same file.

   - fstat notices a closed standard output before a long run, not after.
   - If this process is already writing to the file, the descriptor is
     duplicated. Both copies share one position, so nothing is overwritten.
   - A device or pipe is opened with O_APPEND, which keeps earlier output,
     and without O_CREAT: the mistyped /dev/nul must be an error and not a
     new file.
   - Replacing a file needs permission for its folder only. access() also
     checks the file, because a read-only table must not be replaced.
   - A name that lstat finds and stat does not is a link to nothing. An
     empty name comes from an unset variable of a script. Both are refused
     before the run, not after. */
static bool open_table(struct table *t, const char *path)
{
    if (!path) {
        t->stream = stdout;
        t->exists = fstat(STDOUT_FILENO, &t->file) == 0;
        return t->exists && !is_taken(t);
    }
    t->name = strdup(path);
    if (!t->name)
        return false;
    t->exists = stat(path, &t->file) == 0;
    const int given = t->exists ? find_descriptor(&t->file) : -1;
    if (given != -1)
        return !is_taken(t) && open_stream(t, dup(given));
    if ((t->exists && !S_ISREG(t->file.st_mode)) || is_special(path))
        return !is_taken(t) &&
               open_stream(t, open(path, O_WRONLY | O_APPEND));
    struct stat link;
    if (t->exists && access(path, W_OK) != 0)
        return false;
    if (!t->exists &&
        (errno != ENOENT || *path == '\0' || lstat(path, &link) == 0))
        return false;
    t->path = t->exists ? realpath(path, NULL) : resolve_new(path);
    if (!t->path)
        return false;
    const mode_t mode = t->exists ? t->file.st_mode & 0777 : REPLACE_USUAL;
    return !is_taken(t) &&
           open_stream(t, replace_begin(t->path, mode, &t->temporary));
}

/* Keeps the head in memory until the first row. A program often finds a
   mistake in its command or input only after it has begun a table. A head
   alone on standard output would look like the result of a run. */
static void hold_head(struct table *t)
{
    FILE *memory = open_memstream(&t->head, &t->head_size);
    if (!memory) /* write the head at once */
        return;
    t->held = t->stream;
    t->stream = memory;
}

struct table *table_open(const char *program, const char *path)
{
    struct table *t = calloc(1, sizeof *t);
    if (replace_prepare())
        tables = NULL; /* after fork the tables are the parent's */
    if (path && strcmp(path, "-") == 0)
        path = NULL;
    if (t && open_table(t, path)) {
        hold_head(t);
        t->program = program;
        t->next = tables;
        tables = t;
        return t;
    }
    complain(program, path,
             errno ? strerror(errno) : "another output goes there already");
    free_table(t);
    return NULL;
}

void table_keys(struct table *t, const struct table_key keys[])
{
    t->keys = keys;
}

/* Returns whether all keys before the first heading have been written. */
static bool is_complete(const struct table *t)
{
    const struct table_key *k = t->keys;
    while (k && k->name && t->written >> (k - t->keys) & 1)
        ++k;
    return !k || !k->name || !*k->name;
}

/* Flushes and closes the file before it gets its final name, because only
   then is it known whether everything was written. */
bool table_close(struct table *t)
{
    if (!t)
        return true;
    assert(is_complete(t));
    lines_release_head(t);
    lines_note_error(t, fflush(t->stream) == 0 && !ferror(t->stream));
    if (t->name)
        lines_note_error(t, fclose(t->stream) == 0);
    if (t->temporary && t->error == 0) {
        lines_note_error(t, replace_finish(t->temporary, t->path, false));
        t->temporary = NULL;
    }
    const bool good = t->error == 0;
    if (!good)
        complain(t->program, t->name, strerror(t->error));
    free_table(t);
    return good;
}

void table_discard(struct table *t)
{
    if (t && t->held) { /* a head without rows is not written */
        fclose(t->stream);
        free(t->head);
        t->stream = t->held;
    }
    if (t && t->name)
        fclose(t->stream);
    free_table(t);
}
