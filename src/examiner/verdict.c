/* Judges an exercise: compares with the stub, builds, runs the tests. */
#include "examiner/verdict.h"
#include "examiner/build.h"
#include "examiner/cache.h"
#include "examiner/process.h"
#include "examiner/text.h"
#include "examiner/work.h"

#include <stdlib.h>
#include <string.h>

/* Names the other tests that failed. Together they may show the cause, for
   example if all are about walls. */
static void tell_others(const struct exercise *e, const enum state states[],
                        int decides, int run, FILE *story)
{
    char text[512];
    for (int i = decides + 1; i < run; ++i)
        if (states[i] != PASSED) {
            snprintf(text, sizeof text, "%s (%s)", e->tests[i],
                     state_name(states[i]));
            text_field(story, "also", text);
        }
    if (run < e->count)
        fprintf(story, "  The tests after it were not run.\n");
}

static int gap_line(const char *account)
{
    const char *colon = strrchr(account, ':');
    return colon ? atoi(colon + 1) : 0;
}

/* Returns whether running the tests again would give the same verdict. A
   test that timed out may have been slowed down by other programs. A test
   that crashed may have run out of memory or read beyond an array. All
   other outcomes are reported by our own runner and are reproducible. */
static bool repeatable(const enum state states[], int run)
{
    for (int i = 0; i < run; ++i)
        if (states[i] == CRASHED || states[i] == TIMED_OUT)
            return false;
    return true;
}

/* Reports memory that a passing answer has leaked. Returns whether there
   was a leak. One search for leaks per exercise is enough: the last test
   does it, if all others have passed. A pass with a leak is not stored. */
static bool tell_leak(const struct exercise *e, const struct trial *trial,
                      FILE *story)
{
    char path[4096], *text = NULL;
    FILE *told = text_stream(&text, NULL);
    snprintf(path, sizeof path, "%s/output", trial->folder);
    const bool leaks =
        e->state == PASSED && trial_leak(path, e->file, told);
    fclose(told);
    if (leaks)
        fprintf(story, "  A word of advice, which costs no point:\n%s",
                text);
    free(text);
    return leaks;
}

/* Runs the tests of an exercise and sets its state. Returns whether the
   verdict can be stored. One test decides the state and is reported in
   full: the first that failed or, if none failed, the first that reached
   NOT_DONE_YET. A time-out ends the run, since nobody wants to wait five
   seconds for each further test. */
static bool run_tests(struct exercise *e, const struct trial *trial,
                      FILE *story)
{
    enum state states[CHECK_TESTS], last = PASSED;
    char *account = NULL;
    int run = 0, decides = 0, idle = 0;
    e->state = PASSED;
    trial_open(trial);
    while (run < e->count && last != TIMED_OUT && !process_signal()) {
        char *text = NULL;
        FILE *told = text_stream(&text, NULL);
        struct trial now = *trial;
        now.leaks = run + 1 == e->count && e->state == PASSED;
        last = states[run] = trial_run(&now, run + 1, told);
        fclose(told);
        if (last == PASSED)
            *(e->idle[run] ? &idle : &e->earned) += e->worth[run];
        if (e->state == PASSED ||
            (!state_wrong(e->state) && state_wrong(last))) {
            free(account);
            account = text;
            e->state = last;
            e->wants = last == PASSED ? 0 : run + 1;
            decides = run;
        } else {
            free(text);
        }
        ++run;
    }
    trial_close();
    if (e->earned > 0)
        e->earned += idle;
    if (e->state != PASSED) {
        text_field(story, "test", e->tests[decides]);
        fputs(account, story);
    }
    if (e->state == NOT_BEGUN)
        e->gap = gap_line(account);
    if (state_wrong(e->state))
        tell_others(e, states, decides, run, story);
    free(account);
    return !tell_leak(e, trial, story) && repeatable(states, run);
}

/* Judges an exercise. Returns whether the verdict can be stored. "Does not
   build" can be stored only if the compiler has found an error in the
   student's file; otherwise the disk may have been full. */
static bool build_and_test(struct exercise *e,
                           const struct verdict_rules *rules, FILE *story)
{
    const char *folder = work_folder();
    const struct trial trial = {.folder = folder,
                                .source = e->file,
                                .sanitized = build_sanitized(),
                                .seconds = rules->seconds,
                                .runner = "../runner"};
    e->state = DOES_NOT_BUILD;
    if (!build_runner(folder, e->name, e->file, rules->strict, story))
        return build_blames(folder, e->file);
    const bool certain = run_tests(e, &trial, story);
    if (state_wrong(e->state))
        build_warning(folder, e->file, story);
    return certain;
}

static void forget(struct exercise *e)
{
    free(e->story);
    e->story = NULL;
    e->judged = false;
    e->state = NOT_BEGUN;
    e->earned = e->gap = e->wants = 0;
}

/* Reports that the student's file is missing; the exercise counts as not
   begun. The examiner never creates the file unasked. */
static void tell_missing(struct exercise *e)
{
    char text[4 * COURSE_PATH];
    int length = snprintf(text, sizeof text,
                          "  The file is missing. Fetch it: make reset "
                          "EX=%s\n",
                          e->name);
    if (*e->stray)
        snprintf(text + length, sizeof text - (size_t)length,
                 "  Or is it %s? Then name it exercises/%s\n", e->stray,
                 e->usual);
    e->story = strdup(text);
}

void verdict_from_cache(struct exercise *e,
                        const struct verdict_rules *rules)
{
    forget(e);
    if (*e->file && course_touched(e)) {
        e->judged =
            rules->use_cache &&
            cache_load(e, cache_key(e, rules->strict, rules->seconds));
        return;
    }
    e->judged = true;
    if (!*e->file)
        tell_missing(e);
}

/* Judges in the cheapest possible way: comparing with the stub takes
   microseconds, reading a stored verdict a fraction of a millisecond, and
   building and running a quarter of a second. The key is computed before
   the compiler starts. If the key has changed by the end, the file was
   saved in the meantime, and the verdict is not stored. */
void verdict_reach(struct exercise *e, const struct verdict_rules *rules)
{
    verdict_from_cache(e, rules);
    if (e->judged)
        return;
    build_suite(e->name);
    const uint64_t key = cache_key(e, rules->strict, rules->seconds);
    FILE *story = text_stream(&e->story, NULL);
    const bool certain = build_and_test(e, rules, story);
    fclose(story);
    e->judged = !process_signal();
    if (e->judged && certain && rules->use_cache &&
        cache_key(e, rules->strict, rules->seconds) == key)
        cache_save(e, key);
}
