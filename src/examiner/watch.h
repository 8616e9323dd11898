/* Checks each file that is saved, until asked to stop. */
#ifndef WATCH_H
#define WATCH_H

#include "examiner/verdict.h"

/* Shows the next step at once, and again whenever a chosen file is saved.
   Returns after a signal, or when the user types q. */
void watch_files(struct course *course, const struct verdict_rules *rules);

#endif
