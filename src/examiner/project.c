/* From chapters/works/B-grader.nw: edit there, then run make tangle. */
/* checksum 1207659634 of the lines below */
/* The form of tables, refusals and remarks, for the suites of projects. */
#include "examiner/project.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

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

static bool ended_well(const struct run *r, const char *input)
{
    return CHECK_NEAR(r->flooded ? 1.0 : 0.0,
                      .quantity = "output beyond 16 MB", .input = input,
                      .expected = 0.0, .tolerance = 0.0,
                      .question = "How many rows were asked for?") &&
           CHECK_NEAR(r->status,
                      .quantity = "the status with which it ended",
                      .input = input, .expected = 0.0, .tolerance = 0.0,
                      .question = "What did it complain about? There is "
                                  "nothing wrong with this input.");
}

bool project_form(const struct run *r, const char *input, size_t rows,
                  size_t columns, const char *question)
{
    const char *line =
        *r->broken
            ? check_text("%s; it printed the line: %s", input, r->broken)
            : input;
    return ended_well(r, input) &&
           CHECK_NEAR(
               (double)r->rows, .quantity = "rows in the table",
               .input = line, .expected = (double)rows, .tolerance = 0.0,
               .question = *r->broken
                               ? check_text("This line is no row of "
                                            "%zu numbers, and no remark.",
                                            columns)
                               : "The contract has ROWS + 1 rows, the "
                                 "first at time 0. When is one "
                                 "printed?") &&
           CHECK_NEAR((double)r->columns, .quantity = "numbers in a row",
                      .input = line, .expected = (double)columns,
                      .tolerance = 0.0, .question = question);
}

bool project_refuses(const struct run_order *order, const char *what)
{
    const char *input = run_text(order);
    const struct run *r = run_program(order);
    return CHECK_NEAR(r->status,
                      .quantity = check_text("the status, for %s", what),
                      .input = input, .expected = 2.0, .tolerance = 0.0,
                      .question =
                          "Status 2 is for input that makes no sense. "
                          "Where do you read this, and what do you ask "
                          "of it?") &&
           CHECK_NEAR(*r->complaint != '\0',
                      .quantity =
                          check_text("lines of complaint about %s", what),
                      .input = input, .expected = 1.0, .tolerance = 0.0,
                      .question = "Who has made the mistake wants to know "
                                  "which. Is it written to stderr?");
}

double project_remark(const struct run *run, const char *words,
                      const char **question)
{
    double got = NAN;
    if (run_remark(run, words, &got, 1) == 1)
        return got;
    *question = check_text("There is no line that begins with `%s` and "
                           "goes on with a number.",
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
