/* Checkpoints: a run that was killed goes on, and ends with equal bytes. */
#ifndef CHECKPOINT_H
#define CHECKPOINT_H

#include "forces/motion.h"
#include "scenes/scene.h"
#include "toolbox/table.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* What a run knows besides its scene; counts are whole. */
struct checkpoint_numbers {
    double start; /* s */
    double steps, collisions, evaluations, rows;
    double energy, depth, worst; /* J: see struct watch of step */
    double passed, overlap;      /* the same */
    double last;                 /* J: the energy of the last row */
    double scene;                /* checkpoint_sum of its file */
};

/* The rows of a table in the making, FILE.rows, and what is needed to go
   on with it, FILE.checkpoint. The fields are private. */
struct checkpoint {
    const char *program, *command;
    char *path, *rows_path;
    FILE *rows;
    uint64_t sum; /* of the bytes of all rows */
    bool failed;  /* something could not be written, which has been said */
    bool lost;    /* rows were lost: no more checkpoints */
    bool locked;  /* the files are another run's, or somebody else's */
    double *own;  /* [owned] the state of an adaptive method */
    size_t owned;
};

/* Returns whether a table of this name (NULL: standard output) can be
   resumed: if it is a regular file, or none yet. */
bool checkpoint_possible(const char *output);

/* Returns a whole number below 2^53 that is another one for a file with
   other bytes; 0 for what is no regular file, or cannot be read. */
double checkpoint_sum(const char *path);

/* Begins with no rows. Returns false, having said why on standard error
   and with nothing to free, when FILE.rows cannot be written, or
   is not ours to write: then c->locked is true. program and
   command are kept, not copied. */
bool checkpoint_begin(struct checkpoint *c, const char *program,
                      const char *command, const char *output);

/* Returns whether there is one to go on from. */
bool checkpoint_exists(const char *output);

/* Begins with the rows of FILE.rows and the scene and the numbers of
   FILE.checkpoint. Returns false as above, also when they are those of
   another command. */
bool checkpoint_resume(struct checkpoint *c, const char *program,
                       const char *command, const char *output,
                       struct scene *s, struct checkpoint_numbers *n);

/* Puts the adaptive method of a motion that has been resumed where it was.
   Returns false if what was read is not of its method. */
bool checkpoint_recall(const struct checkpoint *c, struct motion *m);

/* Adds a row, as table_row writes it. */
bool checkpoint_row(struct checkpoint *c, size_t n, const double values[]);

/* Writes FILE.checkpoint: the motion as it is, and all rows so far. */
bool checkpoint_write(struct checkpoint *c, struct motion *m,
                      struct checkpoint_numbers n);

/* Copies all rows into a table. Returns false if their checksum is not that
   of the rows written, so that the table gets no name. */
bool checkpoint_copy(struct checkpoint *c, struct table *t);

/* Closes the files. keep: another run will go on, if there is a checkpoint;
   else they are removed. */
void checkpoint_end(struct checkpoint *c, bool keep);

#endif
