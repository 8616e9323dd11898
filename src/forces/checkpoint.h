/* Checkpoints: a killed run is resumed and writes equal bytes. */
#ifndef CHECKPOINT_H
#define CHECKPOINT_H

#include "forces/motion.h"
#include "scenes/scene.h"
#include "toolbox/table.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* The state of a run besides its scene. Members in the line of steps are
   whole numbers. */
struct checkpoint_numbers {
    double start; /* s */
    double steps, collisions, evaluations, rows;
    double energy, depth, worst; /* J, as in struct watch of step */
    double passed, overlap;      /* as in struct watch of step */
    double last;                 /* energy of the last row, J */
    double scene;                /* checkpoint_sum of the scene's file */
};

/* The rows of an unfinished table, in FILE.rows, and the state of its run,
   in FILE.checkpoint. All members are private. */
struct checkpoint {
    const char *program, *command;
    char *path, *rows_path;
    FILE *rows;
    uint64_t sum; /* checksum of all rows */
    bool failed;  /* an error in writing has been reported */
    bool lost;    /* rows were lost: no more checkpoints */
    bool locked;  /* the files belong to another run or program */
    double *own;  /* [owned] the state of an adaptive method */
    size_t owned;
};

/* Returns whether the run that writes this table (NULL: standard output)
   can be resumed: if it is a regular file or does not exist yet. */
bool checkpoint_possible(const char *output);

/* Returns a checksum, a whole number below 2^53, of a file's bytes; 0 if it
   is not a regular file, or cannot be read. */
double checkpoint_sum(const char *path);

/* Begins without rows. Returns false, after an error message and with
   nothing to free, if FILE.rows cannot be written, or belongs to another
   run or program: then c->locked is true. Pointers program and command are
   kept. */
bool checkpoint_begin(struct checkpoint *c, const char *program,
                      const char *command, const char *output);

/* Returns whether FILE.checkpoint exists. */
bool checkpoint_exists(const char *output);

/* Begins with the rows of FILE.rows and the scene and the numbers of
   FILE.checkpoint. Returns false as checkpoint_begin does, also if they
   belong to another command. */
bool checkpoint_resume(struct checkpoint *c, const char *program,
                       const char *command, const char *output,
                       struct scene *s, struct checkpoint_numbers *n);

/* Restores the state of the adaptive method of a resumed motion. Returns
   false if the numbers read do not fit the method. */
bool checkpoint_recall(const struct checkpoint *c, struct motion *m);

/* Adds a row, formatted as by table_row. */
bool checkpoint_row(struct checkpoint *c, size_t n, const double values[]);

/* Writes FILE.checkpoint: the present state of the motion, and the length
   and checksum of all rows so far. */
bool checkpoint_write(struct checkpoint *c, struct motion *m,
                      struct checkpoint_numbers n);

/* Copies all rows into a table. Returns false if their checksum has
   changed; the table must then not get its name. */
bool checkpoint_copy(struct checkpoint *c, struct table *t);

/* Closes the files; removes them unless keep is true and there is a
   checkpoint from which another run can continue. */
void checkpoint_end(struct checkpoint *c, bool keep);

#endif
