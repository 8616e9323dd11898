/* Analyses columns of a table: moments, errors, histograms and laws. */
#include "line/laws.h"
#include "line/statistics.h"
#include "toolbox/bench.h"
#include "toolbox/program.h"

#include <ctype.h>
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "histogram"

enum { MOST_COLUMNS = 1024, NAME_LENGTH = 32 };

enum kind { HISTOGRAM, COLUMNS, BLOCKS, CORRELATION, COST };

static struct {
    const char *columns, *against, *file, *output, *summary_path, *command;
    enum kind kind;
    uint64_t bins, skip; /* bins: 0 to choose from the data */
    bool fit, block;
    double range[MOST_COLUMNS][2];
    struct law law[MOST_COLUMNS];
    size_t ranges, laws; /* 0, 1 (for all columns), or one per column */
    struct table *out, *summary;
} given = {.columns = "all", .summary_path = "/dev/null"};

struct column {
    size_t number; /* column number in the file, from 1 */
    char name[NAME_LENGTH], unit[NAME_LENGTH];
    double *x;
    struct statistics_description d;
};

/* The requested columns of the table. Other columns are not stored, because
   a table may have a million rows. */
struct columns {
    size_t count, rows, capacity, last; /* last: largest column number */
    struct column column[MOST_COLUMNS];
    bool against;  /* the last column is that of --against */
    uint64_t line; /* line number for messages, or 0 */
    uint64_t seed;
    char *made_by; /* command from the head of the file, or NULL */
};

/* Prints an error in the input and ends the program. The message starts
   with FILE:LINE, which editors recognise. */
static _Noreturn void bad_input(const struct columns *c, const char *format,
                                ...)
{
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, PROGRAM ": %s:", given.file);
    if (c->line > 0)
        fprintf(stderr, "%llu:", (unsigned long long)c->line);
    fprintf(stderr, " ");
    vfprintf(stderr, format, arguments);
    fprintf(stderr, "\n");
    va_end(arguments);
    program_leave(OPTIONS_FAILURE);
}

static void memory_or_exit(const struct columns *c, bool got)
{
    if (!got)
        bad_input(c, "no memory for %zu rows", c->rows);
}

struct head {
    struct {
        char name[NAME_LENGTH], unit[NAME_LENGTH];
    } column[MOST_COLUMNS];
};

/* Reads "# 3 x1 [m] ...", "# command: ..." or "# seed: ...". Other lines
   are comments. Command and seed are copied to the output, so a histogram
   shows the origin of its samples. */
static void read_head(struct head *h, struct columns *c, const char *text)
{
    char name[NAME_LENGTH], unit[NAME_LENGTH];
    size_t number;
    unsigned long long seed;
    if (sscanf(text, "# %zu %31s [%31[^]]]", &number, name, unit) == 3 &&
        number >= 1 && number <= MOST_COLUMNS) {
        strcpy(h->column[number - 1].name, name);
        strcpy(h->column[number - 1].unit, unit);
    } else if (sscanf(text, "# seed: %llu", &seed) == 1)
        c->seed = seed;
    else if (strncmp(text, "# command: ", 11) == 0 && !c->made_by)
        c->made_by = strdup(text + 11);
}

/* Returns whether a character separates fields. Files from Windows have
   '\r' at the end of each line. */
static bool is_blank(char letter)
{
    return letter == ' ' || letter == '\t' || letter == '\n' ||
           letter == '\r';
}

/* Returns the next field, or the end of the row. Rows are never copied: a
   field is a pointer into its row. */
static const char *next_field(const char *text)
{
    while (*text && !is_blank(*text))
        ++text;
    while (is_blank(*text))
        ++text;
    return text;
}

/* Returns the number of the column that `name` denotes up to its first
   comma: either a number, as in gnuplot, or a name from the head. A name
   may begin with a digit, so only an entry that consists of digits is a
   number. */
static size_t find_column(struct columns *c, const struct head *h,
                          const char *name, size_t fields)
{
    const size_t length = strcspn(name, ",");
    char *end;
    const unsigned long long number = strtoull(name, &end, 10);
    if (isdigit((unsigned char)*name) && end == name + length) {
        if (number < 1 || number > fields)
            bad_input(c, "no column %llu: the row has %zu", number, fields);
        return number;
    }
    for (size_t k = 0; k < MOST_COLUMNS; ++k)
        if (length > 0 && strlen(h->column[k].name) == length &&
            strncmp(h->column[k].name, name, length) == 0)
            return k + 1;
    bad_input(c, "no column '%.*s' is named in the lines above",
              (int)length, name);
}

/* Adds a column. Keys of the summary need a name, so a column without a
   name is named after its number, such as c3. */
static void add_column(struct columns *c, const struct head *h,
                       size_t number)
{
    struct column *new = &c->column[c->count];
    if (c->count == MOST_COLUMNS || number > MOST_COLUMNS)
        bad_input(c, "more than %d columns", MOST_COLUMNS);
    new->number = number;
    strcpy(new->name, h->column[number - 1].name);
    strcpy(new->unit, h->column[number - 1].unit);
    if (!*new->name)
        snprintf(new->name, sizeof new->name, "c%zu", number);
    if (!*new->unit)
        strcpy(new->unit, "1");
    c->last = number > c->last ? number : c->last;
    ++c->count;
}

/* Chooses the columns. Called at the first row, which determines their
   number. The column of --against comes last. A single law or range applies
   to all columns, and several apply to one column each. */
static void choose_columns(struct columns *c, const struct head *h,
                           const char *row)
{
    const char *rest = given.columns;
    size_t fields = 0;
    for (; *row; row = next_field(row))
        ++fields;
    if (strcmp(rest, "all") == 0)
        for (size_t k = 1; k <= fields; ++k)
            add_column(c, h, k);
    else
        for (; *rest; rest += strcspn(rest, ",") + (strchr(rest, ',') != 0))
            add_column(c, h, find_column(c, h, rest, fields));
    if (given.against)
        add_column(c, h, find_column(c, h, given.against, fields));
    c->against = given.against != NULL;
    const size_t wanted = c->count - c->against;
    if (given.laws > 1 && given.laws != wanted)
        bad_input(c, "%zu laws for %zu columns", given.laws, wanted);
    if (given.ranges > 1 && given.ranges != wanted)
        bad_input(c, "%zu ranges for %zu columns", given.ranges, wanted);
}

/* Makes space for another row. Doubles the memory each time, so that each
   number is copied less than twice on average. */
static void grow_columns(struct columns *c)
{
    if (c->rows < c->capacity)
        return;
    c->capacity = c->capacity ? 2 * c->capacity : 1024;
    for (size_t i = 0; i < c->count; ++i) {
        double *x =
            realloc(c->column[i].x, c->capacity * sizeof c->column[i].x[0]);
        if (!x)
            bad_input(c, "no memory for %zu rows", c->capacity);
        c->column[i].x = x;
    }
}

/* Reads a field that must be a finite number. strtod alone would accept nan
   and inf and would ignore the letters in 1.5abc. One NaN in a million rows
   would make every mean NaN. */
static double read_number(struct columns *c, const struct column *column,
                          const char *text)
{
    char *end;
    const double value = strtod(text, &end);
    const size_t length = strcspn(text, " \t\r\n");
    if (end != text + length)
        bad_input(c, "column %zu (%s) is '%.*s', not a number",
                  column->number, column->name, (int)length, text);
    if (!isfinite(value))
        bad_input(c, "column %zu (%s) is '%.*s', not a finite number",
                  column->number, column->name, (int)length, text);
    return value;
}

/* Stores a row. Only the requested columns must be numbers. Other columns
   may contain text. */
static void take_row(struct columns *c, const char *text)
{
    const char *field[MOST_COLUMNS];
    size_t fields = 0;
    for (; *text && fields < c->last; text = next_field(text))
        field[fields++] = text;
    if (fields < c->last)
        bad_input(c, "%zu columns, where column %zu is wanted", fields,
                  c->last);
    grow_columns(c);
    for (size_t i = 0; i < c->count; ++i) {
        struct column *column = &c->column[i];
        column->x[c->rows] =
            read_number(c, column, field[column->number - 1]);
    }
    ++c->rows;
}

/* Reads the columns of the table. A standard deviation needs at least two
   rows. */
static void read_table(struct columns *c)
{
    FILE *file =
        strcmp(given.file, "-") == 0 ? stdin : fopen(given.file, "r");
    struct head head = {0};
    char *line = NULL;
    size_t size = 0;
    if (!file)
        bad_input(c, "%s", strerror(errno));
    for (c->line = 1; getline(&line, &size, file) >= 0; ++c->line) {
        const char *text = is_blank(*line) ? next_field(line) : line;
        if (*text == '#')
            read_head(&head, c, text);
        else if (*text && given.skip > 0)
            --given.skip;
        else if (*text) {
            if (c->count == 0)
                choose_columns(c, &head, text);
            take_row(c, text);
        }
    }
    c->line = 0; /* no line is being read */
    if (ferror(file))
        bad_input(c, "%s", strerror(errno));
    if (file != stdin)
        fclose(file);
    free(line);
    if (c->rows < 2)
        bad_input(c, "%zu rows of numbers, where 2 are the least", c->rows);
}

static const char *const kind_names[] = {"histogram",   "columns", "blocks",
                                         "correlation", "cost",    NULL};

static const struct options_entry entries[] = {
    {"column", 'c', "N,NAME,..", "which columns; all by default"},
    {"table", 't', "NAME",
     "what to write: histogram, columns (a row for each),\n"
     "blocks, correlation (against length and lag) or\n"
     "cost (histogram)"},
    {"law", 'l', "LAW",
     "hold the samples against normal[:mean,sd],\n"
     "microcanonical:n[,E,m], beta:k,n[,low,high] or\n"
     "maxwell:kT[,m[,d]]; several serve the columns in turn"},
    {"block", 'b', NULL, "errors for samples that are not independent"},
    {"against", 'a', "COLUMN", "are the columns independent of this one?"},
    {"skip", 'k', "ROWS", "leave out the first rows (0)"},
    {OPTIONS_OUTPUT("table")},
    {OPTIONS_SUMMARY},
    {"", 0, "FILE", "a table of numbers; - is standard input"},
    {"", 0, NULL, "--table histogram"},
    {"bins", 'B', "B", "as many bins; by default what suits the samples"},
    {"range", 'r', "a,b",
     "bins from a to b, not from least to greatest;\n"
     "several serve the columns in turn"},
    {"fit", 'f', "gaussian", "fit a Gaussian to the histogram"},
    {0}};

static const struct table_key keys[] = {
    {"samples", "1", "rows that count"},
    {"columns", "1", "described"},
    {"mean_error_<column>", "its own", "standard error of the mean"},
    {"mean_naive_<column>", "its own", "the same for independent samples"},
    {"sd_error_<column>", "its own", "standard error of sd"},
    {"kurtosis_error_<column>", "1", "standard error of kurtosis"},
    {"least_<column>", "its own", "sample"},
    {"greatest_<column>", "its own", "sample"},
    {"effective_<column>", "1", "independent samples that they are worth"},
    {"plateau_<column>", "1", "0: the errors are lower bounds"},
    {"inefficiency_<column>", "1", "samples to one independent one"},
    {"kurtosis_<column>", "1", "3 for a Gaussian"},
    {"mean_<column>", "its own", "of the samples"},
    {"sd_<column>", "its own", "standard deviation"},
    {"block_<column>", "1", "samples in the longest block"},
    {"", "", "if --table histogram:"},
    {"bins_<column>", "1", "of the histogram"},
    {"outside_<column>", "1", "samples beyond the bins"},
    {"", "", "if --fit, and a Gaussian fits:"},
    {"fit_mean_error_<column>", "its own", "standard error"},
    {"fit_sd_error_<column>", "its own", "standard error"},
    {"fit_mean_<column>", "its own", "of the Gaussian"},
    {"fit_sd_<column>", "its own", "the same"},
    {"fit_chi2_<column>", "1", "of the bins"},
    {"fit_degrees_<column>", "1", "of freedom"},
    {"", "", "if --law:"},
    {"law_fitted_<column>", "1", "parameters taken from the samples"},
    {"law_mean_<column>", "its own", "of the law"},
    {"law_sd_<column>", "its own", "the same"},
    {"law_chi2_probability_<column>", "1", "of as bad a chi2"},
    {"law_chi2_<column>", "1", "of the samples against it"},
    {"law_degrees_<column>", "1", "of freedom"},
    {"", "", "if no parameter is fitted, too:"},
    {"law_distance_probability_<column>", "1", "of as long a distance"},
    {"law_distance_<column>", "1", "Kolmogorov's"},
    {"mean_z_<column>", "1", "(mean - law_mean)/mean_error"},
    {"sd_z_<column>", "1", "(sd - law_sd)/sd_error"},
    {"", "", "if --against:"},
    {"correlation_error_<column>", "1", "standard error"},
    {"correlation_<column>", "1", "of the two"},
    {"against_chi2_<column>", "1", "for independence"},
    {"against_degrees_<column>", "1", "of freedom"},
    {"against_probability_<column>", "1", "of as bad a chi2"},
    {"", "", "if --table blocks:"},
    {"block_inefficiency_<column>", "1", "samples to one independent one"},
    {"block_length_<column>", "1", "samples in the chosen block"},
    {"block_error_<column>", "its own", "of the mean"},
    {"block_naive_<column>", "its own", "the same for independent samples"},
    {"block_<what>2_<column>", "its own^2", "the same of the variance"},
    {"", "", "if --table correlation:"},
    {"window_<column>", "1", "longest lag that is summed"},
    {"sum_inefficiency_<column>", "1", "samples to one independent one"},
    {"sum_uncertainty_<column>", "1", "its standard error"},
    {"window2_<column>", "1", "of the variance"},
    {"sum_<what>2_<column>", "1", "the same of the variance"},
    {"sum_settled_<column>", "1", "0: no window was long enough"},
    {0}};

static void read_range(struct options *o)
{
    if (given.ranges == MOST_COLUMNS)
        options_fail(o, "more than %d ranges", MOST_COLUMNS);
    double *ends = given.range[given.ranges++];
    if (options_list(o, ends, 2) != 2 || !(ends[0] < ends[1]) ||
        !isfinite(ends[1] - ends[0]))
        options_fail(o, "'%s' is not two numbers, the smaller one first",
                     options_text(o));
}

static void read_law(struct options *o)
{
    if (given.laws == MOST_COLUMNS)
        options_fail(o, "more than %d laws", MOST_COLUMNS);
    const char *wanted =
        laws_read(options_text(o), &given.law[given.laws++]);
    if (wanted)
        options_fail(o, "'%s' is not %s", options_text(o), wanted);
}

static void read_settings(int argc, char *argv[])
{
    struct options o;
    int option;
    options_begin(&o, PROGRAM,
                  "Histograms of the columns of a table, with errors.",
                  entries, argc, argv);
    options_keys(&o, keys);
    while ((option = options_next(&o)) != -1)
        switch (option) {
        case 'c': given.columns = options_text(&o); break;
        case 't':
            given.kind = (enum kind)options_choice(&o, kind_names);
            break;
        case 'B': given.bins = options_count(&o, 1, 1000000); break;
        case 'r': read_range(&o); break;
        case 'f':
            options_choice(&o, (const char *const[]){"gaussian", NULL});
            given.fit = true;
            break;
        case 'l': read_law(&o); break;
        case 'b': given.block = true; break;
        case 'a': given.against = options_text(&o); break;
        case 'k': given.skip = options_count(&o, 0, UINT64_MAX); break;
        case 'o': given.output = options_text(&o); break;
        case 'S': given.summary_path = options_text(&o); break;
        case OPTIONS_ARGUMENT:
            given.file = options_only(&o, given.file, "file");
            break;
        }
    given.command = options_command(&o);
    if (!given.file)
        options_fail(&o, "a FILE is needed; - is standard input");
    program_apart(&o, given.output, given.summary_path, "table");
}

struct bins {
    double low, high;
    size_t count;
};

/* Returns the bins of a column. Without --range they extend from the least
   to the greatest sample. Without --bins their number follows from (3.19,
   eq:width). */
static struct bins choose_bins(size_t i,
                               const struct statistics_description *d)
{
    const double *range = given.range[given.ranges > 1 ? i : 0];
    struct bins b = {given.ranges > 0 ? range[0] : d->least,
                     given.ranges > 0 ? range[1] : d->greatest, given.bins};
    if (b.low == b.high) { /* all samples are equal */
        /* The half width is large enough that a thousand bin edges are
           distinct as doubles. */
        const double half = fmax(0.5, fabs(b.low) * 0x1p-40);
        b.low -= half;
        b.high += half;
    }
    if (b.count == 0)
        b.count = statistics_bins(d->n, b.low, b.high, d->sd);
    return b;
}

/* Ends the program if a column does not allow the requested table. All
   columns are checked before any output, so no incomplete table is left. */
static void refuse_column(const struct columns *c,
                          const struct column *column)
{
    const struct statistics_description *d = &column->d;
    const double square = d->sd * d->sd;
    if (!isfinite(d->greatest - d->least))
        bad_input(c,
                  "%s reaches from %g to %g, expected a range that is less "
                  "than %g",
                  column->name, d->least, d->greatest, DBL_MAX);
    /* The error of the variance may be 1e15 times smaller or larger than
       the variance. It must neither underflow nor overflow. */
    if ((given.kind == BLOCKS || given.kind == COST) && d->sd > 0 &&
        !(square > DBL_MIN * 1e15 && square < DBL_MAX / 1e15))
        bad_input(c,
                  "%s has a standard deviation of %g, expected one whose "
                  "square has an error that is a number",
                  column->name, d->sd);
    if (c->against && !(d->sd > 0))
        bad_input(c,
                  "%s is the same in all rows, expected two columns "
                  "that change",
                  column->name);
}

/* Computes the description of a column. Ends the program in three cases:
   the column does not allow the requested table; a law would take a
   standard deviation of 0 or infinity from it; or its bins would be so
   narrow that the density exceeds the largest double. */
static void describe(struct columns *c, size_t i)
{
    struct column *column = &c->column[i];
    const bool own = !(c->against && i + 1 == c->count);
    memory_or_exit(c, statistics_describe(c->rows, column->x, given.block,
                                          &column->d));
    refuse_column(c, column);
    if (given.laws > 0 && own) {
        struct law law = given.law[given.laws > 1 ? i : 0];
        laws_complete(&law, column->d.mean, column->d.sd);
        if (!(laws_sd(&law) > 0 && isfinite(laws_sd(&law))))
            bad_input(c, "%s: no law has its standard deviation, %g",
                      column->name, column->d.sd);
    }
    if (given.kind == HISTOGRAM && own) {
        const struct bins b = choose_bins(i, &column->d);
        const double width = (b.high - b.low) / (double)b.count;
        if (!isfinite(1 / width))
            bad_input(
                c,
                "%s would have %zu bins from %g to %g, so narrow that no "
                "number holds a density",
                column->name, b.count, b.low, b.high);
    }
}

/* Writes a row with nine digits. These suffice for estimates that are
   uncertain in the third digit, and they hide the last bits of exp and log,
   which differ between C libraries. */
static void print_row(struct table *out, size_t n, const double row[])
{
    for (size_t i = 0; i < n; ++i)
        table_print(out, "%s%.9g", i ? " " : "", row[i]);
    table_print(out, "\n");
}

/* Compares a column with its law. If the law took parameters from the
   column, omits results that would then be meaningless: Kolmogorov's
   distance, and the deviations of mean and standard deviation in units of
   their errors (3.13, eq:zscore). */
static void test_law(const struct columns *c, size_t i,
                     const struct statistics_description *d)
{
    const struct column *column = &c->column[i];
    struct law completed = given.law[given.laws > 1 ? i : 0];
    struct law_test t;
    const size_t fitted = laws_complete(&completed, d->mean, d->sd);
    memory_or_exit(c, laws_test(&completed, d->n, column->x,
                                d->inefficiency, d->block, fitted, &t));
    table_print(given.out, "#   law: mean %.4g, sd %.4g\n#   ",
                laws_mean(&completed), laws_sd(&completed));
    if (!fitted)
        table_print(given.out, "distance %.3g (P %.2g), ", t.distance,
                    t.distance_probability);
    table_print(given.out, "chi2 %.4g of %.3g (P %.2g)\n", t.chi2,
                t.degrees, t.chi2_probability);
    if (!d->plateau)
        table_print(given.out,
                    "#   blocks of %zu still remember: believe no P\n",
                    d->block);
    TABLE_RESULTS_OF(
        given.summary, column->name, {"law_mean", laws_mean(&completed)},
        {"law_sd", laws_sd(&completed)}, {"law_fitted", (double)fitted});
    if (!fitted)
        TABLE_RESULTS_OF(
            given.summary, column->name, {"law_distance", t.distance},
            {"law_distance_probability", t.distance_probability},
            {"mean_z", (d->mean - laws_mean(&completed)) / d->mean_error},
            {"sd_z", (d->sd - laws_sd(&completed)) / d->sd_error});
    TABLE_RESULTS_OF(given.summary, column->name, {"law_chi2", t.chi2},
                     {"law_degrees", t.degrees},
                     {"law_chi2_probability", t.chi2_probability});
}

enum { CELLS = 5 }; /* cells along each axis */

/* Tests by chi-square of a contingency table whether a column is
   independent of the column of --against. The samples may be correlated in
   time, so chi-square is divided by the larger of the statistical
   inefficiencies of the two columns. */
static void compare(const struct columns *c, size_t i,
                    const struct statistics_description *d)
{
    const struct column *column = &c->column[i];
    const struct column *other = &c->column[c->count - 1];
    struct statistics_dependence t;
    memory_or_exit(c, statistics_dependence(c->rows, column->x, other->x,
                                            CELLS, given.block, &t));
    const double g = fmax(d->inefficiency, other->d.inefficiency);
    const double chi2 = t.chi2 / g;
    const double probability = laws_chi2(chi2, (double)t.degrees);
    table_print(given.out,
                "#   against %s: correlation %.4f +- %.4f, chi2 %.4g of "
                "%zu (P %.2g)\n",
                other->name, t.correlation, t.error, chi2, t.degrees,
                probability);
    TABLE_RESULTS_OF(given.summary, column->name,
                     {"correlation", t.correlation},
                     {"correlation_error", t.error}, {"against_chi2", chi2},
                     {"against_degrees", (double)t.degrees},
                     {"against_probability", probability});
}

/* Writes a row for each bin, even if no Gaussian fits. The densities of the
   law and of the fit are the probability of the bin divided by its width.
   They are not the values at its centre, which would be different in wide
   bins. Moreover, the density of the arcsine law is infinite at its
   ends. */
static void write_histogram(const struct columns *c, size_t i,
                            const struct statistics_description *d)
{
    const struct bins bins = choose_bins(i, d);
    struct statistics_histogram *h =
        statistics_histogram_create(bins.low, bins.high, bins.count);
    memory_or_exit(c, h);
    for (size_t k = 0; k < c->rows; ++k)
        statistics_histogram_add(h, c->column[i].x[k]);
    TABLE_RESULTS_OF(given.summary, c->column[i].name,
                     {"bins", (double)h->bins},
                     {"outside", (double)(h->below + h->above)});
    struct statistics_gaussian fit = {0};
    struct law law = given.law[given.laws > 1 ? i : 0];
    const bool fitted =
        given.fit && statistics_fit_gaussian(h, d->inefficiency, &fit);
    if (given.fit && !fitted)
        program_say("note: %s: no Gaussian fits its bins",
                    c->column[i].name);
    if (fitted) {
        table_print(given.out,
                    "#   fit: mean %.4g +- %.2g, sd %.4g +- %.2g; chi2 "
                    "%.4g of %zu\n",
                    fit.mean, fit.mean_error, fit.sd, fit.sd_error,
                    fit.chi2, fit.degrees);
        TABLE_RESULTS_OF(
            given.summary, c->column[i].name, {"fit_mean", fit.mean},
            {"fit_mean_error", fit.mean_error}, {"fit_sd", fit.sd},
            {"fit_sd_error", fit.sd_error}, {"fit_chi2", fit.chi2},
            {"fit_degrees", (double)fit.degrees});
    }
    const double width = (h->high - h->low) / (double)h->bins;
    if (given.laws > 0)
        laws_complete(&law, d->mean, d->sd);
    for (size_t k = 0; k < h->bins; ++k) {
        const double a = statistics_histogram_edge(h, k), b = a + width;
        double row[6] = {a + width / 2, (double)h->count[k]};
        size_t n = 4;
        row[2] = statistics_histogram_density(h, k);
        row[3] = statistics_histogram_error(h, k, d->inefficiency);
        if (given.laws > 0)
            row[n++] = (laws_below(&law, b) - laws_below(&law, a)) / width;
        if (given.fit)
            row[n++] = fitted ? statistics_gaussian_between(fit.mean,
                                                            fit.sd, a, b) /
                                    width
                              : NAN;
        print_row(given.out, n, row);
    }
    free(h);
}

/* Returns a copy of column i, divided by its statistics_unit. The caller
   must free the copy. */
static double *in_unit(const struct columns *c, size_t i)
{
    const double unit = statistics_unit(c->rows, c->column[i].x);
    double *x = malloc(c->rows * sizeof x[0]);
    memory_or_exit(c, x);
    for (size_t k = 0; k < c->rows; ++k)
        x[k] = c->column[i].x[k] / unit;
    return x;
}

/* Returns (x - mean)^2, where x is column i divided by its statistics_unit.
   For a velocity this is proportional to the kinetic energy. The caller
   must free the array. */
static double *squares_of(const struct columns *c, size_t i)
{
    double *y = in_unit(c, i);
    const double mean = statistics_moments(c->rows, y).mean;
    for (size_t k = 0; k < c->rows; ++k)
        y[k] = (y[k] - mean) * (y[k] - mean);
    return y;
}

static void write_blocks(const struct columns *c, size_t i)
{
    const double unit = statistics_unit(c->rows, c->column[i].x);
    const double square = unit * unit;
    struct statistics_blocking b, b2;
    double *y = squares_of(c, i);
    memory_or_exit(c, statistics_blocking(c->rows, c->column[i].x, &b) &&
                          statistics_blocking(c->rows, y, &b2));
    free(y);
    for (size_t k = 0; k < b.levels; ++k)
        print_row(given.out, 6,
                  (double[]){(double)b.level[k].length,
                             (double)b.level[k].blocks, b.level[k].error,
                             b.level[k].uncertainty,
                             b2.level[k].error * square,
                             b2.level[k].uncertainty * square});
    TABLE_RESULTS_OF(given.summary, c->column[i].name,
                     {"block_inefficiency", b.inefficiency},
                     {"block_inefficiency2", b2.inefficiency},
                     {"block_length", (double)b.level[b.chosen].length},
                     {"block_length2", (double)b2.level[b2.chosen].length},
                     {"block_error", b.error},
                     {"block_error2", b2.error * square},
                     {"block_naive", b.level[0].error},
                     {"block_naive2", b2.level[0].error * square});
}

/* Writes the correlations for lags up to twice the window, to show what the
   window leaves out of the sum. */
static void write_correlation(const struct columns *c, size_t i,
                              const struct statistics_description *d)
{
    double *x = in_unit(c, i), *y = squares_of(c, i);
    double g = -1, g2 = -1;
    const double mean = statistics_moments(d->n, x).mean;
    const double mean2 = statistics_moments(d->n, y).mean;
    const struct statistics_correlation a = statistics_correlation(d->n, x);
    const struct statistics_correlation b = statistics_correlation(d->n, y);
    const size_t window = a.window > b.window ? a.window : b.window;
    for (size_t lag = 0; d->sd > 0 && lag <= 2 * window && lag < d->n;
         ++lag) {
        const double rho = statistics_covariance(d->n, x, mean, lag) /
                           statistics_covariance(d->n, x, mean, 0);
        const double spread2 = statistics_covariance(d->n, y, mean2, 0);
        const double rho2 =
            spread2 > 0
                ? statistics_covariance(d->n, y, mean2, lag) / spread2
                : NAN;
        g += 2 * rho;
        g2 += 2 * rho2;
        print_row(given.out, 5, (double[]){(double)lag, rho, g, rho2, g2});
    }
    TABLE_RESULTS_OF(
        given.summary, c->column[i].name, {"window", (double)a.window},
        {"window2", (double)b.window}, {"sum_inefficiency", a.inefficiency},
        {"sum_uncertainty", a.uncertainty},
        {"sum_inefficiency2", b.inefficiency},
        {"sum_uncertainty2", b.uncertainty},
        {"sum_settled", a.settled && b.settled});
    free(x);
    free(y);
}

enum { WAYS = 3 };

static const char *const ways[WAYS] = {"naive", "blocks", "correlation"};

/* Returns the error of the mean of y by method `way` of ways[]. Sets
   *uncertainty to that method's estimate of the uncertainty of this error.
   The correlation method estimates the relative uncertainty of the
   inefficiency. That of the error is half as large, because the error is
   proportional to the square root of the inefficiency. */
static double error_by(int way, size_t n, const double y[],
                       double *uncertainty)
{
    static struct statistics_blocking b;
    if (way == 2) {
        const struct statistics_correlation c =
            statistics_correlation(n, y);
        *uncertainty = c.error * c.uncertainty / c.inefficiency / 2;
        return c.error;
    }
    if (way == 0) {
        const struct statistics_moments m = statistics_moments(n, y);
        const double error = sqrt(m.variance / (double)n);
        *uncertainty = error / sqrt(2 * (double)(n - 1));
        return error;
    }
    statistics_blocking(n, y, &b);
    *uncertainty = b.level[b.chosen].uncertainty;
    return b.error;
}

/* Measures the cost of each method of estimating an error. The first round
   fills the caches, and its times are overwritten. The methods alternate,
   so a temporary slowdown of the machine affects all of them. */
static void write_cost(const struct columns *c, size_t i,
                       const struct statistics_description *d)
{
    const double unit = statistics_unit(d->n, c->column[i].x);
    double *y = squares_of(c, i);
    double time[WAYS][BENCH_ROUNDS], error[WAYS], uncertainty[WAYS];
    for (int round = -1; round < BENCH_ROUNDS; ++round)
        for (int way = 0; way < WAYS; ++way) {
            const double start = bench_seconds();
            error[way] = error_by(way, d->n, y, &uncertainty[way]);
            time[way][round < 0 ? 0 : round] =
                (bench_seconds() - start) * 1e9 / (double)d->n;
        }
    for (int way = 0; way < WAYS; ++way)
        table_print(given.out, "%-11s %.6g %.3g %.3g\n", ways[way],
                    error[way] * unit * unit,
                    uncertainty[way] * unit * unit,
                    bench_median(time[way], BENCH_ROUNDS));
    free(y);
}

/* Writes the table head: the command and seed of the data, and the
   columns. */
static void begin_table(const struct columns *c)
{
    struct table *const out = given.out;
    const char *unit = c->column[0].unit;
    char inverse[NAME_LENGTH + 4], square[NAME_LENGTH + 4];
    snprintf(inverse, sizeof inverse, "1/(%.*s)", NAME_LENGTH, unit);
    snprintf(square, sizeof square, "(%.*s)^2", NAME_LENGTH, unit);
    table_begin(out, given.command, c->seed);
    if (c->made_by)
        table_print(out, "# data: %s", c->made_by);
    table_count(given.summary, "samples", c->rows);
    table_count(given.summary, "columns", c->count - c->against);
    switch (given.kind) {
    case HISTOGRAM:
        TABLE_COLUMNS(out, {"x", unit, "the centre of a bin"},
                      {"count", "", "samples in the bin"},
                      {"density", inverse, "count / samples / width"},
                      {"error", inverse, "of the density"});
        if (given.laws > 0)
            table_column(out, "law", inverse, "mean of the law in the bin");
        if (given.fit)
            table_column(out, "fit", inverse, "mean of the fit in the bin");
        break;
    case COLUMNS:
        TABLE_COLUMNS(
            out, {"column", "", "number in the file"},
            {"samples", "", "how many"}, {"mean", "its own", "their mean"},
            {"mean_error", "its own", "its error"},
            {"sd", "its own", "standard deviation"},
            {"sd_error", "its own", "its error"},
            {"kurtosis", "", "3 for a Gaussian"},
            {"kurtosis_error", "", "its error"},
            {"inefficiency", "", "samples to one independent one"},
            {"block", "", "samples in the longest block"},
            {"plateau", "", "0: the errors are lower bounds"});
        break;
    case BLOCKS:
        TABLE_COLUMNS(out, {"length", "", "samples in a block"},
                      {"blocks", "", "how many"},
                      {"error", unit, "of the mean of x"},
                      {"uncertainty", unit, "of that error"},
                      {"error2", square, "of the variance"},
                      {"uncertainty2", square, "of that error"});
        break;
    case CORRELATION:
        TABLE_COLUMNS(out, {"lag", "", "samples apart"},
                      {"rho", "", "correlation of x"},
                      {"g", "", "1 + 2 sum of rho up to here"},
                      {"rho2", "", "correlation of (x - mean)^2"},
                      {"g2", "", "1 + 2 sum of rho2 up to here"});
        break;
    case COST:
        bench_machine(out);
        TABLE_COLUMNS(out, {"way", "", "how the error is found"},
                      {"error", "its own", "of the variance of x"},
                      {"uncertainty", "its own", "of that error"},
                      {"time", "ns", "of the processor, a sample"});
        break;
    }
}

/* Writes the results of a column. If the errors are only lower bounds, also
   prints a note on standard error, where it will be noticed. */
static void write_column(const struct columns *c, size_t i)
{
    if (c->against && i + 1 == c->count)
        return;
    const struct statistics_description *d = &c->column[i].d;
    const struct column *column = &c->column[i];
    if (!d->plateau)
        program_say(
            "note: %s: %zu samples are too few; errors are lower bounds",
            column->name, d->n);
    const double root = sqrt((double)d->n / d->inefficiency);
    TABLE_RESULTS_OF(
        given.summary, column->name, {"mean", d->mean},
        {"mean_error", d->mean_error}, {"mean_naive", d->naive_error},
        {"sd", d->sd}, {"sd_error", d->sd_error}, {"kurtosis", d->kurtosis},
        {"kurtosis_error", d->kurtosis_error}, {"least", d->least},
        {"greatest", d->greatest}, {"inefficiency", d->inefficiency},
        {"effective", root * root}, {"block", (double)d->block},
        {"plateau", d->plateau});
    if (given.kind != COLUMNS)
        table_print(given.out, i > 0 ? "\n\n" : "");
    table_print(given.out, "# %s [%s]: mean %.4g +- %.2g, sd %.4g +- %.2g",
                column->name, column->unit, d->mean, d->mean_error, d->sd,
                d->sd_error);
    table_print(given.out, "\n#   %zu samples", d->n);
    if (given.block)
        table_print(given.out, " worth %.4g",
                    (double)d->n / d->inefficiency);
    table_print(given.out, "\n");
    if (given.laws > 0)
        test_law(c, i, d);
    if (c->against)
        compare(c, i, d);
    switch (given.kind) {
    case HISTOGRAM: write_histogram(c, i, d); break;
    case COLUMNS:
        print_row(given.out, 11,
                  (double[]){(double)column->number, (double)d->n, d->mean,
                             d->mean_error, d->sd, d->sd_error, d->kurtosis,
                             d->kurtosis_error, d->inefficiency,
                             (double)d->block, d->plateau});
        break;
    case BLOCKS: write_blocks(c, i); break;
    case CORRELATION: write_correlation(c, i, d); break;
    case COST: write_cost(c, i, d); break;
    }
}

int main(int argc, char *argv[])
{
    struct columns c = {0};
    read_settings(argc, argv);
    given.out = program_table(given.output);
    given.summary = program_table(given.summary_path);
    table_keys(given.summary, keys);
    read_table(&c);
    for (size_t i = 0; i < c.count; ++i)
        describe(&c, i);
    begin_table(&c);
    for (size_t i = 0; i < c.count; ++i)
        write_column(&c, i);
    for (size_t i = 0; i < c.count; ++i)
        free(c.column[i].x);
    free(c.made_by);
    return program_close(given.out, given.summary, true);
}
