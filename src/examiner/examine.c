/* From chapters/B-examiner.nw: edit there, then run make tangle. */
/* checksum 2317624743 of the lines below */
#include "examiner/build.h"
#include "examiner/process.h"
#include "examiner/text.h"
#include "examiner/trial.h"

#include <errno.h>
#include <getopt.h>
#include <glob.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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

static void fail(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs("examine: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(2);
}

enum { TESTS = 64, PATH_ROOM = 1024 };

struct exercise {
    char *about;      /* the lines of its list, in which these point: */
    const char *name; /* "01a" */
    const char *title;
    const char *tests[TESTS];
    int count, minutes, points;
    bool chosen;
    char file[PATH_ROOM]; /* the student's; empty when it is missing */
    char stub[PATH_ROOM]; /* as it came with the book */
    enum state state;
    int passed;
    char *story; /* what to say about it, made by open_memstream */
};

static char work[64];

static void remove_work(void)
{
    char command[128];
    snprintf(command, sizeof command, "rm -rf '%s'", work);
    if (*work && system(command) != 0)
        fprintf(stderr, "examine: cannot remove '%s'\n", work);
}

static void make_work(void)
{
    snprintf(work, sizeof work, "build/check/work.XXXXXX");
    if (!mkdtemp(work)) {
        *work = '\0';
        fail("cannot make a folder in build/check: %s", strerror(errno));
    }
    atexit(remove_work);
}

static void find_one(const char *pattern, char path[PATH_ROOM])
{
    glob_t found = {0};
    path[0] = '\0';
    if (glob(pattern, 0, NULL, &found) == 0)
        snprintf(path, PATH_ROOM, "%s", found.gl_pathv[0]);
    if (found.gl_pathc > 1)
        fail("'%s' and '%s' are the same exercise; move one of them out of "
             "the folder",
             found.gl_pathv[0], found.gl_pathv[1]);
    globfree(&found);
}

static void read_about(struct exercise *e, const char *path)
{
    char *rest = e->about = text_read(path, TEXT_LIMIT);
    e->name = e->title = "";
    for (char *line; (line = text_line(&rest));) {
        const char *text;
        if ((text = text_after(line, "exercise ")))
            e->name = text;
        else if ((text = text_after(line, "title ")))
            e->title = text;
        else if ((text = text_after(line, "minutes ")))
            e->minutes = atoi(text);
        else if ((text = text_after(line, "points ")))
            e->points = atoi(text);
        else if ((text = text_after(line, "test ")) && e->count < TESTS)
            e->tests[e->count++] = text;
    }
    if (!*e->name || !e->count)
        fail("%s is not complete; remove it and make check again", path);
}

static size_t learn(struct exercise **exercises)
{
    glob_t found = {0};
    glob("build/check/[0-9][0-9][a-z].list", 0, NULL, &found);
    *exercises = calloc(found.gl_pathc + 1, sizeof **exercises);
    if (!*exercises)
        fail("out of memory");
    for (size_t i = 0; i < found.gl_pathc; ++i) {
        struct exercise *e = &(*exercises)[i];
        char pattern[64];
        read_about(e, found.gl_pathv[i]);
        snprintf(pattern, sizeof pattern, "tests/stubs/%s-*.c", e->name);
        find_one(pattern, e->stub);
        snprintf(pattern, sizeof pattern, "exercises/%s-*.c", e->name);
        find_one(pattern, e->file);
    }
    const size_t count = found.gl_pathc;
    globfree(&found);
    if (count == 0)
        fail("no suites in build/check; start me with make check");
    return count;
}

static bool same_files(const char *one, const char *other)
{
    FILE *a = fopen(one, "r"), *b = fopen(other, "r");
    int c = EOF, d = EOF;
    bool same = a && b;
    while (same && (c = getc(a)) == (d = getc(b)) && c != EOF)
        ;
    if (a)
        fclose(a);
    if (b)
        fclose(b);
    return same && c == d;
}

struct outcome {
    enum state state;
    char *account;
};

static int deciding(const struct outcome *outcomes, int run)
{
    int gap = -1;
    for (int i = 0; i < run; ++i)
        if (outcomes[i].state == NOT_BEGUN)
            gap = gap < 0 ? i : gap;
        else if (outcomes[i].state != PASSED)
            return i;
    return gap;
}

static void tell_tests(const struct exercise *e,
                       const struct outcome *outcomes, int run, int decides,
                       FILE *story)
{
    text_field(story, "test", e->tests[decides]);
    fputs(outcomes[decides].account, story);
    for (int i = decides + 1; i < run; ++i)
        if (outcomes[i].state != PASSED && e->state != NOT_BEGUN) {
            char text[512];
            snprintf(text, sizeof text, "%s (%s)", e->tests[i],
                     state_name(outcomes[i].state));
            text_field(story, "also", text);
        }
    if (run < e->count)
        fprintf(story, "  The tests after it were not run.\n");
}

static void run_tests(struct exercise *e, const struct trial *trial,
                      FILE *story)
{
    struct outcome outcomes[TESTS] = {{0}};
    int run = 0;
    while (run < e->count && !process_signal()) {
        struct outcome *o = &outcomes[run++];
        size_t size;
        FILE *account = open_memstream(&o->account, &size);
        o->state = trial_run(trial, run, account);
        fclose(account);
        e->passed += o->state == PASSED;
        if (o->state == TIMED_OUT)
            break;
    }
    const int decides = deciding(outcomes, run);
    e->state = decides < 0 ? PASSED : outcomes[decides].state;
    if (decides >= 0)
        tell_tests(e, outcomes, run, decides, story);
    for (int i = 0; i < run; ++i)
        free(outcomes[i].account);
}

static void build_and_test(struct exercise *e,
                           const struct options *options, FILE *story)
{
    char runner[PATH_ROOM];
    snprintf(runner, sizeof runner, "%s/runner", work);
    struct trial trial = {.folder = work,
                          .runner = runner,
                          .source = e->file,
                          .sanitized = build_sanitized(),
                          .seconds = options->seconds};
    char *warning = NULL;
    size_t size;
    FILE *aside = open_memstream(&warning, &size);
    e->state = DOES_NOT_BUILD;
    const bool built =
        build_runner(work, e->name, e->file, options->strict, story, aside);
    fclose(aside);
    if (built)
        run_tests(e, &trial, story);
    if (e->state != PASSED && e->state != NOT_BEGUN)
        fputs(warning, story);
    free(warning);
}

static void examine(struct exercise *e, const struct options *options)
{
    size_t size;
    FILE *story = open_memstream(&e->story, &size);
    if (!story)
        fail("out of memory");
    e->state = NOT_BEGUN;
    if (!*e->file)
        fprintf(story,
                "  The file is missing. Fetch it: cp %s exercises/\n",
                e->stub);
    else if (!same_files(e->file, e->stub))
        build_and_test(e, options, story);
    fclose(story);
}

static const char *colour(enum state state)
{
    static const char *const codes[] = {"",         "\033[31m", "\033[31m",
                                        "\033[31m", "\033[31m", "\033[32m"};
    return isatty(STDOUT_FILENO) && !getenv("NO_COLOR") ? codes[state] : "";
}

static void show_line(const struct exercise *e)
{
    const char *code = colour(e->state);
    printf("%s  %-38.38s %3d min  %s%s%s", e->name, e->title, e->minutes,
           code, state_name(e->state), *code ? "\033[0m" : "");
    if (e->state != NOT_BEGUN && e->state != DOES_NOT_BUILD)
        printf("%*s%d of %d", 16 - (int)strlen(state_name(e->state)), "",
               e->passed, e->count);
    putchar('\n');
    fflush(stdout);
}

static void tell_story(const struct exercise *e)
{
    printf("\n%s: %s %s\n%s", e->name, *e->file ? e->file : e->title,
           e->state == NOT_BEGUN        ? "is not begun"
           : e->state == DOES_NOT_BUILD ? "does not build"
           : e->state == PASSED         ? "passes"
                                        : "does not pass yet",
           e->story);
}

static void show_next(const struct exercise *exercises, size_t count)
{
    const struct exercise *wrong = NULL, *fresh = NULL;
    size_t passed = 0;
    for (size_t i = count; i-- > 0;) {
        const struct exercise *e = &exercises[i];
        if (!e->chosen || e->state == PASSED)
            passed += e->chosen;
        else if (e->state == NOT_BEGUN)
            fresh = e;
        else
            wrong = e;
    }
    putchar('\n');
    if (wrong)
        printf("Next: mend %s, then: make check EX=%s\n"
               "Stuck? The book's appendix C has hints for it.\n",
               wrong->file, wrong->name);
    else if (fresh)
        printf("%s\nNext: open %s, then: make check EX=%s\n",
               passed ? "So far, so good."
                      : "Nothing is begun yet; every course starts there.",
               *fresh->file ? fresh->file : fresh->stub, fresh->name);
    else
        printf("Everything here passes. Well done.\n");
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
        switch (c) {
        case 'a': o.as = optarg; break;
        case 'f': o.file = optarg; break;
        case 'l': o.list = true; break;
        case 's':
            o.seconds = atoi(optarg);
            if (o.seconds < 1 || o.seconds > 3600)
                fail("--seconds: '%s' is not a whole number from 1 to 3600",
                     optarg);
            break;
        case 'S': o.strict = true; break;
        case 'h': fputs(usage, stdout); exit(EXIT_SUCCESS);
        default: fputs("Try: examine --help\n", stderr); exit(2);
        }
    if (!o.as != !o.file)
        fail("--as and --file go together");
    if (o.as && optind < argc)
        fail("with --as, '%s' is one exercise too many", argv[optind]);
    return o;
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
        fail("cannot read '%s': %s", options->file, strerror(errno));
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
    for (size_t i = 0; i < count && !process_signal(); ++i) {
        struct exercise *e = &exercises[i];
        e->chosen |= !named;
        if (!e->chosen)
            continue;
        examine(e, &options);
        if (!process_signal())
            show_line(e);
        wrong += e->state != PASSED && e->state != NOT_BEGUN;
    }
    if (process_signal())
        fail("interrupted");
    bool told = false;
    for (size_t i = 0; i < count; ++i) {
        const struct exercise *e = &exercises[i];
        const bool mend = e->state != PASSED && e->state != NOT_BEGUN;
        if (e->chosen && *e->story && (named || (mend && !told))) {
            tell_story(e);
            told |= mend;
        }
    }
    if (!options.as)
        show_next(exercises, count);
    for (size_t i = 0; i < count; ++i) {
        free(exercises[i].story);
        free(exercises[i].about);
    }
    free(exercises);
    return wrong ? EXIT_FAILURE : EXIT_SUCCESS;
}
