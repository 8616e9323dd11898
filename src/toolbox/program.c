/* Opens and closes a table with its summary, and ends programs early. */
#include "toolbox/program.h"

#include "toolbox/progress.h"
#include "toolbox/replace.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void program_apart(struct options *o, const char *output,
                   const char *summary, const char *name)
{
    if (strcmp(summary, output ? output : "-") == 0 &&
        strcmp(summary, "/dev/null") != 0)
        options_fail(o, "--summary and the %s would both go to '%s'", name,
                     summary);
}

_Noreturn void program_leave(int status)
{
    replace_abandon();
    exit(status);
}

static void complain(const char *format, va_list values)
{
    fprintf(stderr, "%s: ", options_program());
    vfprintf(stderr, format, values);
    fprintf(stderr, "\n");
}

void program_say(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    complain(format, values);
    va_end(values);
}

_Noreturn void program_refuse(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    complain(format, values);
    va_end(values);
    program_leave(OPTIONS_FAILURE);
}

_Noreturn void program_give_up(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    complain(format, values);
    va_end(values);
    program_leave(EXIT_FAILURE);
}

void program_check(const char *wrong)
{
    if (wrong)
        program_give_up("%s", wrong);
}

void program_memory(bool got, const char *what)
{
    if (!got)
        program_give_up("no memory%s%s", what ? " " : "", what ? what : "");
}

struct table *program_table(const char *path)
{
    struct table *t = table_open(options_program(), path);
    if (!t)
        program_leave(EXIT_FAILURE);
    return t;
}

void program_open(const char *output, const char *summary,
                  const struct table_key keys[], struct table **out,
                  struct table **results)
{
    *out = program_table(output);
    *results = program_table(summary);
    table_keys(*results, keys);
    progress_catch_signals();
}

int program_close(struct table *out, struct table *results, bool whole)
{
    const bool written = table_close(out);
    if (whole && written)
        return table_close(results) ? EXIT_SUCCESS : EXIT_FAILURE;
    table_discard(results);
    return EXIT_FAILURE;
}
