/* Finds the files that students have handed in, and their exercises. */
#ifndef SUBMISSIONS_H
#define SUBMISSIONS_H

#include <stdbool.h>
#include <stddef.h>

enum { SUBMISSIONS_BYTES = 1 << 20 }; /* most bytes of a student's file */

/* A file that may be a student's answer to an exercise. */
struct answer {
    char *path;        /* path below the folder of submissions */
    char exercise[4];  /* "01a" */
    int rank;          /* the lowest is best: place, then name */
    long long attempt; /* larger: handed in later */
};

/* The files of one student. */
struct submission {
    char *entry;                 /* name of file or folder; "." if none */
    char *name;                  /* name of the student (see marks_text) */
    char *notes;                 /* lines: files not graded, and why */
    size_t noted, count, others; /* numbers of notes, answers, others */
    long long attempt;           /* attempt of the file being read */
    bool canvas;                 /* Canvas has named that file */
    struct answer *answers;
};

/* All submissions. No file that may be somebody's work is skipped silently:
   it is graded, or a note tells the lecturer why not. Otherwise an archive
   that nobody unpacked, a file 01a.txt, or a second answer would give zero
   points without a word. */
struct submissions {
    struct submission *list; /* students, in order of entry */
    size_t count;
    struct submission nobody; /* notes on files of no student */
};

/* Finds the submissions in a folder: folders of students, or files whose
   names begin with the students', or the files of one student. usual: the
   names of all exercises' files, "01a-collide.c", ended by NULL. start: the
   beginning of the names of the students wanted, "" for all. Exits with
   status 2 when the folder cannot be read or has no submission. */
struct submissions submissions_find(const char *folder,
                                    const char *const usual[],
                                    const char *start);

/* Reads a student's answer to the exercise whose file is called `usual'.
   Returns its bytes and their number, or NULL. *file is the path that was
   chosen, or "no file"; *note is a remark for the lecturer, or empty. The
   caller frees all three. */
char *submissions_read(const char *folder, const struct submission *s,
                       const char *usual, size_t *length, char **file,
                       char **note);

/* Reads the file of this name ("P1.gp", "P1.txt") in the best place.
   Returns its bytes as submissions_read does, or NULL. *refusal is NULL or
   the reason why such a file was not read. The caller frees both. */
char *submissions_page(const char *folder, const struct submission *s,
                       const char *name, size_t *length, char **refusal);

#endif
