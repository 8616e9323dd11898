/* Shows a worked solution to a student whose own passes. */
#ifndef SOLUTION_H
#define SOLUTION_H

#include "examiner/verdict.h"

/* Shows the worked solution if the exercise passes, else the reason why
   not. */
void solution_show(struct exercise *e, const struct verdict_rules *rules);

#endif
