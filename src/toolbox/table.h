/* Tables and summaries that are whole or absent. */
/* Tables are not forced to disk (fsync), which would cost time; so a power
   cut soon after the renaming may spoil a table. It can be made again. */
#ifndef TOOLBOX_TABLE_H
#define TOOLBOX_TABLE_H

#include <float.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The same command and seed must give the same bytes with every compiler
   and on every machine. -Ofast may reorder sums, and the x87 unit keeps
   more digits than a double has: both are refused. */
#if !defined BONKERS_ANY_ROUNDING &&                                       \
    (defined __FAST_MATH__ || defined __ASSOCIATIVE_MATH__ ||              \
     defined __RECIPROCAL_MATH__ || FLT_EVAL_METHOD != 0)
#error "results would differ: no -Ofast, no x87; or -DBONKERS_ANY_ROUNDING"
#endif

/* A text file being written: a table of numbers, or a summary. */
struct table;

/* One key of a summary. A list of at most 64 ends with {0}. A line "key
   value" has no room for a unit, so each program lists its keys, from which
   --help prints units and meanings. In a name, a part in angle brackets, as
   in "mean_<column>", stands for any letters. A name of "" makes the
   meaning a heading, such as "if --ensemble:"; every run writes all keys
   before the first heading. */
struct table_key {
    const char *name, *unit; /* "1" for a pure number, "word" for none */
    const char *meaning;     /* a phrase; \n breaks the line */
};

#define TABLE_NOTHING UINT64_C(14695981039346656037) /* sum of no bytes */

/* Returns the checksum of the bytes whose checksum is `sum`, followed by
   these n. It shows whether a file that a run continues from was changed.
   Source: FNV-1a. */
uint64_t table_sum(uint64_t sum, const char *bytes, size_t n);

/* Sets *sum to the checksum of everything written to t so far. Returns
   false, with errno set, if t is not a file that can be read. */
bool table_sum_so_far(struct table *t, uint64_t *sum);

/* Opens path for writing; NULL or "-" is standard output. A file is written
   to a temporary in the same folder, which table_close gives the name and
   the permissions of the file it replaces. A link is followed. Three kinds
   are opened as they are and appended to: an existing file that is not
   regular (/dev/null, a pipe: opening one waits for its reader), everything
   under /dev or /proc, and a file that this process was given to write
   already (standard output sent to that file). On failure prints the reason
   on standard error, after program, and returns NULL. program is kept, not
   copied. At most 8 files are open at once; a second table on the same file
   is refused, whatever its name, unless it is a device. The first call
   makes a closed pipe an error that table_close reports, instead of a
   signal, and makes signals that end the process remove the temporaries
   first. */
struct table *table_open(const char *program, const char *path);

/* Writes text as printf does. Returns false once writing has failed. Lines
   that begin with # form the head. It is kept in memory until another line
   is written or the table is closed, and is not written if the process ends
   before or calls table_discard. */
bool table_print(struct table *t, const char *format, ...);

/* Writes the head: program, version, command (from options_command),
   seed. */
void table_begin(struct table *t, const char *command, uint64_t seed);

/* Adds a column to the head, as in "# 1 t [s] time". A unit of NULL or ""
   stands for a pure number and is written as 1. */
void table_column(struct table *t, const char *symbol, const char *unit,
                  const char *meaning);

/* The arguments of table_column; a list of them ends with {0}. */
struct table_label {
    const char *symbol, *unit, *meaning;
};

/* Adds the columns of a list; the macro adds those given after t. */
void table_columns(struct table *t, const struct table_label list[]);
#define TABLE_COLUMNS(t, ...)                                              \
    table_columns(t, (const struct table_label[]){__VA_ARGS__, {0}})

/* Writes a row of n values with all their digits. n must be the number of
   columns, if any were named. Returns false once writing has failed. */
bool table_row(struct table *t, size_t n, const double values[]);

/* Writes the values given after t as a row, as table_row does. */
#define TABLE_ROW(t, ...)                                                  \
    table_row(t, sizeof((double[]){__VA_ARGS__}) / sizeof(double),         \
              (double[]){__VA_ARGS__})

/* Sets the keys that this summary will have. The list is not copied. */
void table_keys(struct table *t, const struct table_key keys[]);

/* Write one line of a summary, "key value". Require a listed key. */
void table_real(struct table *t, const char *key, double value);
void table_count(struct table *t, const char *key, uint64_t value);
void table_text(struct table *t, const char *key, const char *text);

/* The arguments of table_real; a list of them ends with {0}. */
struct table_result {
    const char *key;
    double value;
};

/* Writes the lines of a list; the macro writes those given after t. */
void table_results(struct table *t, const struct table_result list[]);
#define TABLE_RESULTS(t, ...)                                              \
    table_results(t, (const struct table_result[]){__VA_ARGS__, {0}})

/* Writes the lines of a list, with _WHICH added to each key, as in
   mean_v4. */
void table_results_of(struct table *t, const char *which,
                      const struct table_result list[]);
#define TABLE_RESULTS_OF(t, which, ...)                                    \
    table_results_of(t, which,                                             \
                     (const struct table_result[]){__VA_ARGS__, {0}})

/* Writes a line as table_real does, with a key formatted as by printf, of
   at most 95 letters. */
void table_keyed(struct table *t, double value, const char *key, ...);

/* Writes the rest, gives the file its name and frees t. Returns whether
   every byte was written; if not, prints the reason on standard error,
   removes the temporary and keeps an older file of that name as it was,
   unless it was written in place. Returns true if t is NULL. A summary must
   have all its keys. */
bool table_close(struct table *t);

/* Abandons the table: removes the temporary file and frees t. Ignores NULL.
 */
void table_discard(struct table *t);

#endif
