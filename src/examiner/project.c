/* Checks the tables, error messages and remarks of projects. */
#include "examiner/project.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

double project_draw(int year, double low, double high)
{
    const double drawn =
        check_draw_whole(0, 999999) / 1e6 + year * 0.618034;
    return project_cut("%.4g", low + (high - low) * (drawn - floor(drawn)));
}

double project_cut(const char *format, double x)
{
    char text[400];
    snprintf(text, sizeof text, format, x);
    return strtod(text, NULL);
}

void project_reads(const struct run *r, const char *hint)
{
    CHECK_NEAR(r->status, .quantity = "the status with which it ended",
               .question = "What did it complain about? There is nothing "
                           "wrong with this input.",
               .mistakes = {{hint ? "input-refused" : NULL, 2.0, hint}});
}

void project_form(const struct run *r, size_t rows, size_t columns,
                  const char *question)
{
    CHECK_NEAR(r->flooded, .quantity = "output beyond 16 MB",
               .question = "How many rows were asked for?");
    project_reads(r, NULL);
    if (*r->broken && !r->glued)
        check_about(check_text("%s; it printed the line: %s",
                               check_about(NULL), r->broken));
    CHECK_NEAR((double)r->rows, .quantity = "rows in the table",
               .expected = (double)rows,
               .question =
                   r->glued ? check_text("Columns run together in row %zu: "
                                         "found `%.*s`, "
                                         "expected a blank between any two "
                                         "of the %zu numbers.",
                                         r->rows,
                                         (int)strcspn(r->broken, " \t\r"),
                                         r->broken, columns)
                   : *r->broken ? check_text("This line is no row of "
                                             "%zu numbers, and no remark.",
                                             columns)
                                : "How many rows does the contract ask "
                                  "for, and when is one printed?");
    CHECK_NEAR((double)r->columns, .quantity = "numbers in a row",
               .expected = (double)columns, .question = question);
}

void project_refuses(const struct run_order *order, const char *what)
{
    const struct run *r = run_program(order);
    CHECK_NEAR(
        r->status, .quantity = check_text("the status, for %s", what),
        .expected = 2.0,
        .question = "Status 2 is for input that makes no sense. Where do "
                    "you read this, and what do you ask of it?");
    CHECK_NEAR(*r->complaint != '\0',
               .quantity = check_text("lines of complaint about %s", what),
               .expected = 1.0,
               .question = "Who has made the mistake wants to know which. "
                           "Is it written to stderr?");
}

enum { DEPTH = 8 };

static void leap(project_pull *pull, const void *of, int n, long double x[],
                 long double v[], long double t, int steps)
{
    long double a[PROJECT_PLACES];
    const long double h = t / steps;
    for (int k = 0; k < steps; ++k) {
        pull(of, x, a);
        for (int c = 0; c < n; ++c)
            x[c] += h * (v[c] += h / 2.0L * a[c]);
        pull(of, x, a);
        for (int c = 0; c < n; ++c)
            v[c] += h / 2.0L * a[c];
    }
}

/* Extrapolates from leapfrog runs with 1, 2, ..., 8 steps to infinitely
   many steps (Richardson). The leapfrog is symmetric, so its error contains
   only even powers of the step. The error of the result is of order 16. */
void project_exactly(project_pull *pull, const void *of, int n,
                     long double x[], long double v[], double t, int parts)
{
    long double x_of[DEPTH][PROJECT_PLACES], v_of[DEPTH][PROJECT_PLACES];
    for (int part = 0; part < parts; ++part) {
        for (int k = 0; k < DEPTH; ++k) {
            memcpy(x_of[k], x, (size_t)n * sizeof *x);
            memcpy(v_of[k], v, (size_t)n * sizeof *v);
            leap(pull, of, n, x_of[k], v_of[k], (long double)t / parts,
                 k + 1);
            for (int j = k; j-- > 0;) {
                const long double ratio = (k + 1.0L) / (j + 1.0L);
                const long double share = 1.0L / (ratio * ratio - 1.0L);
                for (int c = 0; c < n; ++c) {
                    x_of[j][c] = x_of[j + 1][c] +
                                 share * (x_of[j + 1][c] - x_of[j][c]);
                    v_of[j][c] = v_of[j + 1][c] +
                                 share * (v_of[j + 1][c] - v_of[j][c]);
                }
            }
        }
        memcpy(x, x_of[0], (size_t)n * sizeof *x);
        memcpy(v, v_of[0], (size_t)n * sizeof *v);
    }
}

double project_remark(const struct run *run, const char *words,
                      const char **question)
{
    double got = NAN;
    if (run_remark(run, words, &got, 1) == 1)
        return got;
    *question = check_text(
        "There is no line that begins with `%s` and goes on with a number.",
        words);
    return NAN;
}

void project_mistake(struct check *check, const char *name, double value,
                     const char *hint)
{
    enum { ROOM = sizeof check->mistakes / sizeof *check->mistakes };
    int n = 0;
    while (n < ROOM && check->mistakes[n].name)
        ++n;
    if (n < ROOM)
        check->mistakes[n] = (struct check_mistake){name, value, hint};
}
