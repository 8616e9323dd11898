/* Reads a command line according to a list of options. */
/* A program calls options_next in a loop with a switch. Every mistake in
   the command ends in options_fail, so the program handles no errors. */
#ifndef TOOLBOX_OPTIONS_H
#define TOOLBOX_OPTIONS_H

#include <float.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* One option. A list of options ends with {0}.

   An entry with the name "" and an argument stands for all arguments that
   are not options. Without such an entry these arguments are refused.

   An entry with the name "" and no argument is a heading. Its help says
   when the options up to the next heading have an effect (NULL: always).
   The help is one or more conditions separated by "; ", and all must hold:
   "--study run, cost" (the value is one of these), "--ensemble" (the option
   was given), "no --box", "no --method rk8pd". --help prints the headings.
   An option whose heading does not hold is refused: a user who changes a
   mass without effect and sees the same result would draw a wrong
   conclusion.

   A default is written in parentheses at the end of `help`. Conditions read
   the default there, so help and conditions cannot differ. */
struct options_entry {
    const char *name;     /* the long name, without the dashes */
    int letter;           /* the short name or 0, plus flags: see below */
    const char *argument; /* name of the value, or NULL if it has none */
    const char *help;     /* a phrase; \n breaks the line */
};

enum {
    OPTIONS_ARGUMENT = 1, /* code of an argument that is not an option */
    OPTIONS_LONG = 256,   /* + i: code of option i, if it has no letter */
    OPTIONS_FAILURE = 2,  /* exit status after a wrong command */
    OPTIONS_MAXIMUM = 40  /* largest number of entries in a list */
};

/* Flags to be added to the letter of an option. */
enum {
    OPTIONS_SILENT = 1 << 10, /* changes no result; left out of the recorded
                                 command */
    OPTIONS_WRITES = 1 << 11  /* the value names an output file */
};

/* The two output options that most programs have. */
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
    bool input[OPTIONS_MAXIMUM];        /* whether values are input files */
    bool ended;
};

/* The lower bound for options_real that means "more than 0". */
#define OPTIONS_POSITIVE DBL_TRUE_MIN

/* Prints an error message formatted like printf and exits with status 2.
   The message begins with "program: --option: ", or with "program: " if no
   option is being read. */
_Noreturn void options_fail(struct options *o, const char *format, ...);

/* Prepares to read argv. Every message begins with `program', and --help
   prints the sentence `purpose'. --help and --version need no entries. The
   strings and the list are not copied. */
void options_begin(struct options *o, const char *program,
                   const char *purpose,
                   const struct options_entry entries[], int argc,
                   char *argv[]);

/* Returns the program's name from the last call of options_begin. */
const char *options_program(void);

/* Returns the letter of the next option, OPTIONS_LONG + index if the option
   has no letter, OPTIONS_ARGUMENT for an argument that is not an option, or
   -1 at the end. A long name may be abbreviated if no other option begins
   in the same way. --help and --version print to standard output and exit
   with status 0. A wrong option prints one line and exits with status 2.
   Headings are checked after the last option. An option whose heading does
   not hold is a wrong option. */
int options_next(struct options *o);

/* Calls options_fail if the option --name was given. The message says that
   the option "means nothing" and adds `why', such as "without contacts".
   Use this for conditions that no heading can state, such as whether a
   scene has contacts. */
void options_refuse(struct options *o, const char *name, const char *why);

/* Makes --help list these keys of the summary. The list is not copied. May
   be called after options_begin. */
void options_keys(struct options *o, const struct table_key *keys);

/* Returns the command for the head of a table: the program and its options
   with their full names. Options with the flag OPTIONS_SILENT are left out,
   because equal tables must have equal heads. Returns NULL until
   options_next has returned -1. */
const char *options_command(const struct options *o);

/* Returns the value as a whole number from low to high. Accepts every
   unsigned decimal notation of a whole number: 1000000, 1e6, 2.5e3. This
   function and the next four read the value of the option that options_next
   returned last. They call options_fail if the value is not valid. */
uint64_t options_count(struct options *o, uint64_t low, uint64_t high);

/* Returns the value as a decimal number from low to high, both included.
   -INFINITY, OPTIONS_POSITIVE and INFINITY can be used as bounds. Never
   returns an infinity or a NaN. */
double options_real(struct options *o, double low, double high);

/* Returns the value as a number greater than 0 and at most high. */
double options_positive(struct options *o, double high);

/* Splits the value into one to max decimal numbers, which are separated by
   commas, and stores them in values. Returns the number of values. The
   program must check this number and call options_fail if it is wrong. */
size_t options_list(struct options *o, double values[], size_t max);

/* Returns the index of the value in names. The list names ends with
   NULL. */
size_t options_choice(struct options *o, const char *const names[]);

/* Returns the value as the user wrote it. */
const char *options_text(const struct options *o);

/* Returns the value as the name of a file to be read ("-": standard input).
   After the last option, options_next refuses an output that would replace
   this file. Without this check `histogram t.dat -o t.dat` would silently
   destroy the table t.dat. */
const char *options_input(struct options *o);

/* Like options_input, but calls options_fail if `before`, the name of an
   earlier file, is not NULL. The message calls the files `kind`, such as
   "scene". */
const char *options_only(struct options *o, const char *before,
                         const char *kind);

#endif
