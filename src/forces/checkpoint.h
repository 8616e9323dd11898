/* Checkpoints, from which a killed run continues as if not interrupted. */
#ifndef CHECKPOINT_H
#define CHECKPOINT_H

#include "forces/motion.h"
#include "scenes/scene.h"
#include "toolbox/table.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* The state of a run, without its scene. */
struct checkpoint_numbers {
    double start; /* time at the start of the run, s */
    double steps, collisions, evaluations, rows; /* whole numbers so far */
    double energy,                               /* at the start, J */
        depth,     /* of the deepest potential of a row, J */
        worst;     /* largest deviation from `energy` in a row, J */
    double passed, /* number of pairs that passed through each other */
        overlap;   /* largest overlap at the start, m */
    double last;   /* energy of the last row, J */
    double scene;  /* checkpoint_sum of the scene's file */
};

/* A run that can be resumed: the rows of its unfinished table are in
   FILE.rows, its state is in FILE.checkpoint. All members are private. */
struct checkpoint {
    const char *program, *command;
    char *path, *rows_path;
    FILE *rows;
    uint64_t sum; /* checksum of all rows */
    bool failed;  /* an error in writing has been reported */
    bool lost;    /* rows were lost: no more checkpoints are written */
    bool locked;  /* the files belong to another run or program */
    double *own;  /* [owned] the state of an adaptive method */
    size_t owned;
};

/* Returns whether a run that writes its table to this file (NULL: standard
   output) can be resumed: if it is a regular file or does not exist. */
bool checkpoint_possible(const char *output);

/* Returns a checksum of the bytes of a file, a whole number below 2^53, or
   0 if the file is not a regular one or cannot be read. */
double checkpoint_sum(const char *path);

/* Begins a run with no rows. Returns false, after an error message and with
   nothing to free, if FILE.rows cannot be written or if it or
   FILE.checkpoint belongs to another run or program; in the latter case
   c->locked is true. The pointers program and command are kept. */
bool checkpoint_begin(struct checkpoint *c, const char *program,
                      const char *command, const char *output);

/* Returns whether FILE.checkpoint exists. */
bool checkpoint_exists(const char *output);

/* Resumes a run with the rows of FILE.rows, and reads its scene and its
   numbers from FILE.checkpoint. Returns false in the cases in which
   checkpoint_begin does, and if the files are damaged or were written by
   another command. */
bool checkpoint_resume(struct checkpoint *c, const char *program,
                       const char *command, const char *output,
                       struct scene *s, struct checkpoint_numbers *n);

/* Restores the state of the adaptive method of a resumed motion. Returns
   false if the numbers read do not fit the method. */
bool checkpoint_recall(const struct checkpoint *c, struct motion *m);

/* Adds a row, formatted as by table_row. Returns false after an error. */
bool checkpoint_row(struct checkpoint *c, size_t n, const double values[]);

/* Writes FILE.checkpoint: the present state of the motion, and the length
   and checksum of all rows so far. Returns false after an error. */
bool checkpoint_write(struct checkpoint *c, struct motion *m,
                      struct checkpoint_numbers n);

/* Copies all rows into a table. Returns false after an error or if their
   checksum has changed; the table must then be discarded. */
bool checkpoint_copy(struct checkpoint *c, struct table *t);

/* Closes both files. Removes them unless keep is true and there is a
   checkpoint from which another run can continue. */
void checkpoint_end(struct checkpoint *c, bool keep);

#endif
