/* Checks each file that is saved, until asked to stop. */
#ifndef WATCH_H
#define WATCH_H

#include "examiner/verdict.h"

/* Shows the next step, and again whenever a chosen file was saved; returns
   after a signal, or after a q on the keyboard. */
void watch_files(struct course *course, const struct verdict_rules *rules);

#endif
