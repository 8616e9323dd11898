/* What the suites of whole programs have in common. */
#ifndef PROJECT_H
#define PROJECT_H

#include "examiner/check.h"
#include "examiner/run.h"

/* check_draw, to four digits, moved on with the year of a course: so its
   numbers are those of the year, and the grader's are drawn with his seed
   as well. */
double project_draw(int year, double low, double high);

/* Whether the program has ended well, with so many rows and so many numbers
   in each; what a row is made of is asked of who has other ones. */
bool project_form(const struct run *run, const char *input, size_t rows,
                  size_t columns, const char *question);

/* Whether it refuses this input with status 2 and a line of complaint. */
bool project_refuses(const struct run_order *order, const char *what);

/* The number behind the words, NAN if there is none; then the question of
   the check is another. */
double project_remark(const struct run *run, const char *words,
                      const char **question);

/* What is left of x when it is printed so. */
double project_cut(const char *format, double x);

/* Where a path of x'' = a(x) with n places x and n velocities v is after
   the time t, but for rounding, if each of so many parts of it bends
   little. */
typedef void project_pull(const void *of, const long double x[],
                          long double a[]);
enum { PROJECT_PLACES = 16 };
void project_exactly(project_pull *pull, const void *of, int n,
                     long double x[], long double v[], double t, int parts);

/* Adds a mistake to a check. */
void project_mistake(struct check *check, const char *name, double value,
                     const char *hint);

#endif
