/* From chapters/works/B-examiner.nw: edit there, then run make tangle. */
/* checksum 2039028546 of the lines below */
#ifndef SOLUTION_H
#define SOLUTION_H

#include "examiner/verdict.h"

/* Shows the worked solution if the exercise passes, else why not. */
void solution_show(struct exercise *e, const struct verdict_rules *rules);

#endif
