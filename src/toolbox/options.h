/* Reads a command line according to a list of options. */
/* A program calls options_next in a loop with a switch; every mistake in
   the command ends in options_fail, so the program handles no errors. */
#ifndef TOOLBOX_OPTIONS_H
#define TOOLBOX_OPTIONS_H

#include <float.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* One option. A list of them ends with {0}. An entry named "" with an
   argument stands for the arguments that are no options; without such an
   entry they are refused. An entry named "" without an argument is a
   heading: its help says when the options below it, up to the next heading,
   have an effect (NULL: always). It is one or more conditions with "; "
   between them, all of which must hold: "--study run, cost" (the value is
   one of these), "--ensemble" (it was given), "no --box", "no --method
   rk8pd". --help prints the headings, and an option whose heading does not
   hold is refused: somebody who changes a mass and sees the same answer
   would learn something false. A default is written in parentheses at the
   end of `help`; conditions read it there, so that help and conditions
   cannot differ. */
struct options_entry {
    const char *name;     /* the long name, without the dashes */
    int letter;           /* the short name or 0, plus flags: see below */
    const char *argument; /* name of its value, or NULL if it has none */
    const char *help;     /* a phrase; \n breaks the line */
};

enum {
    OPTIONS_ARGUMENT = 1, /* the code of an argument that is no option */
    OPTIONS_LONG = 256,   /* + index: code of an option without letter */
    OPTIONS_FAILURE = 2,  /* exit status after a wrong command */
    OPTIONS_MAXIMUM = 40  /* most entries of a list */
};

/* Flags of an option, to be added to its letter. */
enum {
    OPTIONS_SILENT = 1 << 10, /* changes no result; left out of the recorded
                                 command */
    OPTIONS_WRITES = 1 << 11  /* the value names an output file */
};

/* The two outputs that most programs have. */
#define OPTIONS_WRITTEN (OPTIONS_SILENT | OPTIONS_WRITES)
#define OPTIONS_OUTPUT(what)                                               \
    "output", 'o' | OPTIONS_WRITTEN, "FILE",                               \
        "for the " what " (standard output)"
#define OPTIONS_SUMMARY                                                    \
    "summary", 'S' | OPTIONS_WRITTEN, "FILE",                              \
        "for the results as lines: key value"

/* A command line being read. The fields are private. */
struct options {
    const char *program, *purpose;
    const struct options_entry *entries, *current;
    const struct table_key *keys;
    int count;
    char **arguments;
    const char *value, *command;
    const char *given[OPTIONS_MAXIMUM]; /* values, by index in the list */
    bool input[OPTIONS_MAXIMUM];        /* values that name files to read */
    bool ended;
};

/* The lower bound for options_real that stands for "more than 0". */
#define OPTIONS_POSITIVE DBL_TRUE_MIN

/* Prints an error, formatted as by printf, after "program: --option: "
   ("program: " if no option is being read), and exits with status 2. */
_Noreturn void options_fail(struct options *o, const char *format, ...);

/* Prepares to read argv. program begins every message, purpose is the
   sentence that --help prints. --help and --version need no entries. The
   strings and the list are kept, not copied. */
void options_begin(struct options *o, const char *program,
                   const char *purpose,
                   const struct options_entry entries[], int argc,
                   char *argv[]);

/* Returns the name of the program that options_begin last received. */
const char *options_program(void);

/* Returns the letter of the next option, OPTIONS_LONG + index if it has
   none, OPTIONS_ARGUMENT for an argument that is no option, or -1 at the
   end. A long name may be shortened as long as only one option begins so.
   --help and --version print to standard output and end the process with
   status 0. A wrong option ends it with one line and status 2; so does,
   after the last option, one whose heading does not hold. */
int options_next(struct options *o);

/* Calls options_fail if --name was given, with the message that it "means
   nothing" and `why`, as in "without contacts". It is for conditions that
   no heading can state, such as whether a scene has contacts. */
void options_refuse(struct options *o, const char *name, const char *why);

/* Makes --help list these keys of the summary. The list is not copied. May
   be called once options_begin has returned. */
void options_keys(struct options *o, const struct table_key *keys);

/* Returns the command for the head of a table: the program and its options
   by their full names, without those that change no result (flag
   OPTIONS_SILENT), so that equal tables have equal heads. NULL until
   options_next has returned -1. */
const char *options_command(const struct options *o);

/* Returns the value as a whole number from low to high. Every unsigned
   decimal notation is accepted if its value is exactly whole: 1000000, 1e6,
   2.5e3. This and the next four functions read the value of the option that
   options_next has just returned, and end in options_fail if the value is
   not of their kind. */
uint64_t options_count(struct options *o, uint64_t low, uint64_t high);

/* Returns the value as a decimal number from low to high, both included.
   -INFINITY, OPTIONS_POSITIVE and INFINITY leave an end open. The number is
   never infinite or NaN. */
double options_real(struct options *o, double low, double high);

/* Returns the value as a number more than 0, at most high. */
double options_positive(struct options *o, double high);

/* Splits the value, one to max decimal numbers with commas between them,
   into values. Returns their number; the program must check whether this is
   right, and call options_fail if not. */
size_t options_list(struct options *o, double values[], size_t max);

/* Returns the index of the value in names, a list that ends with NULL. */
size_t options_choice(struct options *o, const char *const names[]);

/* Returns the value as it was written. */
const char *options_text(const struct options *o);

/* Returns the value as the name of a file to be read ("-": standard input).
   At the end options_next refuses an output that would replace this file:
   after `histogram t.dat -o t.dat` the table would be lost silently. */
const char *options_input(struct options *o);

/* Returns the value as options_input does, but calls options_fail if
   `before`, the file named earlier, is not NULL; the message calls the
   files `kind`, as in "scene". */
const char *options_only(struct options *o, const char *before,
                         const char *kind);

#endif
