/* Finds what students have handed in, and for which exercise. */
#ifndef SUBMISSIONS_H
#define SUBMISSIONS_H

#include <stdbool.h>
#include <stddef.h>

enum { SUBMISSIONS_BYTES = 1 << 20 }; /* of a student's file, at most */

/* A file that may be somebody's answer to an exercise. */
struct answer {
    char *path;        /* below the folder of submissions */
    char exercise[4];  /* "01a" */
    int rank;          /* less is a better place, or a better name */
    long long attempt; /* the larger one was handed in later */
};

/* What one student has handed in. */
struct submission {
    char *entry; /* what is the student's at the top; "." if the folder
                    itself */
    char *name;  /* the student's, as text (see marks_text) */
    char *notes; /* what was not graded, and why: text, a line each */
    size_t noted, count, others; /* notes, answers, other files */
    long long attempt;           /* of what is being looked at */
    bool canvas;                 /* and whether Canvas has named it */
    struct answer *answers;
};

/* Nothing vanishes: what looks like somebody's work is graded, or a person
   is told that it was not. An archive that nobody has unpacked, a file
   01a.txt, a second answer to an exercise are each zero points without a
   word if a grader looks only for what it knows. */
struct submissions {
    struct submission *list; /* of students, in order of entry */
    size_t count;
    struct submission nobody; /* with notes on what is no student's */
};

/* Finds the submissions in a folder: folders of students, or files whose
   names begin with theirs, or the files of one. usual: "01a-collide.c" and
   all others that there are, ended by NULL. start: letters with which the
   names begin that are wanted, "" for all of them. Exits with status 2 when
   the folder cannot be read or holds no submission. */
struct submissions submissions_find(const char *folder,
                                    const char *const usual[],
                                    const char *start);

/* Reads the answer to an exercise that is usually called so. Returns its
   bytes, for the caller to free, with their number in *length; or NULL.
   *file says which it was, "no file" if none; *note what a person should
   know of it, or is empty. The caller frees both. */
char *submissions_read(const char *folder, const struct submission *s,
                       const char *usual, size_t *length, char **file,
                       char **note);

/* Reads what is called so ("P1.gp", "P1.txt") in the best place. Returns
   its bytes as submissions_read does; or NULL, with a reason in *refusal if
   there was one. The caller frees both. */
char *submissions_page(const char *folder, const struct submission *s,
                       const char *name, size_t *length, char **refusal);

#endif
