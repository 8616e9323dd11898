/* Shows a worked solution to a student whose own solution passes. */
#ifndef SOLUTION_H
#define SOLUTION_H

#include "examiner/verdict.h"

/* Judges the exercise. Shows the worked solution if it passes; otherwise
   says that it does not. */
void solution_show(struct exercise *e, const struct verdict_rules *rules);

#endif
