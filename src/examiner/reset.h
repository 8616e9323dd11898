/* Replaces a student's file with the stub, and keeps a dated copy. */
#ifndef RESET_H
#define RESET_H

#include "examiner/course.h"

/* Saves the student's file under a dated name beside it and puts the stub
   in its place. On failure, exits with status 2 and changes nothing. */
void reset_exercise(struct exercise *e);

#endif
