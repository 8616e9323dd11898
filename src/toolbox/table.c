/* From chapters/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 2477232155 of the lines below */
#define _XOPEN_SOURCE 700 /* realpath */

#include "toolbox/table.h"

#include "toolbox/version.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

struct table {
    const char *program;
    FILE *stream;
    char *name;      /* as it was given; NULL: standard output */
    char *path;      /* what it is when links have been followed */
    char *temporary; /* what is written meanwhile; NULL: path itself */
    size_t columns;
    int error; /* errno of the first failure, or 0 */
};

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

static void free_table(struct table *t)
{
    if (!t)
        return;
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
    const size_t size = strlen(t->path) + sizeof ".XXXXXX";
    t->temporary = malloc(size);
    if (!t->temporary)
        return false;
    snprintf(t->temporary, size, "%s.XXXXXX", t->path);
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

static bool open_table(struct table *t, const char *path)
{
    struct stat status;
    if (!path) {
        t->stream = stdout;
        return fcntl(STDOUT_FILENO, F_GETFD) != -1;
    }
    t->name = strdup(path);
    const bool exists = stat(path, &status) == 0;
    if (exists && access(path, W_OK) != 0)
        return false;
    if (!exists && (errno != ENOENT || lstat(path, &status) == 0))
        return false;
    t->path = exists && S_ISREG(status.st_mode) ? realpath(path, NULL)
                                                : strdup(path);
    if (!t->name || !t->path)
        return false;
    if (exists && !S_ISREG(status.st_mode))
        return open_stream(t, open(path, O_WRONLY));
    const mode_t mask = umask(0);
    umask(mask);
    const mode_t mode = exists ? status.st_mode & 0777 : 0666 & ~mask;
    return open_temporary(t, mode);
}

struct table *table_open(const char *program, const char *path)
{
    struct table *t = calloc(1, sizeof *t);
    prepare_process();
    if (path && strcmp(path, "-") == 0)
        path = NULL;
    if (t && open_table(t, path)) {
        t->program = program;
        return t;
    }
    complain(program, path, strerror(errno));
    free_table(t);
    return NULL;
}

static void note_error(struct table *t, bool good)
{
    if (!good && t->error == 0)
        t->error = errno != 0 ? errno : EIO;
}

bool table_close(struct table *t)
{
    if (!t)
        return true;
    note_error(t, fflush(t->stream) == 0 && !ferror(t->stream));
    if (t->name)
        note_error(t, fclose(t->stream) == 0);
    if (t->temporary && t->error == 0)
        note_error(t, rename(t->temporary, t->path) == 0);
    const bool good = t->error == 0;
    if (!good)
        complain(t->program, t->name, strerror(t->error));
    forget_table(t, good);
    return good;
}

void table_discard(struct table *t)
{
    if (t && t->name)
        fclose(t->stream);
    if (t)
        forget_table(t, false);
}

bool table_print(struct table *t, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    errno = 0;
    note_error(t, vfprintf(t->stream, format, arguments) >= 0);
    va_end(arguments);
    return t->error == 0;
}

static bool print_real(struct table *t, double value)
{
    if (isnan(value))
        return table_print(t, "nan");
    return table_print(t, "%.17g", value);
}

void table_begin(struct table *t, const char *command, uint64_t seed)
{
    table_print(t, "# %s (Bonkers) %s\n", t->program, TOOLBOX_VERSION);
    table_print(t, "# command: %s\n", command);
    table_print(t, "# seed: %" PRIu64 "\n", seed);
}

void table_column(struct table *t, const char *symbol, const char *unit,
                  const char *meaning)
{
    ++t->columns;
    table_print(t, "# %zu %s [%s] %s\n", t->columns, symbol,
                unit && *unit ? unit : "1", meaning);
}

bool table_row(struct table *t, size_t n, const double values[])
{
    assert(t->columns == 0 || n == t->columns);
    for (size_t i = 0; i < n; ++i) {
        if (i > 0)
            table_print(t, " ");
        print_real(t, values[i]);
    }
    return table_print(t, "\n");
}

void table_real(struct table *t, const char *key, double value)
{
    table_print(t, "%s ", key);
    print_real(t, value);
    table_print(t, "\n");
}

void table_count(struct table *t, const char *key, uint64_t value)
{
    table_print(t, "%s %" PRIu64 "\n", key, value);
}

void table_text(struct table *t, const char *key, const char *text)
{
    table_print(t, "%s %s\n", key, text);
}
