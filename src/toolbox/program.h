/* Opens and closes the outputs of a program, and ends programs early. */
#ifndef TOOLBOX_PROGRAM_H
#define TOOLBOX_PROGRAM_H

#include "toolbox/options.h"
#include "toolbox/table.h"

#include <stdbool.h>

/* Calls options_fail if output (NULL: standard output) and summary are the
   same path, unless both are /dev/null. The message calls the output
   `name', such as "table". */
void program_apart(struct options *o, const char *output,
                   const char *summary, const char *name);

/* Opens a table like table_open, under the program's name from
   options_begin. On failure ends the process with EXIT_FAILURE. */
struct table *program_table(const char *path);

/* Opens the table at output (NULL: standard output) and the summary with
   these keys, and sets *out and *results. After that, a signal only asks
   the program to end (toolbox/progress.h). If the table or the summary
   cannot be opened, ends the process like program_table and leaves no empty
   file. */
void program_open(const char *output, const char *summary,
                  const struct table_key keys[], struct table **out,
                  struct table **results);

/* Closes the table. Closes the summary, too, if `whole' is true and the
   table was written. Otherwise discards the summary, because a mean over
   some of the rows would look like a mean over all. Returns the exit status
   of the program: EXIT_SUCCESS if both were written, else EXIT_FAILURE. */
int program_close(struct table *out, struct table *results, bool whole);

/* Removes the files being written and ends the process with this status.
   May be called from any function. */
_Noreturn void program_leave(int status);

/* Prints a line on standard error: the program's name, a colon, and a text
   formatted like printf. */
void program_say(const char *format, ...);

/* Print a line like program_say and end the process like program_leave.
   program_refuse exits with OPTIONS_FAILURE, for a wrong command or input.
   program_give_up exits with EXIT_FAILURE, for a run that has failed. */
_Noreturn void program_refuse(const char *format, ...);
_Noreturn void program_give_up(const char *format, ...);

/* If `wrong' is not NULL, prints it and ends the process like
   program_give_up. Use this for functions that return NULL or the reason
   for their failure. */
void program_check(const char *wrong);

/* If `got' is false, ends the process with the message "no memory". `what'
   completes the message, for example "for the disks", and may be NULL. */
void program_memory(bool got, const char *what);

#endif
