/* Reads options with getopt_long, checks values, prints the help. */
#include "toolbox/options.h"

#include "toolbox/replace.h"
#include "toolbox/table.h"
#include "toolbox/version.h"

#include <assert.h>
#include <errno.h>
#include <getopt.h>
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *program_begun; /* name given to options_begin */

const char *options_program(void)
{
    return program_begun;
}

void options_fail(struct options *o, const char *format, ...)
{
    va_list arguments;
    fprintf(stderr, "%s: ", o->program);
    if (o->current && *o->current->name)
        fprintf(stderr, "--%s: ", o->current->name);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    exit(OPTIONS_FAILURE);
}

/* Prints each line of text from column 28 on. `width` characters of the
   first line have already been printed. If they reach column 28, the text
   begins on the next line. */
static void print_from(int width, const char *text)
{
    const int column = 28;
    if (width >= column)
        width = printf("\n") - 1;
    for (;; ++text) {
        const int length = (int)strcspn(text, "\n");
        printf("%*s%.*s\n", column - width, "", length, text);
        text += length;
        width = 0;
        if (*text == '\0')
            break;
    }
}

static int letter_of(const struct options_entry *e)
{
    return e->letter & 0xff;
}

static void print_entry(const struct options_entry *e)
{
    int width =
        letter_of(e) ? printf("  -%c, ", letter_of(e)) : printf("      ");
    width += printf("--%s", e->name);
    if (e->argument)
        width += printf(" %s", e->argument);
    print_from(width, e->help);
}

/* Prints a heading or, if heading is NULL and `before' is not, "always:".
   Returns heading. The caller passes the result as `before' to the next
   call. */
static const char *print_heading(const char *heading, const char *before)
{
    if (heading)
        printf("with %s:\n", heading);
    else if (before)
        printf("always:\n");
    return heading;
}

static void print_help(const struct options *o)
{
    static const struct options_entry standard[] = {
        {"help", 0, NULL, "list the options and exit"},
        {"version", 0, NULL, "name the version and exit"}};
    printf("Usage: %s [OPTION]...", o->program);
    for (const struct options_entry *e = o->entries; e->name; ++e)
        if (!*e->name && e->argument)
            printf(" %s", e->argument);
    printf("\n%s\n\n", o->purpose);
    const char *heading = NULL;
    for (const struct options_entry *e = o->entries; e->name; ++e)
        if (*e->name)
            print_entry(e);
        else if (!e->argument)
            heading = print_heading(e->help, heading);
    print_heading(NULL, heading);
    print_entry(&standard[0]);
    print_entry(&standard[1]);
    if (o->keys)
        printf("\nThe summary says:\n");
    for (const struct table_key *k = o->keys; k && k->name; ++k)
        if (*k->name)
            print_from(printf("  %s [%s]", k->name, k->unit), k->meaning);
        else
            printf("%s\n", k->meaning);
}

void options_keys(struct options *o, const struct table_key *keys)
{
    o->keys = keys;
}

/* Exits with EXIT_FAILURE if standard output cannot be written. */
static _Noreturn void print_and_exit(const struct options *o, bool help)
{
    if (help)
        print_help(o);
    else
        printf("%s (Bonkers) %s\n", o->program, TOOLBOX_VERSION);
    if (fflush(stdout) == 0 && !ferror(stdout))
        exit(EXIT_SUCCESS);
    fprintf(stderr, "%s: cannot write standard output: %s\n", o->program,
            strerror(errno));
    exit(EXIT_FAILURE);
}

/* The command for the head of a table. Static variables suffice, because a
   process has only one command line. */
static FILE *command_stream;
static char *command_text;
static size_t command_size;

static void begin_command(struct options *o)
{
    if (command_stream) {
        fclose(command_stream);
        free(command_text);
    }
    command_stream = open_memstream(&command_text, &command_size);
    if (!command_stream)
        options_fail(o, "%s", strerror(errno));
    fputs(o->program, command_stream);
}

/* Writes a value in a form that a shell reads back. Values with special
   characters are written in single quotes. A single quote becomes '\''. A
   newline becomes $'\n', because it would end the line of the head. */
static void write_quoted(FILE *stream, const char *text)
{
    static const char *const plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
        "0123456789+-_.,:/=%@";
    if (*text && text[strspn(text, plain)] == '\0') {
        fprintf(stream, " %s", text);
        return;
    }
    fputs(" '", stream);
    for (; *text; ++text) {
        if (*text == '\n')
            fputs("'$'\\n''", stream);
        else
            fprintf(stream, *text == '\'' ? "'\\''" : "%c", *text);
    }
    fputc('\'', stream);
}

static void add_to_command(struct options *o)
{
    if (o->current->letter & OPTIONS_SILENT)
        return;
    if (*o->current->name)
        fprintf(command_stream, " --%s", o->current->name);
    if (o->value)
        write_quoted(command_stream, o->value);
}

const char *options_command(const struct options *o)
{
    return o->command;
}

static const struct options_entry *named(const struct options *o,
                                         const char *name)
{
    const struct options_entry *e = o->entries;
    while (e->name && strcmp(e->name, name) != 0)
        ++e;
    assert(e->name);
    return e;
}

/* Copies the value of option e. If e was not given, copies its default,
   which is in parentheses at the end of e->help. Returns false if e has
   neither. */
static bool get_value(const struct options *o,
                      const struct options_entry *e, char value[],
                      size_t size)
{
    const char *given = o->given[e - o->entries];
    const char *open = strrchr(e->help, '(');
    const size_t length = open ? strcspn(open + 1, ")") : 0;
    const bool standard = length > 0 && strcmp(open + 1 + length, ")") == 0;
    if (given)
        snprintf(value, size, "%s", given);
    else if (standard)
        snprintf(value, size, "%.*s", (int)length, open + 1);
    return given || standard;
}

static bool is_among(const char *value, const char *list)
{
    const size_t length = strlen(value);
    for (;; list += 2) {
        const size_t n = strcspn(list, ",");
        if (n == length && strncmp(list, value, n) == 0)
            return true;
        list += n;
        if (*list == '\0')
            return false;
    }
}

/* Calls options_fail if a condition in the heading of option e does not
   hold. */
static void check_heading(struct options *o, const struct options_entry *e,
                          const char *heading)
{
    char name[32], values[128];
    const char *next;
    for (const char *c = heading; c; c = next ? next + 2 : NULL) {
        const bool no = strncmp(c, "no ", 3) == 0;
        *values = '\0';
        sscanf(c + (no ? 3 : 0), "--%31[^ ;] %127[^;]", name, values);
        next = strchr(c, ';');
        o->current = e;
        const struct options_entry *other = named(o, name);
        char value[64];
        const bool has = get_value(o, other, value, sizeof value);
        const bool among = has && is_among(value, values);
        const bool given = o->given[other - o->entries] != NULL;
        if (!*values && given == no)
            options_fail(o, "means nothing %s --%s",
                         no ? "with" : "without", name);
        if (*values && no && among)
            options_fail(o, "means nothing with --%s %s%s", name, value,
                         given ? "" : ", the default");
        /* If the other option was not given, do not quote its default as if
           the user had given it: a third option may have replaced the
           default. */
        if (*values && !no && !among && !given)
            options_fail(o, "means nothing without --%s %s", name, values);
        if (*values && !no && !among)
            options_fail(o, "means nothing with --%s %s (only with %s)",
                         name, value, values);
    }
}

/* Must be called after the last option, because a heading may depend on a
   later option. */
static void check_headings(struct options *o)
{
    const char *heading = NULL;
    for (int i = 0; o->entries[i].name; ++i) {
        const struct options_entry *e = &o->entries[i];
        if (!*e->name && !e->argument)
            heading = e->help;
        else if (o->given[i] && heading)
            check_heading(o, e, heading);
    }
    o->current = NULL;
}

void options_refuse(struct options *o, const char *name, const char *why)
{
    const struct options_entry *e = named(o, name);
    if (!o->given[e - o->entries])
        return;
    o->current = e;
    options_fail(o, "means nothing %s", why);
}

/* Refuses an output file that is also an input file, even through links. */
static void protect_inputs(struct options *o)
{
    for (int i = 0; o->entries[i].name; ++i)
        for (int j = 0; o->entries[j].name; ++j) {
            if (!o->given[i] || !(o->entries[i].letter & OPTIONS_WRITES) ||
                !o->input[j] || !replace_loses(o->given[i], o->given[j]))
                continue;
            o->current = &o->entries[i];
            options_fail(o, "'%s' is read, and would be lost", o->given[i]);
        }
}

void options_begin(struct options *o, const char *program,
                   const char *purpose,
                   const struct options_entry entries[], int argc,
                   char *argv[])
{
    *o = (struct options){.program = program, .purpose = purpose};
    program_begun = program;
    o->entries = entries;
    o->count = argc;
    o->arguments = argv;
    begin_command(o);
    optind = 1; /* restarts getopt_long: tests read several commands */
}

enum { HELP = OPTIONS_LONG + OPTIONS_MAXIMUM, VERSION };

/* Calls getopt_long for the next option. The result is OPTIONS_LONG + index
   for a long option. In `letters`, "-" makes getopt_long return arguments
   that are not options in their order, and the first ":" makes it return
   ':' for a missing value. A ":" after a letter means that the option has a
   value. opterr = 0 suppresses the messages of getopt_long. */
static int ask_getopt(struct options *o)
{
    struct option list[OPTIONS_MAXIMUM + 3] = {0}, *l = list;
    char letters[2 * OPTIONS_MAXIMUM + 3] = "-:", *c = letters + 2;
    for (int i = 0; o->entries[i].name; ++i) {
        const struct options_entry *e = &o->entries[i];
        if (!*e->name)
            continue;
        *l++ = (struct option){e->name, e->argument != NULL, NULL,
                               OPTIONS_LONG + i};
        if (letter_of(e))
            *c++ = (char)letter_of(e);
        if (letter_of(e) && e->argument)
            *c++ = ':';
    }
    *l++ = (struct option){"help", 0, NULL, HELP};
    *l++ = (struct option){"version", 0, NULL, VERSION};
    opterr = 0;
    return getopt_long(o->count, o->arguments, letters, list, NULL);
}

/* Returns the entry with this code (its letter, or OPTIONS_LONG + its
   index). OPTIONS_ARGUMENT is the code of the entry without a name. */
static const struct options_entry *find_entry(const struct options *o,
                                              int code)
{
    for (int i = 0; o->entries[i].name; ++i)
        if (*o->entries[i].name
                ? code == OPTIONS_LONG + i ||
                      code == letter_of(&o->entries[i])
                : code == OPTIONS_ARGUMENT && o->entries[i].argument)
            return &o->entries[i];
    return NULL;
}

/* The message includes the help, because the help lists the possible
   values. */
static _Noreturn void fail_without_value(struct options *o)
{
    char help[2048];
    snprintf(help, sizeof help, "%s", o->current->help);
    for (char *c = help; (c = strchr(c, '\n')); ++c)
        *c = ' ';
    options_fail(o, "needs a value, %s: %s", o->current->argument, help);
}

static void fail_if_ambiguous(struct options *o, const char *given)
{
    const char *first = NULL;
    const size_t length = strcspn(given + 2, "=");
    for (const struct options_entry *e = o->entries; e->name; ++e) {
        if (length == 0 || strncmp(e->name, given + 2, length) != 0)
            continue;
        if (first)
            options_fail(o, "'%s' may mean --%s or --%s", given, first,
                         e->name);
        first = e->name;
    }
}

/* Prints an error for an option that getopt_long has refused. code is ':'
   for a missing value and otherwise '?'. getopt_long has set optopt to the
   code of a known option or to the letter of an unknown short option, and
   otherwise to 0. */
static _Noreturn void refuse_option(struct options *o, int code)
{
    const char *given = o->arguments[optind - 1];
    if (code == ':') {
        o->current = find_entry(o, optopt);
        fail_without_value(o);
    }
    if (optopt >= OPTIONS_LONG)
        options_fail(o, "'%s': this option takes no value", given);
    if (optopt > 0)
        options_fail(o, "unknown option '-%c'; see %s --help", optopt,
                     o->program);
    fail_if_ambiguous(o, given);
    options_fail(o, "unknown option '%s'; see %s --help", given,
                 o->program);
}

/* getopt_long returns -1 at the end of the command or at "--", after which
   everything is an argument. `ended` prevents another call of getopt_long,
   which would read these arguments as options. */
int options_next(struct options *o)
{
    o->current = NULL;
    int code = o->ended ? -1 : ask_getopt(o);
    o->value = optarg;
    o->ended = o->ended || code == -1;
    if (code == -1 && optind < o->count) {
        code = OPTIONS_ARGUMENT;
        o->value = o->arguments[optind++];
    }
    if (code == HELP || code == VERSION)
        print_and_exit(o, code == HELP);
    if (code == '?' || code == ':')
        refuse_option(o, code);
    if (code == -1) {
        check_headings(o);
        protect_inputs(o);
        fflush(command_stream);
        o->command = command_text;
        return -1;
    }
    o->current = find_entry(o, code);
    if (!o->current)
        options_fail(o, "'%s' is not an option; see %s --help", o->value,
                     o->program);
    add_to_command(o);
    o->given[o->current - o->entries] = o->value ? o->value : "";
    return letter_of(o->current) ? letter_of(o->current) : code;
}

static bool is_digit(char c)
{
    return '0' <= c && c <= '9';
}

/* Reads an exponent such as e6 and adds it to *scale. Returns false unless
   the exponent is from -999 to 999. A larger exponent can only be a
   mistake or belong to the number 0, and would make the loops of
   read_count long. */
static bool read_exponent(const char *text, int *scale)
{
    char *end;
    if (*text != 'e' && *text != 'E')
        return false;
    ++text;
    if (*text != '+' && *text != '-' && !is_digit(*text))
        return false;
    const long exponent = strtol(text, &end, 10);
    if (*end != '\0' || exponent < -999 || exponent > 999)
        return false;
    *scale += (int)exponent;
    return true;
}

/* Reads a whole number exactly, as digits and a power of ten: 300e-2 is 3,
   and 1.5 is refused. atoi would read "ten" as 0 and "1e6" as 1. A double
   would round seeds above 2^53. To detect overflow: 10 n + d exceeds 2^64 -
   1 exactly if n is larger than the whole part of (2^64 - 1 - d) / 10. */
static bool read_count(const char *text, uint64_t *value)
{
    int scale = 0;
    bool digits = false, point = false;
    for (*value = 0; is_digit(*text) || (*text == '.' && !point); ++text) {
        const uint64_t digit = (uint64_t)(*text - '0');
        if (*text == '.') {
            point = true;
            continue;
        }
        if (*value > (UINT64_MAX - digit) / 10)
            return false;
        *value = 10 * *value + digit;
        scale -= point;
        digits = true;
    }
    if (!digits)
        return false;
    if (*text && !read_exponent(text, &scale))
        return false;
    for (; scale < 0; ++scale, *value /= 10)
        if (*value % 10 != 0)
            return false;
    for (; scale > 0 && *value > 0; --scale, *value *= 10)
        if (*value > UINT64_MAX / 10)
            return false;
    return true;
}

uint64_t options_count(struct options *o, uint64_t low, uint64_t high)
{
    uint64_t n;
    if (!read_count(o->value, &n) || n < low || n > high)
        options_fail(
            o, "'%s' is not a whole number from %" PRIu64 " to %" PRIu64,
            o->value, low, high);
    return n;
}

/* Reads a finite decimal number and nothing else. strtod alone would skip
   spaces, accept nan, infinity and hexadecimal numbers, and ignore letters
   after the number. */
static bool read_real(const char *text, double *value)
{
    char *end;
    if (text[strspn(text, "+-.0123456789eE")] != '\0')
        return false;
    *value = strtod(text, &end);
    return end != text && *end == '\0' && isfinite(*value);
}

double options_real(struct options *o, double low, double high)
{
    double x;
    if (read_real(o->value, &x) && low <= x && x <= high)
        return x;
    char range[80] = "";
    if (low == OPTIONS_POSITIVE && high == INFINITY)
        snprintf(range, sizeof range, " more than 0");
    else if (low == OPTIONS_POSITIVE)
        snprintf(range, sizeof range, " more than 0, at most %.15g", high);
    else if (low == -INFINITY && high < INFINITY)
        snprintf(range, sizeof range, " of at most %.15g", high);
    else if (low > -INFINITY && high == INFINITY)
        snprintf(range, sizeof range, " of at least %.15g", low);
    else if (low > -INFINITY)
        snprintf(range, sizeof range, " from %.15g to %.15g", low, high);
    options_fail(o, "'%s' is not a number%s", o->value, range);
}

double options_positive(struct options *o, double high)
{
    return options_real(o, OPTIONS_POSITIVE, high);
}

/* The error message shows the wrong item and the whole value, because a
   mistake such as "1,,2" is hard to see. */
size_t options_list(struct options *o, double values[], size_t max)
{
    char item[64];
    const char *rest = o->value;
    for (size_t n = 0; n < max; ++n, ++rest) {
        const size_t length = strcspn(rest, ",");
        snprintf(item, sizeof item, "%.*s", (int)length, rest);
        if (length >= sizeof item || !read_real(item, &values[n]))
            options_fail(o, "'%s' in '%s' is not a number", item, o->value);
        rest += length;
        if (*rest == '\0')
            return n + 1;
    }
    options_fail(o, "'%s' has more than %zu numbers", o->value, max);
}

size_t options_choice(struct options *o, const char *const names[])
{
    char list[256] = "";
    for (size_t i = 0; names[i]; ++i) {
        const char *between = names[i + 1] ? ", " : " or ";
        const size_t used = strlen(list);
        if (strcmp(o->value, names[i]) == 0)
            return i;
        snprintf(list + used, sizeof list - used, "%s%s",
                 i == 0 ? "" : between, names[i]);
    }
    options_fail(o, "'%s' is not %s", o->value, list);
}

const char *options_text(const struct options *o)
{
    return o->value;
}

const char *options_input(struct options *o)
{
    o->input[o->current - o->entries] = true;
    return o->value;
}

const char *options_only(struct options *o, const char *before,
                         const char *kind)
{
    if (before)
        options_fail(o, "'%s': there is a %s already, '%s'", o->value, kind,
                     before);
    return options_input(o);
}
