/* Runs the tests of one exercise against a mutant, one after the other,
   until one of them is not passed.

       outlive FOLDER TESTS SECONDS

   FOLDER holds the program `runner`, as the examiner makes it, but without
   sanitizers; TESTS is how many tests it has, SECONDS how much processor
   time each may take. Prints the state in which the first of them ended
   that was not passed, with its number, such as `timed out 3`; or `passed`
   and the processor time in s of the slowest test. Exit status 0 in both
   cases, 2 in trouble. */

#include "examiner/process.h"
#include "examiner/text.h"
#include "examiner/trial.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

/* Processor time that our children have taken so far, s. */
static double children(void)
{
    struct rusage usage = {0};
    getrusage(RUSAGE_CHILDREN, &usage);
    return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

static int whole(const char *text, int most)
{
    char *end;
    const long number = strtol(text, &end, 10);
    if (end == text || *end || number < 1 || number > most)
        text_fail("'%s' is not a whole number from 1 to %d", text, most);
    return (int)number;
}

/* Runs one test and puts the processor time that it took, in s, into
   *taken. Where a busy machine, and not the mutant, has used up the time on
   the wall, that is no time-out: it is tried again. */
static enum state run_test(const struct trial *trial, int test,
                           FILE *unread, double *taken)
{
    enum state state = PASSED;
    bool spent = false;
    for (int tries = 0; tries < 5 && !spent; ++tries) {
        const double before = children();
        state = trial_run(trial, test, unread);
        *taken = children() - before;
        spent = state != TIMED_OUT || *taken > 0.9 * trial->seconds ||
                process_signal();
    }
    return state;
}

int main(int argc, char **argv)
{
    if (argc != 4)
        text_fail("usage: outlive FOLDER TESTS SECONDS");
    const int tests = whole(argv[2], 1000);
    const struct trial trial = {.folder = argv[1],
                                .source = "",
                                .seconds = whole(argv[3], 3600),
                                .runner = "../runner"};
    char *story;
    FILE *unread = text_stream(&story, NULL);
    enum state state = PASSED;
    double slowest = 0.0;
    int test = 0;
    process_catch_signals();
    while (state == PASSED && test < tests && !process_signal()) {
        double taken = 0.0;
        state = run_test(&trial, ++test, unread, &taken);
        slowest = taken > slowest ? taken : slowest;
    }
    fclose(unread);
    free(story);
    if (process_signal())
        text_fail("stopped by signal %d", process_signal());
    if (state == PASSED)
        printf("passed %.3f\n", slowest);
    else
        printf("%s %d\n", state_name(state), test);
    return fflush(stdout) ? 2 : EXIT_SUCCESS;
}
