/* Opens and closes the outputs of a program, and ends it early. */
#ifndef TOOLBOX_PROGRAM_H
#define TOOLBOX_PROGRAM_H

#include "toolbox/options.h"
#include "toolbox/table.h"

#include <stdbool.h>

/* Ends in options_fail if the summary would go where the output goes (NULL:
   standard output), since they would mix. `name` is what the message calls
   the output, as in "table". Both may go to /dev/null. */
void program_apart(struct options *o, const char *output,
                   const char *summary, const char *name);

/* Returns table_open's table, or ends the process with EXIT_FAILURE. */
struct table *program_table(const char *program, const char *path);

/* Opens the table (NULL: standard output) and the summary, which will
   have these keys, and catches signals. Ends the process if one cannot be
   opened, as program_table does, and then leaves no empty file. From here
   on a signal asks the program to end (toolbox/progress.h). */
void program_open(const char *program, const char *output,
                  const char *summary, const struct table_key keys[],
                  struct table **out, struct table **results);

/* Closes the table and, if the run was whole and the table could be
   written, the summary; else discards the summary: the rows of a run cut
   short are true, but a mean over half of them would look like one over
   all. Returns the status to exit with: EXIT_SUCCESS if both are there. */
int program_close(struct table *out, struct table *results, bool whole);

/* Removes the files being written, and ends the process with the status. It
   may be called at any depth. */
_Noreturn void program_leave(int status);

/* Prints a line on standard error, formatted as by printf, after the
   program's name and a colon. */
void program_say(const char *format, ...);

/* Print a line as program_say does, then call program_leave: program_refuse
   with OPTIONS_FAILURE, for a wrong command or input; program_give_up with
   EXIT_FAILURE, for a run that has failed. */
_Noreturn void program_refuse(const char *format, ...);
_Noreturn void program_give_up(const char *format, ...);

/* Ends the process for lack of memory unless `got` is true. `what` says
   what the memory was for, as in "for the disks", and may be NULL. */
void program_memory(bool got, const char *what);

#endif
