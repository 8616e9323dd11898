/* Compiles a student's file and explains the compiler's messages. */
#ifndef BUILD_H
#define BUILD_H

#include <stdbool.h>
#include <stdio.h>

/* The shell function `members TYPES FILE COMPILER...` compares the
   structures in FILE, the student's file, with those in the exercise's
   header TYPES. If they differ, it prints an error for build_tell and
   returns 1. The header is compiled after the file, so that the compiler
   reports which structure differs and where FILE defines it
   (tests/types.awk). */
#define BUILD_MEMBERS                                                      \
    "members() (\n"                                                        \
    "    types=$1 file=$2 && shift 2\n"                                    \
    "    grep -qs EXAMINER_AFTER \"$types\" || exit 0\n"                   \
    "    \"$@\" -w -fsyntax-only -DEXAMINER_AFTER -include \"$file\" \\\n" \
    "        -x c $types 2>&1 | awk '/error: static.assert/ { bad = 1 }\n" \
    "    /error: red/ { sub(/.* of/, \"error: members changed in\")\n"     \
    "        of = $0 }\n"                                                  \
    "    bad && sub(/note: .*/, of) { sub(/^\\.\\//, \"\"); left = 3 }\n"  \
    "    left && left-- { print; if (!left) exit } END { exit bad }')\n"

/* Runs make to compile the tests of `exercise`, such as "01a", unless they
   are compiled already. Exits with status 2 on failure. */
void build_suite(const char *exercise);

/* Compiles `source`, links it with the tests of `exercise`, such as "01a",
   and writes the program folder/runner. If `strict` is true, warnings are
   errors. Returns whether that succeeded; on failure, writes an explanation
   for the student to `story`. Exits with status 2 if build/check/flags or
   the compiler's messages cannot be read. */
bool build_runner(const char *folder, const char *exercise,
                  const char *source, bool strict, FILE *story);

/* Explains the compiler's messages `text` to the student, in `story`.
   `source` is the name of the student's file. The header file `types`
   declares the functions of the exercise and may be absent. */
void build_tell(const char *text, const char *source, const char *types,
                FILE *story);

/* Writes to `story` one warning about `source` from the last build in
   `folder`: the first that has an explanation or, if none has, the very
   first. */
void build_warning(const char *folder, const char *source, FILE *story);

/* Returns whether the last build in `folder` found an error in `source`. */
bool build_blames(const char *folder, const char *source);

/* Returns whether the compiler's command in build/check/flags turns on the
   address sanitizer. */
bool build_sanitized(void);

#endif
