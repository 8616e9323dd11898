/* Writes the marks of a course as reports for people and platforms. */
#ifndef PUBLISH_H
#define PUBLISH_H

#include "examiner/marks.h"

#include <stddef.h>

/* The marks of a course, sorted by student, then by exercise; at least one
   student. Every exercise has all its tests, also if it was not handed in,
   since the points that can be earned must be the same for all. An exercise
   has no tests only where the grader itself failed; then its file says why,
   and no report shows it as zero points. */
struct course {
    size_t students, exercises;
    const struct marks *marks; /* those of student s in exercise e
                                  are at [s * exercises + e] */
    const char *const *notes;  /* [s]: lines on the files of student s;
                                  [students]: on files of no student */
    const char *name;          /* name of the submissions' folder */
    const char *isolation;     /* the kind of isolation of programs */
    const char *when;          /* time of grading, 2026-10-05T09:30:00Z */
};

/* publish_names lists the reports that may be asked for, "gradescope, ...";
   publish_known returns whether a name is in it. The reports for people
   (table, csv, notes) are always written. */
extern const char publish_names[];
bool publish_known(const char *report);

/* Writes a report: table to standard output, csv, notes, junit to
   FOLDER/grades.csv, FOLDER/by-hand/notes.txt (if there are any),
   FOLDER/junit.xml; gradescope, classroom50 and github to
   FOLDER/gradescope/STUDENT.json, ..., where characters of a student's name
   that are unfit for a file's name become %XX. A file is whole or absent.
   Exits with status 2 when it cannot write. JSON is written by jansson and
   XML by libxml2, never by printf, which is right only for names one has
   thought of. */
void publish(const char *report, const struct course *course,
             const char *folder);

#endif
