/* From chapters/works/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 1110605256 of the lines below */
/* The inside of a table, for toolbox/table.c and page/table.c alone. */
#ifndef TOOLBOX_LINES_H
#define TOOLBOX_LINES_H

#include "toolbox/table.h"

#include <stdio.h>
#include <sys/stat.h>

struct table {
    const char *program;
    FILE *stream;
    char *name;      /* as it was given; NULL: standard output */
    size_t size;     /* of a table in memory, whose name is its text */
    char *path;      /* the name in the end, links followed, or NULL */
    char *temporary; /* what is written meanwhile; NULL: the file itself */
    bool exists;     /* the file did, when it was opened, and was: */
    struct stat file;
    size_t columns;
    const struct table_key *keys; /* of a summary */
    uint64_t written;             /* which of them, a bit each */
    int error;                    /* errno of the first failure, or 0 */
    FILE *held; /* what the head waits for, or NULL; till then the */
    char *head; /* stream writes it here */
    size_t head_size;
    struct table *next; /* of the open tables */
};

/* Remembers errno if this is the first failure: what fails to write sets
   it. */
void lines_note_error(struct table *t, bool good);

/* Writes the head if it still waits, and lets the rest follow it. */
void lines_release_head(struct table *t);

#endif
