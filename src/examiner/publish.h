/* Writes the marks of a course as reports for people and platforms. */
#ifndef PUBLISH_H
#define PUBLISH_H

#include "examiner/marks.h"

#include <stddef.h>

/* The marks of a course, sorted by student, then by exercise; at least one
   student. Every exercise has all its tests, also if it was not handed in,
   since the points that can be earned must be the same for all. Only where
   the grader itself failed has an exercise no tests; its file says why,
   and every report tells that from zero points. */
struct course {
    size_t students, exercises;
    const struct marks *marks; /* of student s and exercise e at
                                  [s * exercises + e] */
    const char *const *notes;  /* on what student s has handed in, a line
                                  each; [students]: on what is nobody's */
    const char *name;          /* of the submissions' folder */
    const char *isolation;     /* how programs were isolated */
    const char *when;          /* 2026-10-05T09:30:00Z: ISO 8601, UTC */
};

/* The names of the reports that may be asked for, "gradescope, ...", and
   whether a name is one of them. The reports for people (table, csv,
   notes) are always written. */
extern const char publish_names[];
bool publish_known(const char *report);

/* Writes a report: table to standard output, csv, notes, junit to
   FOLDER/grades.csv, FOLDER/by-hand/notes.txt (if there are any),
   FOLDER/junit.xml; gradescope, classroom50 and github to
   FOLDER/gradescope/STUDENT.json, ..., with characters of a student's name
   that a file name should not have as %XX. Files are there whole or not at
   all. Exits with status 2 when it cannot. JSON is written by jansson and
   XML by libxml2, never by printf: it is easy to write what is right for
   the names one thinks of. */
void publish(const char *report, const struct course *course,
             const char *folder);

#endif
