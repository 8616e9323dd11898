/* Finds the files that students have handed in, and their exercises. */
#ifndef SUBMISSIONS_H
#define SUBMISSIONS_H

#include <stdbool.h>
#include <stddef.h>

enum { SUBMISSIONS_BYTES = 1 << 20 }; /* limit on a student's file, bytes */

/* A file that may be a student's answer to an exercise. */
struct answer {
    char *path;        /* path below the folder of submissions */
    char exercise[4];  /* "01a" */
    int rank;          /* the lowest is best */
    long long attempt; /* larger: handed in later */
};

/* The files of one student. */
struct submission {
    char *entry;                 /* name of file or folder; "." if none */
    char *name;                  /* name of the student (see marks_text) */
    char *notes;                 /* lines: files not graded, and why */
    size_t noted, count, others; /* numbers of notes, answers, files seen */
    long long attempt;           /* attempt of the file being read */
    bool canvas;                 /* Canvas has named the file being read */
    struct answer *answers;
};

/* All submissions. Every file that may be a student's work is graded, or a
   note tells the lecturer why not. Without notes, an archive that nobody
   unpacked, a file 01a.txt, or a second answer would give zero points
   without any message. */
struct submissions {
    struct submission *list; /* students, sorted by `entry` */
    size_t count;
    struct submission nobody; /* notes on files that belong to no student */
};

/* Finds the submissions in a folder. The folder contains a folder for each
   student, or files whose names begin with the students' names, or the
   files of one student. `usual` lists the usual file names of all
   exercises, such as "01a-collide.c", and ends with NULL. Only students
   whose names begin with `start` are included; "" means all. Exits with
   status 2 if the folder cannot be read or has no submission. */
struct submissions submissions_find(const char *folder,
                                    const char *const usual[],
                                    const char *start);

/* Reads a student's answer to the exercise whose file is called `usual`.
   Returns its bytes and sets *length to their number; returns NULL if no
   file can be graded. Sets *file to the name of the file, or "no file", and
   *note to a remark for the lecturer, or "". The caller frees all three. */
char *submissions_read(const char *folder, const struct submission *s,
                       const char *usual, size_t *length, char **file,
                       char **note);

/* Reads the student's file of this name, "P1.gp" or "P1.txt", from the
   best place. Returns its bytes as submissions_read does, or NULL. Sets
   *refusal to NULL, or to the reason why a file was not read. The caller
   frees both. */
char *submissions_page(const char *folder, const struct submission *s,
                       const char *name, size_t *length, char **refusal);

#endif
