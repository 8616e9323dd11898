/* Writes the marks of a course as reports for people and platforms. */
#ifndef PUBLISH_H
#define PUBLISH_H

#include "examiner/marks.h"

#include <stddef.h>

/* The marks of a course, sorted by student and then by exercise, with at
   least one student. An exercise has all its tests even if it was not
   handed in, since the points possible must be the same for all students.
   It has no tests only if the grader itself failed. Its `file` then says
   why, and no report shows the exercise as zero points. */
struct course {
    size_t students, exercises;
    const struct marks *marks; /* [s * exercises + e]: marks of
                                  student s in exercise e */
    const char *const *notes;  /* [s]: notes on files of student s;
                                  [students]: on files of no student */
    const char *name;          /* name of the submissions' folder */
    const char *isolation;     /* how programs are isolated */
    const char *when;          /* time of grading, 2026-10-05T09:30:00Z */
};

/* publish_names is a list of the reports that may be asked for,
   "gradescope, ..."; publish_known returns whether a name is in it. The
   reports for people (table, csv, notes) are always written. */
extern const char publish_names[];
bool publish_known(const char *report);

/* Writes a report: table to standard output; csv to FOLDER/grades.csv;
   notes, if there are any, to FOLDER/by-hand/notes.txt; junit to
   FOLDER/junit.xml; gradescope, classroom50 and github to
   FOLDER/gradescope/STUDENT.json, ... In STUDENT, a character that should
   not be in a file name becomes %XX. A file is written whole or not at all.
   Exits with status 2 if it cannot be written. JSON is written by jansson
   and XML by libxml2, since printf would not escape unusual names. */
void publish(const char *report, const struct course *course,
             const char *folder);

#endif
