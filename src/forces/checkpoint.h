/* Checkpoints let a killed run continue as if never interrupted. */
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
    double steps, collisions, evaluations, rows; /* counts so far */
    double energy,                               /* at the start, J */
        depth,     /* greatest depth of the potential below 0 in any row of
                      the table, J */
        worst;     /* largest deviation from `energy` in any row, J */
    double passed, /* number of pairs that passed through each other */
        overlap;   /* largest overlap at the start, m */
    double last;   /* energy of the last row, J */
    double scene;  /* checkpoint_sum of the scene's file */
};

/* A run that can be resumed. Below, FILE is the name of its output file.
   FILE.rows contains the rows of the unfinished table, and FILE.checkpoint
   contains the state. All members are private. */
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

/* Returns whether `output` is a regular file or does not exist. If so, a
   run that writes its table to it can be resumed. NULL is standard output,
   for which the result is false. */
bool checkpoint_possible(const char *output);

/* Returns a checksum of the bytes of a file, a whole number below 2^53, or
   0 if the file is not a regular one or cannot be read. */
double checkpoint_sum(const char *path);

/* Begins a run with no rows. Returns false, after an error message and
   with nothing to free, if FILE.rows cannot be written, or if FILE.rows or
   FILE.checkpoint belongs to another run or program. In the second case
   c->locked is true. The pointers `program` and `command` are kept. */
bool checkpoint_begin(struct checkpoint *c, const char *program,
                      const char *command, const char *output);

/* Returns whether FILE.checkpoint exists. */
bool checkpoint_exists(const char *output);

/* Resumes a run with the rows of FILE.rows. Reads its scene and its numbers
   from FILE.checkpoint. Returns false in the same cases as
   checkpoint_begin, and if the files are damaged or were written by another
   command. */
bool checkpoint_resume(struct checkpoint *c, const char *program,
                       const char *command, const char *output,
                       struct scene *s, struct checkpoint_numbers *n);

/* Restores the state of the adaptive method of a resumed motion. Returns
   false if the numbers read do not fit the method. */
bool checkpoint_recall(const struct checkpoint *c, struct motion *m);

/* Adds a row, formatted as by table_row. Returns false after an error. */
bool checkpoint_row(struct checkpoint *c, size_t n, const double values[]);

/* Writes the current state of the motion, and the length and checksum of
   all rows so far, to FILE.checkpoint. Returns false after an error. */
bool checkpoint_write(struct checkpoint *c, struct motion *m,
                      struct checkpoint_numbers n);

/* Copies all rows into a table. Returns false after an error or if their
   checksum has changed; the table must then be discarded. */
bool checkpoint_copy(struct checkpoint *c, struct table *t);

/* Closes both files. Removes them unless keep is true and a checkpoint
   exists. */
void checkpoint_end(struct checkpoint *c, bool keep);

#endif
