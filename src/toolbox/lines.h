/* Defines struct table, for toolbox/table.c and page/table.c only. */
/* toolbox/table.c writes files. page/table.c writes to memory in a browser.
   Both write the same lines with the functions of lines.c. */
#ifndef TOOLBOX_LINES_H
#define TOOLBOX_LINES_H

#include "toolbox/table.h"

#include <stdio.h>
#include <sys/stat.h>

struct table {
    const char *program;
    FILE *stream;
    char *name;       /* the path as given; NULL: standard output */
    size_t size;      /* for a table in memory: length of `name`, which then
                         holds the text */
    char *path;       /* final name, links resolved, or NULL */
    char *temporary;  /* temporary name, or NULL if none */
    bool exists;      /* whether the file existed when opened */
    struct stat file; /* status of the file, if it existed */
    size_t columns;
    const struct table_key *keys; /* keys of a summary, or NULL */
    uint64_t written;             /* bit k is set if keys[k] was written */
    int error;                    /* errno of the first failure, or 0 */
    /* While the head is kept in memory, `stream` writes to `head`, and
       `held` is the stream of the file. Afterwards `held` is NULL, and
       `stream` writes to the file. */
    FILE *held;
    char *head;
    size_t head_size;
    struct table *next; /* next in the list of open tables */
};

/* Stores errno as the error of t if `good` is false and t has no earlier
   error. */
void lines_note_error(struct table *t, bool good);

/* Writes the head if it is still in memory. Later text is written
   directly. */
void lines_release_head(struct table *t);

#endif
