/* Draws inputs, checks tables and computes trajectories for tests. */
#ifndef PROJECT_H
#define PROJECT_H

#include "examiner/check.h"
#include "examiner/run.h"

#ifndef PROJECT_YEAR
#define PROJECT_YEAR 2026
#endif

/* Returns a number between low and high, drawn as by check_draw. It depends
   on the year of the course and, in the grader, on the grader's seed. */
double project_draw(int year, double low, double high);
#define draw(low, high) project_draw(PROJECT_YEAR, low, high)

/* Draws 1 or -1. */
#define either_sign() (check_draw_whole(0, 1) ? 1.0 : -1.0)

/* Checks that the program ended with status 0. The hint is for a program
   that refused the input with status 2; it may be NULL. */
void project_reads(const struct run *run, const char *hint);

/* Checks that the program ended with status 0 and printed `rows` rows of
   `columns` numbers. If the number of columns is wrong, the report asks
   `question`. */
void project_form(const struct run *run, size_t rows, size_t columns,
                  const char *question);

/* Checks that the program refuses this input with status 2 and a line on
   standard error. `what` describes the mistake in the input. */
void project_refuses(const struct run_order *order, const char *what);

/* Returns the number that follows `words` in a remark. If there is no such
   remark, returns NAN and sets *question to a question about it. */
double project_remark(const struct run *run, const char *words,
                      const char **question);

/* Returns x after printing it in this format and reading it back. */
double project_cut(const char *format, double x);

/* Solves x'' = a(x) for n coordinates x with velocities v over the time t,
   to within rounding errors. `pull` computes a from x and `of`. The time is
   divided into `parts` intervals; in each, the trajectory must be only
   slightly curved. */
typedef void project_pull(const void *of, const long double x[],
                          long double a[]);
enum { PROJECT_PLACES = 16 };
void project_exactly(project_pull *pull, const void *of, int n,
                     long double x[], long double v[], double t, int parts);

/* Adds a known mistake to a check. */
void project_mistake(struct check *check, const char *name, double value,
                     const char *hint);

#endif
