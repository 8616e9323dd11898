/* From chapters/B-examiner.nw: edit there, then run make tangle. */
/* checksum 1683739467 of the lines below */
#ifndef BUILD_H
#define BUILD_H

#include <stdbool.h>
#include <stdio.h>

/* Compiles source and links it with the suite of an exercise ("01a") to
   folder/runner. With strict, warnings are errors. Returns whether that
   worked; writes what a student should know of the errors to story, and
   the first warning of a build that worked to warning. Exits with status
   2 when the kit itself is not ready. */
bool build_runner(const char *folder, const char *exercise,
                  const char *source, bool strict, FILE *story,
                  FILE *warning);

/* Whether build/check/flags turns the address sanitizer on. */
bool build_sanitized(void);

#endif
