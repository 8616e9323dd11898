/* Writes the head, the rows and the summary of a table. */
#include "toolbox/lines.h"

#include "toolbox/digits.h"
#include "toolbox/version.h"

#include <assert.h>
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* Any call may be the first to notice a full disk, because streams are
   buffered. table_close reports the error. */
void lines_note_error(struct table *t, bool good)
{
    if (!good && t->error == 0)
        t->error = errno != 0 ? errno : EIO;
}

void lines_release_head(struct table *t)
{
    if (!t->held)
        return;
    lines_note_error(t, fclose(t->stream) == 0);
    t->stream = t->held;
    t->held = NULL;
    const size_t n = fwrite(t->head, 1, t->head_size, t->stream);
    lines_note_error(t, n == t->head_size);
    free(t->head);
    t->head = NULL;
}

enum { MOST_HEAD = 65536 }; /* bytes of a head kept in memory */

/* Returns whether text with this format belongs to the head, that is, to a
   line that begins with #, to an empty line, or to an unfinished line. */
static bool continues_head(struct table *t, const char *format)
{
    fflush(t->stream);
    if (t->head_size > MOST_HEAD)
        return false;
    return *format == '#' || *format == '\n' || *format == '\0' ||
           (t->head_size > 0 && t->head[t->head_size - 1] != '\n');
}

bool table_print(struct table *t, const char *format, ...)
{
    va_list arguments;
    if (t->held && !continues_head(t, format))
        lines_release_head(t);
    va_start(arguments, format);
    lines_note_error(t, vfprintf(t->stream, format, arguments) >= 0);
    va_end(arguments);
    return t->error == 0;
}

/* Writes 17 digits, which determine every double uniquely: near x, decimals
   with 17 digits are at most 1e-16 |x| apart, and doubles at least 1.1e-16
   |x|. So a run can be continued from its table. The sign of a NaN is
   omitted, because it means nothing and differs between compilers. */
static void print_real(struct table *t, double value)
{
    char text[DIGITS_ROOM] = "nan";
    const size_t n = isnan(value) ? 3 : digits_write(text, value);
    lines_note_error(t, fwrite(text, 1, n, t->stream) == n);
}

/* Writes no date, machine or folder, because the same command must give the
   same bytes. */
void table_begin(struct table *t, const char *command, uint64_t seed)
{
    table_print(t, "# %s (Bonkers) %s\n", t->program, TOOLBOX_VERSION);
    table_print(t, "# command: %s\n", command);
    table_print(t, "# seed: %" PRIu64 "\n", seed);
}

void table_column(struct table *t, const char *symbol, const char *unit,
                  const char *meaning)
{
    ++t->columns;
    table_print(t, "# %zu %s [%s] %s\n", t->columns, symbol,
                unit && *unit ? unit : "1", meaning);
}

void table_columns(struct table *t, const struct table_label list[])
{
    for (; list->symbol; ++list)
        table_column(t, list->symbol, list->unit, list->meaning);
}

static void put(struct table *t, char c)
{
    lines_note_error(t, putc(c, t->stream) != EOF);
}

/* Asserts the number of values, because a row with too few values would
   misalign the columns in every plot of the table. That would be a bug in
   the program, not a mistake by its user. */
bool table_row(struct table *t, size_t n, const double values[])
{
    assert(t->columns == 0 || n == t->columns);
    lines_release_head(t);
    for (size_t i = 0; i < n; ++i) {
        if (i > 0)
            put(t, ' ');
        print_real(t, values[i]);
    }
    put(t, '\n');
    return t->error == 0;
}

/* Returns whether key matches name. A part of name in angle brackets, as in
   "mean_<column>", matches one or more letters. */
static bool is_named(const char *key, const char *name)
{
    if (*name != '<')
        return *key == *name && (!*key || is_named(key + 1, name + 1));
    while (*key)
        if (is_named(++key, strchr(name, '>') + 1))
            return true;
    return false;
}

/* Writes a key and a space. --help prints the list of keys, so a program
   must write only keys from this list, and each at most once. table_close
   asserts that no key is missing. */
static void print_key(struct table *t, const char *key)
{
    uint64_t fit = 0;
    for (int k = 0; t->keys && t->keys[k].name; ++k)
        if (is_named(key, t->keys[k].name)) {
            fit |= UINT64_C(1) << k;
            assert(strcmp(key, t->keys[k].name) || !(t->written >> k & 1));
        }
    assert(fit);
    t->written |= fit;
    table_print(t, "%s ", key);
}

void table_real(struct table *t, const char *key, double value)
{
    print_key(t, key);
    print_real(t, value);
    table_print(t, "\n");
}

/* Takes an integer, because a double would round counts above 2^53. */
void table_count(struct table *t, const char *key, uint64_t value)
{
    print_key(t, key);
    table_print(t, "%" PRIu64 "\n", value);
}

void table_text(struct table *t, const char *key, const char *text)
{
    print_key(t, key);
    table_print(t, "%s\n", text);
}

void table_results(struct table *t, const struct table_result list[])
{
    for (; list->key; ++list)
        table_real(t, list->key, list->value);
}

void table_keyed(struct table *t, double value, const char *key, ...)
{
    char name[96];
    va_list parts;
    va_start(parts, key);
    vsnprintf(name, sizeof name, key, parts);
    va_end(parts);
    table_real(t, name, value);
}

void table_results_of(struct table *t, const char *which,
                      const struct table_result list[])
{
    for (; list->key; ++list)
        table_keyed(t, list->value, "%s_%s", list->key, which);
}
