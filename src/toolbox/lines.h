/* The inside of a table, for toolbox/table.c and page/table.c alone. */
/* table.c writes files, and page/table.c memory, in a browser. Both write
   the same lines, by the functions of lines.c. */
#ifndef TOOLBOX_LINES_H
#define TOOLBOX_LINES_H

#include "toolbox/table.h"

#include <stdio.h>
#include <sys/stat.h>

struct table {
    const char *program;
    FILE *stream;
    char *name;       /* the path as given; NULL: standard output */
    size_t size;      /* bytes in `name`, for a table in memory */
    char *path;       /* final name, links resolved; NULL: none */
    char *temporary;  /* the file being written; NULL: written in place */
    bool exists;      /* whether the file existed when opened; */
    struct stat file; /* if so, its status */
    size_t columns;
    const struct table_key *keys; /* keys of a summary; NULL: a table */
    uint64_t written;             /* bit k: keys[k] was written */
    int error;                    /* errno of the first failure, or 0 */
    /* While the head is kept in memory, `stream` writes to `head`, and
       `held` is the stream of the file; afterwards `held` is NULL. */
    FILE *held;
    char *head;
    size_t head_size;
    struct table *next; /* next in the list of open tables */
};

/* Remembers errno if `good` is false and this is the first failure. */
void lines_note_error(struct table *t, bool good);

/* Writes the head if it is in memory; later text is written directly. */
void lines_release_head(struct table *t);

#endif
