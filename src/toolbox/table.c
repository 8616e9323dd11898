/* From chapters/works/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 3013013248 of the lines below */
/* A temporary beside the file, which takes its name when all is written. */
#define _XOPEN_SOURCE 700 /* realpath */

#include "toolbox/lines.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static struct table *tables; /* the open ones */

enum { MOST_FILES = 8 };
static char *volatile temporaries[MOST_FILES];
static pid_t owner;

void table_abandon(void)
{
    for (int i = 0; i < MOST_FILES && owner == getpid(); ++i)
        if (temporaries[i])
            unlink(temporaries[i]);
}

static bool swap_temporary(const char *old, char *new)
{
    for (int i = 0; i < MOST_FILES; ++i)
        if (temporaries[i] == old) {
            temporaries[i] = new;
            return true;
        }
    errno = EMFILE;
    return false;
}

static void die_tidily(int number)
{
    table_abandon();
    signal(number, SIG_DFL);
    raise(number);
}

static void prepare_process(void)
{
    static const int fatal[] = {SIGHUP,  SIGINT,  SIGQUIT,
                                SIGTERM, SIGABRT, SIGXCPU};
    struct sigaction old;
    if (owner == getpid())
        return;
    if (owner == 0)
        atexit(table_abandon);
    for (int i = 0; i < MOST_FILES; ++i)
        temporaries[i] = NULL;
    tables = NULL;
    owner = getpid();
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    for (size_t i = 0; i < sizeof fatal / sizeof fatal[0]; ++i)
        if (sigaction(fatal[i], NULL, &old) == 0 &&
            old.sa_handler == SIG_DFL)
            signal(fatal[i], die_tidily);
}

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
    char piece[4096];
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
    free(t->temporary);
    free(t);
}

static void forget_table(struct table *t, bool renamed)
{
    if (t->temporary && !renamed)
        unlink(t->temporary);
    if (t->temporary)
        swap_temporary(t->temporary, NULL);
    free_table(t);
}

static bool open_stream(struct table *t, int file)
{
    int high = file;
    if (0 <= file && file <= STDERR_FILENO) {
        high = fcntl(file, F_DUPFD, STDERR_FILENO + 1);
        close(file);
    }
    t->stream = high == -1 ? NULL : fdopen(high, "w");
    return t->stream != NULL;
}

static bool open_temporary(struct table *t, mode_t mode)
{
    const int folder = (int)(strrchr(t->path, '/') - t->path);
    const size_t size = (size_t)folder + sizeof "/bonkers.XXXXXX";
    t->temporary = malloc(size);
    if (!t->temporary)
        return false;
    snprintf(t->temporary, size, "%.*s/bonkers.XXXXXX", folder, t->path);
    const int file = mkstemp(t->temporary);
    if (file == -1)
        return false;
    if (swap_temporary(NULL, t->temporary) && fchmod(file, mode) == 0 &&
        open_stream(t, file))
        return true;
    const int error = errno;
    unlink(t->temporary);
    swap_temporary(t->temporary, NULL);
    errno = error;
    return false;
}

static bool is_same(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

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
bool table_replaces(const char *path, const char *input)
{
    struct stat in, out;
    if (!path || strcmp(path, "-") == 0)
        return false;
    const int found = strcmp(input, "-") == 0 ? fstat(STDIN_FILENO, &in)
                                              : stat(input, &in);
    return found == 0 && S_ISREG(in.st_mode) && stat(path, &out) == 0 &&
           is_same(&in, &out);
}

static int find_descriptor(const struct stat *file)
{
    struct stat status;
    for (int i = 0; i < 10; ++i)
        if (fstat(i, &status) == 0 && is_same(&status, file) &&
            (fcntl(i, F_GETFL) & O_ACCMODE) != O_RDONLY)
            return i;
    return -1;
}

static bool is_special(const char *path)
{
    if (strncmp(path, "/dev/shm/", 9) == 0)
        return false;
    return strncmp(path, "/dev/", 5) == 0 ||
           strncmp(path, "/proc/", 6) == 0;
}

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
    const mode_t mask = umask(0);
    umask(mask);
    const mode_t mode = t->exists ? t->file.st_mode & 0777 : 0666 & ~mask;
    return !is_taken(t) && open_temporary(t, mode);
}

/* Keeps the head in memory until there is a row. A program often finds what
   is wrong with a command or a file only after it has begun a table: then a
   head alone on standard output would look like the result of a run. */
static void hold_head(struct table *t)
{
    FILE *memory = open_memstream(&t->head, &t->head_size);
    if (!memory) /* then it is written at once */
        return;
    t->held = t->stream;
    t->stream = memory;
}

struct table *table_open(const char *program, const char *path)
{
    struct table *t = calloc(1, sizeof *t);
    prepare_process();
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

static bool is_complete(const struct table *t)
{
    const struct table_key *k = t->keys;
    while (k && k->name && t->written >> (k - t->keys) & 1)
        ++k;
    return !k || !k->name || !*k->name;
}

bool table_close(struct table *t)
{
    if (!t)
        return true;
    assert(is_complete(t));
    lines_release_head(t);
    lines_note_error(t, fflush(t->stream) == 0 && !ferror(t->stream));
    if (t->name)
        lines_note_error(t, fclose(t->stream) == 0);
    if (t->temporary && t->error == 0)
        lines_note_error(t, rename(t->temporary, t->path) == 0);
    const bool good = t->error == 0;
    if (!good)
        complain(t->program, t->name, strerror(t->error));
    forget_table(t, good);
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
    if (t)
        forget_table(t, false);
}
