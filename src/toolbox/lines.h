/* The inside of a table, for toolbox/table.c and page/table.c alone. */
/* table.c writes files, page/table.c memory, in a browser. The lines are
   the same in both, so lines.c has them once. */
#ifndef TOOLBOX_LINES_H
#define TOOLBOX_LINES_H

#include "toolbox/table.h"

#include <stdio.h>
#include <sys/stat.h>

struct table {
    const char *program;
    FILE *stream;
    char *name;       /* as it was given; NULL: standard output */
    size_t size;      /* of a table in memory, whose name is its text */
    char *path;       /* the final name, links resolved, or NULL */
    char *temporary;  /* the file being written; NULL: written in place */
    bool exists;      /* whether the file existed when opened; then */
    struct stat file; /* this was its status */
    size_t columns;
    const struct table_key *keys; /* of a summary */
    uint64_t written;             /* bit k: keys[k] has a line */
    int error;                    /* errno of the first failure, or 0 */
    /* While the head is kept in memory, `stream` writes to `head`, and
       `held` is the stream of the file itself; afterwards `held` is NULL.
     */
    FILE *held;
    char *head;
    size_t head_size;
    struct table *next; /* of the open tables */
};

/* Remembers errno if `good` is false and this is the first failure. */
void lines_note_error(struct table *t, bool good);

/* Writes the head if it still waits in memory; what follows is written
   directly. */
void lines_release_head(struct table *t);

#endif
