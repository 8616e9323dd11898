/* From chapters/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 1462532211 of the lines below */
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

/* Opens the table (NULL: standard output) and the summary, which will
   have these keys, and catches signals. Returns false, with nothing left
   behind, if one cannot be opened; table_open has said why. */
bool program_open(const char *program, const char *output,
                  const char *summary, const struct table_key keys[],
                  struct table **out, struct table **results);

/* Closes the table and, if the run was whole and the table could be
   written, the summary; else gives the summary up. Returns the status to
   exit with: EXIT_SUCCESS if both are there. */
int program_close(struct table *out, struct table *results, bool whole);

/* Say why, as printf does, after "program: ", remove what has been written,
   and end the process: refuse with OPTIONS_FAILURE, for the command or the
   input is wrong; give_up with EXIT_FAILURE, for the run has failed. */
_Noreturn void program_refuse(const char *program, const char *format, ...);
_Noreturn void program_give_up(const char *program, const char *format,
                               ...);

#endif
