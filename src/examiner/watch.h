/* Checks each file that is saved, until asked to stop. */
#ifndef WATCH_H
#define WATCH_H

#include "examiner/verdict.h"

/* Shows the one thing to mend, and again whenever one of the chosen files
   was saved; returns after a signal, or a q on the keyboard. */
void watch_files(struct course *course, const struct verdict_rules *rules);

#endif
