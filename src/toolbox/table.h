/* Writes tables and summaries that are complete or absent. */
/* Tables are not forced to disk (fsync), because that would take time. A
   power cut soon after the renaming may therefore damage a table, but the
   program can compute the table again. */
#ifndef TOOLBOX_TABLE_H
#define TOOLBOX_TABLE_H

#include <float.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The same command and seed must give the same bytes with every compiler
   and on every machine. -Ofast may reorder sums, and the x87 unit keeps
   more digits than a double has. Both are therefore refused. */
#if !defined BONKERS_ANY_ROUNDING &&                                       \
    (defined __FAST_MATH__ || defined __ASSOCIATIVE_MATH__ ||              \
     defined __RECIPROCAL_MATH__ || FLT_EVAL_METHOD != 0)
#error "results would differ: no -Ofast, no x87; or -DBONKERS_ANY_ROUNDING"
#endif

/* A text file being written: a table of numbers, or a summary. */
struct table;

/* One key of a summary. A list of keys ends with {0} and has at most 64
   entries. A summary, with lines "key value", contains no units, so --help
   prints the units and meanings of these keys. A part of a name in angle
   brackets, as in "mean_<column>", stands for any letters. If the name is
   "", the meaning is a heading, such as "if --ensemble:". Every run writes
   all keys before the first heading. */
struct table_key {
    const char *name, *unit; /* unit "1": pure number; "word": text */
    const char *meaning;     /* a phrase; \n breaks the line */
};

/* The checksum of no bytes. */
#define TABLE_NOTHING UINT64_C(14695981039346656037)

/* Continues a checksum: returns the checksum of the bytes that have the
   checksum `sum`, followed by n more bytes. If a run continues from a file,
   the checksum shows whether the file was changed. Source: FNV-1a. */
uint64_t table_sum(uint64_t sum, const char *bytes, size_t n);

/* Sets *sum to the checksum of everything written to t so far. If t is not
   a file that can be read, sets errno and returns false. */
bool table_sum_so_far(struct table *t, uint64_t *sum);

/* Opens path for writing. NULL or "-" is standard output. Links are
   followed. A file is written under a temporary name in the same folder.
   table_close then gives it the name and the permissions of the file that
   it replaces.

   Three kinds of files are opened directly and appended to: existing files
   that are not regular (/dev/null, or a pipe, which waits for its reader),
   all files under /dev or /proc, and files that this process already has
   open for writing, for example as standard output.

   On failure prints `program' and the reason on standard error and returns
   NULL. program is not copied. At most 8 files are open at once. A second
   table on the same file is refused, unless the file is a device. The first
   call turns writing to a closed pipe into an error that table_close
   reports instead of a signal. It also makes fatal signals remove the
   temporary files. */
struct table *table_open(const char *program, const char *path);

/* Writes text like printf. Returns false if writing has ever failed. Lines
   that begin with # form the head, which is kept in memory until another
   line is written or the table is closed. If the process ends or calls
   table_discard before that, the head is not written. */
bool table_print(struct table *t, const char *format, ...);

/* Writes the first lines of the head: program and version, command (from
   options_command), seed. */
void table_begin(struct table *t, const char *command, uint64_t seed);

/* Adds a column to the head, as in "# 1 t [s] time". If unit is NULL or "",
   the column is a pure number, and its unit is written as 1. */
void table_column(struct table *t, const char *symbol, const char *unit,
                  const char *meaning);

/* The arguments of table_column. A list of labels ends with {0}. */
struct table_label {
    const char *symbol, *unit, *meaning;
};

/* Adds the columns in a list. The macro makes the list from its
   arguments. */
void table_columns(struct table *t, const struct table_label list[]);
#define TABLE_COLUMNS(t, ...)                                              \
    table_columns(t, (const struct table_label[]){__VA_ARGS__, {0}})

/* Writes a row of n values with all their digits. If columns were added, n
   must be their number. Returns false if writing has ever failed. */
bool table_row(struct table *t, size_t n, const double values[]);

/* Writes the values after t as a row, like table_row. */
#define TABLE_ROW(t, ...)                                                  \
    table_row(t, sizeof((double[]){__VA_ARGS__}) / sizeof(double),         \
              (double[]){__VA_ARGS__})

/* Sets the keys of a summary. The list is not copied. */
void table_keys(struct table *t, const struct table_key keys[]);

/* Write one line of a summary, "key value". The key must be listed. */
void table_real(struct table *t, const char *key, double value);
void table_count(struct table *t, const char *key, uint64_t value);
void table_text(struct table *t, const char *key, const char *text);

/* The arguments of table_real. A list of results ends with {0}. */
struct table_result {
    const char *key;
    double value;
};

/* Writes the results in a list. The macro makes the list from its
   arguments. */
void table_results(struct table *t, const struct table_result list[]);
#define TABLE_RESULTS(t, ...)                                              \
    table_results(t, (const struct table_result[]){__VA_ARGS__, {0}})

/* Writes the results in a list, with an underscore and `which' added to
   each key, as in mean_v4. */
void table_results_of(struct table *t, const char *which,
                      const struct table_result list[]);
#define TABLE_RESULTS_OF(t, which, ...)                                    \
    table_results_of(t, which,                                             \
                     (const struct table_result[]){__VA_ARGS__, {0}})

/* Writes a line like table_real. The key is formatted like printf and has
   at most 95 letters. */
void table_keyed(struct table *t, double value, const char *key, ...);

/* Writes the rest, gives the file its final name and frees t. Returns
   whether every byte was written. If not, prints the reason on standard
   error and removes the temporary file. An older file with the final name
   then stays as it was, unless the table was written directly to it.
   Returns true if t is NULL. A summary must have all its keys. */
bool table_close(struct table *t);

/* Removes the temporary file and frees t. Ignores NULL. */
void table_discard(struct table *t);

#endif
