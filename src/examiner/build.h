/* Builds a runner from a student's file, or explains why it cannot. */
#ifndef BUILD_H
#define BUILD_H

#include <stdbool.h>
#include <stdio.h>

/* Builds the suite of an exercise ("01a") by make, unless it exists. Exits
   with status 2 if that fails. */
void build_suite(const char *exercise);

/* Compiles source and links it with the suite of an exercise ("01a") to
   folder/runner. With strict, warnings are errors. Returns whether it
   succeeded; if not, writes an explanation for the student to story. Exits
   with status 2 when the kit itself is not ready. */
bool build_runner(const char *folder, const char *exercise,
                  const char *source, bool strict, FILE *story);

/* Explains to the student, in story, the compiler's messages in text, where
   `source` is the name of the student's file. The file `types` contains the
   functions of the exercise with their types; it need not exist. */
void build_tell(const char *text, const char *source, const char *types,
                FILE *story);

/* Writes to story one warning about source from the last build in `folder`:
   the first that we can explain or, if there is none, the first. */
void build_warning(const char *folder, const char *source, FILE *story);

/* Returns whether the last build in `folder` found an error in source. */
bool build_blames(const char *folder, const char *source);

/* Returns whether build/check/flags turns the address sanitizer on. */
bool build_sanitized(void);

#endif
