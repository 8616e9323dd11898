/* Reads a command line by a list of options. */
/* A program loops over options_next with a switch; everything that can be
   wrong ends in options_fail, so it has no error to handle. */
#ifndef TOOLBOX_OPTIONS_H
#define TOOLBOX_OPTIONS_H

#include <float.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* One option. A list of them ends with {0}. An entry named "" with an
   argument stands for the arguments that are no options; without such an
   entry they are refused. An entry named "" without an argument is a
   heading: its help says when the options below it, up to the next
   heading, have an effect (NULL: always). It is one or more conditions
   with "; " between them, all of which must hold: "--study run, cost" (the
   value is one of these), "--ensemble" (it was given), "no --box", "no
   --method rk8pd". --help prints the headings, and an option whose heading
   does not hold is refused: whoever gives a run another mass and sees the
   same answer would learn something false. A default stands in parentheses
   at the end of `help`, from where conditions read it, so that the help
   cannot promise another one. */
struct options_entry {
    const char *name;     /* the long name, without the dashes */
    int letter;           /* the short name or 0, plus flags: see below */
    const char *argument; /* what --help calls its value; NULL: none */
    const char *help;     /* one phrase; \n breaks the line */
};

enum {
    OPTIONS_ARGUMENT = 1, /* the code of an argument that is no option */
    OPTIONS_LONG = 256,   /* + place in the list: an option's, no letter */
    OPTIONS_FAILURE = 2,  /* exit status after a wrong command */
    OPTIONS_MAXIMUM = 40  /* entries in a list, at most */
};

/* Flags of an option, to be added to its letter. */
enum {
    OPTIONS_SILENT = 1 << 10, /* changes no number: not in the command */
    OPTIONS_WRITES = 1 << 11  /* its value names a file to be written */
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
    const char *given[OPTIONS_MAXIMUM]; /* values, by place in the list */
    bool input[OPTIONS_MAXIMUM]; /* true: the name of a file to read */
    bool ended;
};

/* A low end for options_real that stands for "more than 0", as messages
   then say. */
#define OPTIONS_POSITIVE DBL_TRUE_MIN

/* Says what is wrong, as printf does, after "program: --option: " (after
   "program: " when no option is being read), and ends with status 2. */
_Noreturn void options_fail(struct options *o, const char *format, ...);

/* Prepares to read argv. program begins every message, purpose is the
   sentence that --help prints. --help and --version need no entries. The
   strings and the list are kept, not copied. */
void options_begin(struct options *o, const char *program,
                   const char *purpose,
                   const struct options_entry entries[], int argc,
                   char *argv[]);

/* Returns the name that options_begin was given last, for messages. */
const char *options_program(void);

/* Returns the letter of the next option, or OPTIONS_LONG + its place in
   the list if it has none, or OPTIONS_ARGUMENT, or -1 at the end. A long
   name may be cut short as long as only one option begins so. --help and
   --version print to standard output and end the process with status 0. A
   wrong option ends it with one line and status 2, and so does, at the
   end, one whose heading does not hold. */
int options_next(struct options *o);

/* Ends in options_fail if --name was given: it "means nothing", and why, as
   in "without contacts". For what no heading can know, such as whether a
   scene has contacts. */
void options_refuse(struct options *o, const char *name, const char *why);

/* Makes --help list these keys of the summary. The list is not copied. To
   be called after options_begin, or with an option that is read. */
void options_keys(struct options *o, const struct table_key *keys);

/* The command for the head of a table: the program and the options by
   their full names, without those that do not change the numbers (flag
   OPTIONS_SILENT), so that equal tables do not differ in it. NULL until
   options_next has returned -1. */
const char *options_command(const struct options *o);

/* Returns the value as a whole number from low to high. Every unsigned
   decimal notation is accepted if its value is exactly whole: 1000000, 1e6,
   2.5e3. This and the next four functions read the value of the option
   that options_next has just returned, and end in options_fail if it is not
   what is asked for. */
uint64_t options_count(struct options *o, uint64_t low, uint64_t high);

/* Returns the value as a decimal number from low to high, both included.
   -INFINITY, OPTIONS_POSITIVE and INFINITY leave an end open. Never
   infinite, never NaN. */
double options_real(struct options *o, double low, double high);

/* Returns the value as a number more than 0, at most high. */
double options_positive(struct options *o, double high);

/* Puts the value, one to max decimal numbers with commas between them, into
   values. Returns how many; whether that is the right number is for the
   program to check, with options_fail. */
size_t options_list(struct options *o, double values[], size_t max);

/* Returns which of the names, a list that ends with NULL, the value is. */
size_t options_choice(struct options *o, const char *const names[]);

/* Returns the value as it was written. */
const char *options_text(const struct options *o);

/* Returns the value as the name of a file to be read ("-": standard input).
   At the end options_next refuses an output that would replace it: after
   `histogram t.dat -o t.dat` the table would be lost silently. */
const char *options_input(struct options *o);

/* As options_input, but fails if there is one `before` already; `kind`
   names it in the message, as in "scene". */
const char *options_only(struct options *o, const char *before,
                         const char *kind);

#endif
