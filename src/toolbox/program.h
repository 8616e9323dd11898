/* From chapters/works/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 2364020238 of the lines below */
/* What every program does around its own work: outputs and the way out. */
#ifndef TOOLBOX_PROGRAM_H
#define TOOLBOX_PROGRAM_H

#include "toolbox/options.h"
#include "toolbox/table.h"

#include <stdbool.h>

/* Ends in options_fail if the summary would go where the output goes
   (NULL: standard output), which it calls by this name, as in "table". */
void program_apart(struct options *o, const char *output,
                   const char *summary, const char *name);

/* Returns table_open's table, or ends the process with EXIT_FAILURE. */
struct table *program_table(const char *program, const char *path);

/* Opens the table (NULL: standard output) and the summary, which will
   have these keys, and catches signals. Ends the process if one cannot be
   opened, as program_table does. */
void program_open(const char *program, const char *output,
                  const char *summary, const struct table_key keys[],
                  struct table **out, struct table **results);

/* Closes the table and, if the run was whole and the table could be
   written, the summary; else gives the summary up. Returns the status to
   exit with: EXIT_SUCCESS if both are there. */
int program_close(struct table *out, struct table *results, bool whole);

/* Removes what has been written, and ends the process with the status. */
_Noreturn void program_leave(int status);

/* The same, after saying why, as printf does, after "program: ": refuse
   with OPTIONS_FAILURE, for the command or the input is wrong; give_up with
   EXIT_FAILURE, for the run has failed. */
_Noreturn void program_refuse(const char *program, const char *format, ...);
_Noreturn void program_give_up(const char *program, const char *format,
                               ...);

#endif
