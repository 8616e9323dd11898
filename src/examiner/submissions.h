/* Finds the files that students have handed in, and their exercises. */
#ifndef SUBMISSIONS_H
#define SUBMISSIONS_H

#include <stdbool.h>
#include <stddef.h>

enum { SUBMISSIONS_BYTES = 1 << 20 }; /* of a student's file, at most */

/* A file that may be a student's answer to an exercise. */
struct answer {
    char *path;        /* below the folder of submissions */
    char exercise[4];  /* "01a" */
    int rank;          /* the least wins: place, then name */
    long long attempt; /* a larger one was handed in later */
};

/* What one student has handed in. */
struct submission {
    char *entry; /* what is the student's at the top; "." if the folder
                    itself */
    char *name;  /* name of the student (see marks_text) */
    char *notes; /* what was not graded and why, in lines */
    size_t noted, count, others; /* how many notes, answers, other files */
    long long attempt;           /* attempt of the present file */
    bool canvas;                 /* Canvas has named that file */
    struct answer *answers;
};

/* All submissions. Nothing that looks like somebody's work is skipped
   silently: it is graded, or a note for the lecturer says why not. To a
   grader that looks only for what it knows, an archive that nobody
   unpacked, a file 01a.txt, or a second answer would be zero points
   without a word. */
struct submissions {
    struct submission *list; /* of students, in order of entry */
    size_t count;
    struct submission nobody; /* notes on files that are no student's */
};

/* Finds the submissions in a folder: folders of students, or files whose
   names begin with the students', or the files of one student. usual: the
   names of all exercises' files, "01a-collide.c", ended by NULL. start:
   only students whose names begin so, "" for all. Exits with status 2 when
   the folder cannot be read or holds no submission. */
struct submissions submissions_find(const char *folder,
                                    const char *const usual[],
                                    const char *start);

/* Reads a student's answer to the exercise whose file is called `usual'.
   Returns its bytes and their number, or NULL. *file is the path that was
   chosen, or "no file"; *note is what a person should know about it, or
   empty. The caller frees all three. */
char *submissions_read(const char *folder, const struct submission *s,
                       const char *usual, size_t *length, char **file,
                       char **note);

/* Reads the file of this name ("P1.gp", "P1.txt") in the best place.
   Returns its bytes as submissions_read does, or NULL, with a reason in
   *refusal if there is such a file. The caller frees both. */
char *submissions_page(const char *folder, const struct submission *s,
                       const char *name, size_t *length, char **refusal);

#endif
