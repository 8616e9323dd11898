/* From chapters/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 1431904593 of the lines below */
/* Two outputs that are opened and closed together, and two ways to end. */
#include "toolbox/program.h"

#include "toolbox/progress.h"

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

bool program_open(const char *program, const char *output,
                  const char *summary, const struct table_key keys[],
                  struct table **out, struct table **results)
{
    *out = table_open(program, output);
    *results = *out ? table_open(program, summary) : NULL;
    if (!*results)
        return table_discard(*out), false;
    table_keys(*results, keys);
    progress_catch_signals();
    return true;
}

int program_close(struct table *out, struct table *results, bool whole)
{
    const bool written = table_close(out);
    if (whole && written)
        return table_close(results) ? EXIT_SUCCESS : EXIT_FAILURE;
    table_discard(results);
    return EXIT_FAILURE;
}

_Noreturn static void end(const char *program, const char *format,
                          va_list values, int status)
{
    fprintf(stderr, "%s: ", program);
    vfprintf(stderr, format, values);
    fprintf(stderr, "\n");
    table_abandon();
    exit(status);
}

_Noreturn void program_refuse(const char *program, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    end(program, format, values, OPTIONS_FAILURE);
}

_Noreturn void program_give_up(const char *program, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    end(program, format, values, EXIT_FAILURE);
}
