/* The program behind make check: its options, and what each begins. */
#include "examiner/hint.h"
#include "examiner/process.h"
#include "examiner/reset.h"
#include "examiner/round.h"
#include "examiner/solution.h"
#include "examiner/text.h"
#include "examiner/watch.h"
#include "toolbox/version.h"

#include <errno.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct options {
    struct verdict_rules rules;
    int task; /* what to do: the letter of its option, or 0 to check */
    const char *as, *file;
};

static const char usage[] =
    "usage: examine [OPTION]... [EXERCISE]...\n"
    "Checks the exercises named (01a, or 01 for a chapter), or all.\n"
    "  --watch        check what is saved, until Ctrl-C\n"
    "  --hint         give the next hint, for the exercise to do next\n"
    "  --progress     show a bar for each chapter\n"
    "  --reset        save the file of an exercise, put its stub back\n"
    "  --solution     show the worked solution of an exercise that passes\n"
    "  --list         list the exercises and check nothing\n"
    "  --as EXERCISE  check the file of --file as this exercise\n"
    "  --file FILE    see --as\n"
    "  --seconds N    processor time that a test may take (5)\n"
    "  --strict       take compiler warnings for errors\n"
    "  --help         print this\n"
    "  --version      name the version\n"
    "Exit status: 0 all that is begun passes, 1 it does not, 2 trouble.\n";

static void take_option(struct options *o, int c)
{
    switch (c) {
    case 'a': o->as = optarg; break;
    case 'f': o->file = optarg; break;
    case 's':
        o->rules.seconds = atoi(optarg);
        if (o->rules.seconds < 1 || o->rules.seconds > 3600)
            text_fail("--seconds: '%s' is not a whole number from 1 to "
                      "3600",
                      optarg);
        break;
    case 'S': o->rules.strict = true; break;
    case 'h': fputs(usage, stdout); exit(EXIT_SUCCESS);
    case 'v':
        puts("examine (Bonkers) " TOOLBOX_VERSION);
        exit(EXIT_SUCCESS);
    case '?': fputs("Try: examine --help\n", stderr); exit(2);
    default:
        if (o->task)
            text_fail("one thing at a time, please; try examine --help");
        o->task = c;
    }
}

static const struct option known[] = {
    {"watch", no_argument, NULL, 'w'},
    {"hint", no_argument, NULL, 'H'},
    {"progress", no_argument, NULL, 'p'},
    {"reset", no_argument, NULL, 'r'},
    {"solution", no_argument, NULL, 'x'},
    {"list", no_argument, NULL, 'l'},
    {"as", required_argument, NULL, 'a'},
    {"file", required_argument, NULL, 'f'},
    {"seconds", required_argument, NULL, 's'},
    {"strict", no_argument, NULL, 'S'},
    {"help", no_argument, NULL, 'h'},
    {"version", no_argument, NULL, 'v'},
    {0},
};

/* Reads the command line. The options are read without the toolbox's
   module, so that the examiner stands when the toolbox is in pieces. */
static struct options read_options(int argc, char **argv)
{
    struct options o = {.rules = {.remember = true, .seconds = 5}};
    for (int c; (c = getopt_long(argc, argv, "", known, NULL)) != -1;)
        take_option(&o, c);
    if (!o.as != !o.file)
        text_fail("--as and --file go together");
    if (o.as && optind < argc)
        text_fail("with --as, '%s' is one exercise too many", argv[optind]);
    if (o.as && o.task)
        text_fail("--as is for checking alone");
    o.rules.remember = !o.as;
    return o;
}

/* Puts another file in the place of the student's, for tests and lecturers:
   everything after it is as it would be with his, but that the verdict is
   not remembered. */
static void take_file(struct course *course, const struct options *options)
{
    struct exercise *e = course_choose(course, options->as);
    if (access(options->file, R_OK) != 0)
        text_fail("cannot read '%s': %s", options->file, strerror(errno));
    if (!text_plain(options->file))
        text_fail("'%s' is not a plain file", options->file);
    if (strcmp(e->name, options->as) != 0)
        text_fail("--as wants one exercise, and '%s' is a chapter",
                  options->as);
    snprintf(e->file, sizeof e->file, "%s", options->file);
}

static void list(const struct course *course)
{
    for (size_t i = 0; i < course->count; ++i) {
        const struct exercise *e = &course->exercises[i];
        printf("%s  %-30.30s %2d min %2d points  %s\n", e->name, e->title,
               e->minutes, e->points, e->file);
    }
}

static struct exercise *the_one(struct course *course,
                                const char *const names[], const char *goal)
{
    if (!names[0])
        text_fail("which exercise? Say so: make %s EX=%s", goal,
                  course->exercises[0].name);
    struct exercise *e = course_choose(course, names[0]);
    if (names[1])
        text_fail("one exercise at a time, and not '%s' as well", names[1]);
    if (strcmp(e->name, names[0]) != 0)
        text_fail("'%s' is a chapter; say which exercise: make %s EX=%s",
                  names[0], goal, e->name);
    return e;
}

static void give_hint(struct course *course,
                      const struct verdict_rules *rules,
                      const char *const names[])
{
    const struct exercise *e;
    if (names[0]) {
        struct exercise *named = the_one(course, names, "hint");
        if (*named->name == 'P')
            verdict_reach(named, rules);
        e = named->state == PASSED ? NULL : named;
    } else {
        round_learn(course, rules);
        e = round_current(course);
    }
    if (e)
        hint_show(e);
    else
        printf("%s passes; there is nothing to hint at.\n",
               names[0] ? names[0] : "Everything here");
}

/* Does what the command line asks for; returns whether all that is begun
   passes. What leaves no verdict ends with status 0, or make would add
   "Error 1" to a kind word. */
static bool do_task(struct course *course, const struct options *options,
                    const char *const names[])
{
    const struct verdict_rules *rules = &options->rules;
    switch (options->task) {
    case 'l': list(course); break;
    case 'w': watch_files(course, rules); break;
    case 'H': give_hint(course, rules, names); break;
    case 'r': reset_exercise(the_one(course, names, "reset")); break;
    case 'x':
        solution_show(the_one(course, names, "solution"), rules);
        break;
    case 'p':
        round_learn(course, rules);
        round_progress(course);
        round_next(course);
        break;
    default: return round_check(course, rules, names[0] || options->as);
    }
    return true;
}

static const char *const *part_names(char *const arguments[])
{
    size_t most = 1, count = 0;
    for (int i = 0; arguments[i]; ++i)
        most += strlen(arguments[i]) / 2 + 1;
    const char **names = calloc(most, sizeof *names);
    for (int i = 0; names && arguments[i]; ++i)
        for (char *name = strtok(arguments[i], ", "); name;
             name = strtok(NULL, ", "))
            names[count++] = name;
    if (!names)
        text_fail("out of memory");
    return names;
}

/* Signals are caught before there is anything to remove. The status is 0
   when all that is begun passes, as in a fresh copy, 1 when something does
   not, 2 when nothing is known. */
int main(int argc, char **argv)
{
    const struct options options = read_options(argc, argv);
    const char *const *names = part_names(argv + optind);
    struct course course = course_learn();
    process_catch_signals();
    if (options.as)
        take_file(&course, &options);
    for (int i = 0; names[i]; ++i)
        course_choose(&course, names[i]);
    for (size_t i = 0; i < course.count; ++i)
        course.exercises[i].chosen |= !options.as && !names[0];
    const bool fine = do_task(&course, &options, names);
    if (!options.task && !options.as)
        round_next(&course);
    return fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
