/* Times the reading of numbers and scenes: plots/data/08-reading.dat. */
#include "scenes/decimal.h"
#include "scenes/scene.h"
#include "toolbox/bench.h"
#include "toolbox/program.h"
#include "toolbox/random.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGRAM "scene-speed"

/* The test numbers are between 0 and 10 and all have the same number of
   digits. They are stored WIDTH bytes apart. */
enum { NUMBERS = 20000, WIDTH = 32, MOST_DIGITS = 19 };

/* Returns the time to read one number (in s) with decimal_read if `ours`
   is true and with strtod otherwise. Counts in ways[] which algorithm
   decimal_read chose. Uses the sum, so that the compiler cannot remove the
   reading. */
static double time_numbers(char text[][WIDTH], bool ours, size_t ways[])
{
    const double start = bench_seconds();
    double sum = 0, value = 0;
    for (size_t i = 0; i < NUMBERS; ++i) {
        if (ours)
            ++ways[decimal_read(text[i], strlen(text[i]), &value)];
        else
            value = strtod(text[i], NULL);
        sum += value;
    }
    if (!(sum > 0))
        program_give_up("numbers cannot be read");
    return (bench_seconds() - start) / NUMBERS;
}

/* Times decimal_read and strtod alternately. The first round fills the
   caches and is discarded. */
static void time_digits(int digits, struct table *out, struct random *r)
{
    static char text[NUMBERS][WIDTH];
    double ours[BENCH_ROUNDS], library[BENCH_ROUNDS];
    size_t ways[DECIMAL_STRTOD + 1];
    for (size_t i = 0; i < NUMBERS; ++i)
        snprintf(text[i], WIDTH, "%.*f", digits - 1,
                 10 * random_uniform(r));
    for (int k = -1; k < BENCH_ROUNDS; ++k) {
        memset(ways, 0, sizeof ways);
        ours[k < 0 ? 0 : k] = time_numbers(text, true, ways);
        library[k < 0 ? 0 : k] = time_numbers(text, false, ways);
    }
    table_print(out, "%d %.1f %.1f %.4f %.4f %.4f\n", digits,
                1e9 * bench_median(ours, BENCH_ROUNDS),
                1e9 * bench_median(library, BENCH_ROUNDS),
                (double)ways[DECIMAL_SHORT] / NUMBERS,
                (double)ways[DECIMAL_PAIR] / NUMBERS,
                (double)ways[DECIMAL_STRTOD] / NUMBERS);
}

/* Returns the text of a scene with `bodies` bodies whose positions and
   velocities have 17 digits, or NULL if there is no memory. */
static char *write_gas(size_t bodies, size_t *length, struct random *r)
{
    char *text = malloc(256 * bodies), *c = text;
    for (size_t i = 0; text && i < bodies; ++i) {
        double x[6];
        for (int k = 0; k < 6; ++k)
            x[k] = 10 * random_uniform(r) - 5;
        c += snprintf(c, 256,
                      "pos %zu %.17g %.17g %.17g 1 0 0.001\n"
                      "vel %zu %.17g %.17g %.17g\n",
                      i, x[0], x[1], x[2], i, x[3], x[4], x[5]);
    }
    *length = (size_t)(c - text);
    return text;
}

/* Times the parsing of a large scene. The text is already in memory, so the
   speed of the disk does not matter. */
static void time_scene(size_t bodies, struct table *out, struct random *r)
{
    double seconds[BENCH_ROUNDS];
    size_t length;
    struct scene s;
    struct scene_error e;
    char *text = write_gas(bodies, &length, r);
    program_memory(text, "for a scene");
    for (int k = -1; k < BENCH_ROUNDS; ++k) {
        const double start = bench_seconds();
        if (!scene_parse(&s, text, length, &e))
            program_give_up("%s", e.text);
        seconds[k < 0 ? 0 : k] = bench_seconds() - start;
        scene_free(&s);
    }
    free(text);
    table_print(out, "scene %zu %.1f %.3f\n", bodies, (double)length / 1e6,
                bench_median(seconds, BENCH_ROUNDS));
}

int main(int argc, char *argv[])
{
    static const struct options_entry entries[] = {
        {OPTIONS_OUTPUT("table")}, {0}};
    struct options o;
    const char *output = NULL;
    options_begin(&o, PROGRAM, "Time the reading of numbers and scenes.",
                  entries, argc, argv);
    while (options_next(&o) != -1)
        output = options_text(&o);
    struct table *out = program_table(output);
    struct random r;
    random_seed(&r, 1);
    table_begin(out, options_command(&o), 1);
    bench_machine(out);
    TABLE_COLUMNS(out, {"n", "", "digits of a number"},
                  {"ours", "ns", "processor time to read it"},
                  {"strtod", "ns", "the same, by the C library"},
                  {"short", "", "share read by one operation"},
                  {"pair", "", "share read as a head and a tail"},
                  {"library", "", "share left to the library"});
    for (int digits = 1; digits <= MOST_DIGITS; ++digits)
        time_digits(digits, out, &r);
    table_print(out, "\n\n# scene bodies megabytes seconds\n");
    time_scene(1000000, out, &r);
    return table_close(out) ? EXIT_SUCCESS : EXIT_FAILURE;
}
