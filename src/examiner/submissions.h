/* From chapters/B-grader.nw: edit there, then run make tangle. */
/* checksum 3513018787 of the lines below */
#ifndef SUBMISSIONS_H
#define SUBMISSIONS_H

#include <stdbool.h>
#include <stddef.h>

enum { SUBMISSIONS_BYTES = 1 << 20 }; /* of a student's file, at most */

/* What one student has handed in. */
struct submission {
    char *entry; /* of the folder of submissions; "." for itself */
    char *name;  /* the student's, as text (see marks_text) */
};

/* Finds the submissions in a folder: its folders, in order of name. If it
   has none but files of exercises, it is itself the one submission. Returns
   how many; exits with status 2 when it cannot be read or is empty. */
size_t submissions_find(const char *folder, struct submission **list);

/* Reads the file of an exercise ("01a", usually called like usual,
   "01a-collide.c"). Returns its bytes, for the caller to free, with their
   number in *length; or NULL. *remark, for the caller to free, says which
   file it was, or why there is none. */
char *submissions_read(const char *folder, const struct submission *s,
                       const char *exercise, const char *usual,
                       size_t *length, char **remark);

#endif
