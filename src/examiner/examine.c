/* From chapters/B-examiner.nw: edit there, then run make tangle. */
/* checksum 2080844184 of the lines below */
#include "examiner/build.h"
#include "examiner/check.h"
#include "examiner/process.h"
#include "examiner/text.h"
#include "examiner/trial.h"

#include <errno.h>
#include <getopt.h>
#include <glob.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PATH_ROOM = 1024 };

struct exercise {
    const char *name; /* "01a" */
    const char *title;
    const char *tests[CHECK_TESTS];
    int count, minutes, points;
    char file[PATH_ROOM];  /* the student's; empty when it is missing */
    char stub[PATH_ROOM];  /* as it came with the book */
    char stray[PATH_ROOM]; /* what may be the student's, misnamed */
    bool chosen;
    enum state state;
    int passed;  /* tests */
    int gap;     /* the line of a NOT_DONE_YET that was reached, or 0 */
    char *story; /* what to say about it, made by open_memstream */
};

struct options {
    bool strict, list;
    int seconds;
    const char *as, *file;
};

static const char usage[] =
    "usage: examine [OPTION]... [EXERCISE]...\n"
    "Checks the exercises named (01a, or 01 for a chapter), or all.\n"
    "  --as EXERCISE  check the file of --file as this exercise\n"
    "  --file FILE    see --as\n"
    "  --list         list the exercises and check nothing\n"
    "  --seconds N    processor time that a test may take (5)\n"
    "  --strict       take compiler warnings for errors\n"
    "  --help         print this\n"
    "Exit status: 0 all that is begun passes, 1 it does not, 2 trouble.\n";

static void take_option(struct options *o, int c)
{
    switch (c) {
    case 'a': o->as = optarg; break;
    case 'f': o->file = optarg; break;
    case 'l': o->list = true; break;
    case 's':
        o->seconds = atoi(optarg);
        if (o->seconds < 1 || o->seconds > 3600)
            text_fail("--seconds: '%s' is not a whole number from 1 to "
                      "3600",
                      optarg);
        break;
    case 'S': o->strict = true; break;
    case 'h': fputs(usage, stdout); exit(EXIT_SUCCESS);
    default: fputs("Try: examine --help\n", stderr); exit(2);
    }
}

static struct options read_options(int argc, char **argv)
{
    static const struct option known[] = {
        {"as", required_argument, NULL, 'a'},
        {"file", required_argument, NULL, 'f'},
        {"list", no_argument, NULL, 'l'},
        {"seconds", required_argument, NULL, 's'},
        {"strict", no_argument, NULL, 'S'},
        {"help", no_argument, NULL, 'h'},
        {0},
    };
    struct options o = {.seconds = 5};
    for (int c; (c = getopt_long(argc, argv, "", known, NULL)) != -1;)
        take_option(&o, c);
    if (!o.as != !o.file)
        text_fail("--as and --file go together");
    if (o.as && optind < argc)
        text_fail("with --as, '%s' is one exercise too many", argv[optind]);
    return o;
}

static void find_one(const char *where, const char *name,
                     char path[PATH_ROOM])
{
    glob_t found = {0};
    char pattern[64];
    snprintf(pattern, sizeof pattern, where, name);
    path[0] = '\0';
    if (glob(pattern, 0, NULL, &found) == 0)
        snprintf(path, PATH_ROOM, "%s", found.gl_pathv[0]);
    if (*path && !text_plain(path))
        text_fail("'%s' is not a plain file; move it out of the folder",
                  path);
    if (found.gl_pathc > 1)
        text_fail("'%s' and '%s' are the same exercise; move one of them "
                  "out of the folder",
                  found.gl_pathv[0], found.gl_pathv[1]);
    globfree(&found);
}

static void learn_test(struct exercise *e, const char *text)
{
    char *name;
    e->points += (int)strtol(text, &name, 10);
    strtol(name, &name, 10);
    e->tests[e->count++] = name + strspn(name, " ");
}

static void read_about(struct exercise *e, const char *path)
{
    char *rest = text_read(path);
    const char *text;
    e->name = e->title = "";
    for (char *line; (line = text_line(&rest));)
        if ((text = text_after(line, "exercise ")))
            e->name = text;
        else if ((text = text_after(line, "title ")))
            e->title = text;
        else if ((text = text_after(line, "minutes ")))
            e->minutes = atoi(text);
        else if ((text = text_after(line, "test ")) &&
                 e->count < CHECK_TESTS)
            learn_test(e, text);
    if (!*e->name || !e->count)
        text_fail("%s is not complete; remove it and make check again",
                  path);
    find_one("tests/stubs/%s-*.c", e->name, e->stub);
    find_one("exercises/%s-*.c", e->name, e->file);
    if (!*e->file)
        find_one("exercises/%s*.c", e->name, e->stray);
}

static size_t learn(struct exercise **exercises)
{
    glob_t found = {0};
    glob("build/check/[0-9][0-9][a-z].list", 0, NULL, &found);
    const size_t count = found.gl_pathc;
    if (count == 0)
        text_fail("no suites in build/check; start me with make check");
    *exercises = calloc(count, sizeof **exercises);
    if (!*exercises)
        text_fail("out of memory");
    for (size_t i = 0; i < count; ++i)
        read_about(&(*exercises)[i], found.gl_pathv[i]);
    globfree(&found);
    return count;
}

static char work[] = "build/check/work.XXXXXX";

static void remove_work(void)
{
    char command[64];
    snprintf(command, sizeof command, "rm -rf '%s'", work);
    if (system(command) != 0)
        fprintf(stderr, "examine: cannot remove '%s'\n", work);
}

static void make_work(void)
{
    if (!mkdtemp(work))
        text_fail("cannot make a folder in build/check: %s",
                  strerror(errno));
    atexit(remove_work);
}

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

static void run_tests(struct exercise *e, const struct trial *trial,
                      FILE *story)
{
    enum state states[CHECK_TESTS], last = PASSED;
    char *account = NULL;
    int run = 0, decides = 0;
    e->state = PASSED;
    while (run < e->count && last != TIMED_OUT && !process_signal()) {
        char *text = NULL;
        size_t size;
        FILE *told = open_memstream(&text, &size);
        if (!told)
            text_fail("out of memory");
        last = states[run] = trial_run(trial, run + 1, told);
        fclose(told);
        e->passed += last == PASSED;
        if (e->state == PASSED ||
            (!state_wrong(e->state) && state_wrong(last))) {
            free(account);
            account = text;
            e->state = last;
            decides = run;
        } else {
            free(text);
        }
        ++run;
    }
    if (e->state != PASSED) {
        text_field(story, "test", e->tests[decides]);
        fputs(account, story);
    }
    if (e->state == NOT_BEGUN)
        e->gap = gap_line(account);
    if (state_wrong(e->state))
        tell_others(e, states, decides, run, story);
    free(account);
}

static bool same_files(const char *one, const char *other)
{
    char *a = text_read(one), *b = text_read(other);
    const bool same = a && b && strcmp(a, b) == 0;
    free(a);
    free(b);
    return same;
}

static bool touched(const struct exercise *e)
{
    return *e->file && !same_files(e->file, e->stub);
}

static void tell_missing(const struct exercise *e, FILE *story)
{
    fprintf(story, "  The file is missing. Fetch it: cp %s exercises/\n",
            e->stub);
    if (*e->stray)
        fprintf(story, "  Or is it %s? Then name it exercises/%s\n",
                e->stray, strrchr(e->stub, '/') + 1);
}

static void build_and_test(struct exercise *e,
                           const struct options *options, FILE *story)
{
    const struct trial trial = {.folder = work,
                                .source = e->file,
                                .sanitized = build_sanitized(),
                                .seconds = options->seconds,
                                .runner = "../runner"};
    e->state = DOES_NOT_BUILD;
    if (!build_runner(work, e->name, e->file, options->strict, story))
        return;
    run_tests(e, &trial, story);
    if (state_wrong(e->state))
        build_warning(work, e->file, story);
}

static void examine(struct exercise *e, const struct options *options)
{
    size_t size;
    FILE *story = open_memstream(&e->story, &size);
    if (!story)
        text_fail("out of memory");
    e->state = NOT_BEGUN;
    if (!*e->file)
        tell_missing(e, story);
    else if (touched(e))
        build_and_test(e, options, story);
    fclose(story);
}

static const char *colour(enum state state)
{
    if (state == NOT_BEGUN || !isatty(STDOUT_FILENO) || getenv("NO_COLOR"))
        return "";
    return state_wrong(state) ? "\033[31m" : "\033[32m";
}

static void show_line(const struct exercise *e)
{
    const char *code = colour(e->state);
    printf("%s  %-38.38s %3d min  %s%s%s", e->name, e->title, e->minutes,
           code, state_name(e->state), *code ? "\033[0m" : "");
    if (e->gap || (e->state != NOT_BEGUN && e->state != DOES_NOT_BUILD))
        printf("%*s%d of %d", 16 - (int)strlen(state_name(e->state)), "",
               e->passed, e->count);
    putchar('\n');
    fflush(stdout);
}

static void tell_story(const struct exercise *e)
{
    printf("\n%s: %s %s\n%s", e->name, *e->file ? e->file : e->title,
           e->gap                       ? "is under way"
           : e->state == NOT_BEGUN      ? "is not begun"
           : e->state == DOES_NOT_BUILD ? "does not build"
           : e->state == PASSED         ? "passes"
                                        : "does not pass yet",
           e->story);
}

static void invite(const struct exercise *fresh, bool passed, bool begun)
{
    if (fresh->gap)
        printf("%s is under way; its gap is at line %d.\n", fresh->name,
               fresh->gap);
    else if (passed)
        printf("So far, so good.\n");
    else if (!begun)
        printf("Nothing is begun yet; every course starts there.\n");
    if (*fresh->file)
        printf("Next: open %s, then: make check EX=%s\n", fresh->file,
               fresh->name);
    else
        printf("Next: fetch the missing file: cp %s exercises/\n",
               fresh->stub);
}

static void show_next(const struct exercise *exercises, size_t count)
{
    const struct exercise *wrong = NULL, *fresh = NULL;
    bool passed = false, begun = false;
    for (size_t i = count; i-- > 0;) {
        const struct exercise *e = &exercises[i];
        begun |= touched(e);
        if (e->chosen && e->state == PASSED)
            passed = true;
        else if (e->state != NOT_BEGUN)
            wrong = e;
        else if (e->chosen && (e->gap || !fresh || !fresh->gap))
            fresh = e;
    }
    putchar('\n');
    if (wrong)
        printf("Next: mend %s, then: make check EX=%s\n"
               "Stuck? The book's appendix C has hints for it.\n",
               wrong->file, wrong->name);
    else if (fresh)
        invite(fresh, passed, begun);
    else
        printf("Everything here passes. Well done.\n");
}

static int list(const struct exercise *exercises, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        printf("%s  %-30.30s %3d min %2d points  %s\n", exercises[i].name,
               exercises[i].title, exercises[i].minutes,
               exercises[i].points, exercises[i].file);
    return EXIT_SUCCESS;
}

static void choose(struct exercise *exercises, size_t count,
                   const char *name)
{
    bool found = false;
    const size_t length = strlen(name) == 2 ? 2 : 4;
    for (size_t i = 0; i < count; ++i)
        if (strncmp(exercises[i].name, name, length) == 0)
            found = exercises[i].chosen = true;
    if (found)
        return;
    fprintf(stderr, "examine: there is no exercise '%s'; there are", name);
    for (size_t i = 0; i < count; ++i)
        fprintf(stderr, " %s", exercises[i].name);
    fputc('\n', stderr);
    exit(2);
}

static void choose_file(struct exercise *exercises, size_t count,
                        const struct options *options)
{
    choose(exercises, count, options->as);
    if (access(options->file, R_OK) != 0)
        text_fail("cannot read '%s': %s", options->file, strerror(errno));
    if (!text_plain(options->file))
        text_fail("'%s' is not a plain file", options->file);
    for (size_t i = 0; i < count; ++i)
        if (exercises[i].chosen)
            snprintf(exercises[i].file, PATH_ROOM, "%s", options->file);
}

int main(int argc, char **argv)
{
    const struct options options = read_options(argc, argv);
    struct exercise *exercises;
    const size_t count = learn(&exercises);
    if (options.list)
        return list(exercises, count);
    if (options.as)
        choose_file(exercises, count, &options);
    for (int i = optind; i < argc; ++i)
        choose(exercises, count, argv[i]);
    const bool named = options.as || optind < argc;
    process_catch_signals();
    make_work();
    int wrong = 0;
    for (size_t i = 0; i < count; ++i) {
        struct exercise *e = &exercises[i];
        e->chosen |= !named;
        if (!e->chosen)
            continue;
        examine(e, &options);
        if (process_signal())
            text_fail("interrupted");
        show_line(e);
        wrong += state_wrong(e->state);
    }
    bool told = false, run = false;
    for (size_t i = 0; i < count; ++i) {
        const struct exercise *e = &exercises[i];
        const bool mend = state_wrong(e->state) && !told;
        run |= e->gap || e->state != NOT_BEGUN;
        if (e->chosen && *e->story && (named || mend || !*e->file)) {
            tell_story(e);
            told |= mend;
        }
    }
    if (run && !build_sanitized())
        printf(
            "\nThis compiler has no sanitizers: errors of memory may pass "
            "unseen.\n");
    if (!options.as)
        show_next(exercises, count);
    return wrong ? EXIT_FAILURE : EXIT_SUCCESS;
}
