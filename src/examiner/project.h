/* Functions for the suites of projects: inputs, tables, exact paths. */
#ifndef PROJECT_H
#define PROJECT_H

#include "examiner/check.h"
#include "examiner/run.h"

/* Draws as check_draw does, but differently for each year of a course, and
   with the grader's seed when marks are given. */
double project_draw(int year, double low, double high);

/* Checks that the program ended with status 0 and printed this many rows
   and columns. If the columns differ, the student is asked the question. */
bool project_form(const struct run *run, const char *input, size_t rows,
                  size_t columns, const char *question);

/* Checks that the program refuses this input with status 2 and a line on
   standard error. */
bool project_refuses(const struct run_order *order, const char *what);

/* Returns the number after these words in a remark. If there is none,
   returns NAN and replaces *question by one about the missing remark. */
double project_remark(const struct run *run, const char *words,
                      const char **question);

/* Returns x as it would be read after printing it in this format. */
double project_cut(const char *format, double x);

/* Solves x'' = a(x) for n coordinates x with velocities v over the time t
   to rounding; `pull` computes a from x and `of'. The time is cut into
   `parts' pieces, in each of which the path must bend little. */
typedef void project_pull(const void *of, const long double x[],
                          long double a[]);
enum { PROJECT_PLACES = 16 };
void project_exactly(project_pull *pull, const void *of, int n,
                     long double x[], long double v[], double t, int parts);

/* Adds a known mistake to a check. */
void project_mistake(struct check *check, const char *name, double value,
                     const char *hint);

#endif
