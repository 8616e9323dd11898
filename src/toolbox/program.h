/* Opens and closes the outputs of a program, and ends it early. */
#ifndef TOOLBOX_PROGRAM_H
#define TOOLBOX_PROGRAM_H

#include "toolbox/options.h"
#include "toolbox/table.h"

#include <stdbool.h>

/* Calls options_fail if the summary and the output (NULL: standard output)
   would go to the same place, where they would mix; both may go to
   /dev/null. The message calls the output `name`, as in "table". */
void program_apart(struct options *o, const char *output,
                   const char *summary, const char *name);

/* Returns the table from table_open, or ends the process with
   EXIT_FAILURE. */
struct table *program_table(const char *program, const char *path);

/* Opens the table (NULL: standard output) and the summary, which will have
   these keys, and catches signals: from then on a signal asks the program
   to end (toolbox/progress.h). Ends the process if one of them cannot be
   opened, as program_table does, and then leaves no empty file. */
void program_open(const char *program, const char *output,
                  const char *summary, const struct table_key keys[],
                  struct table **out, struct table **results);

/* Closes the table and, if the run was whole and the table could be
   written, the summary; otherwise discards the summary, since a mean over a
   part of the rows would look like one over all. Returns the status to exit
   with: EXIT_SUCCESS if both have been written. */
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

/* Ends the process with a message if `got` is false. `what` says what the
   memory was for, as in "for the disks", and may be NULL. */
void program_memory(bool got, const char *what);

#endif
