/* The program behind make check: reads its options and runs the task. */
#include "examiner/hint.h"
#include "examiner/process.h"
#include "examiner/reset.h"
#include "examiner/round.h"
#include "examiner/solution.h"
#include "examiner/text.h"
#include "examiner/watch.h"
#include "toolbox/options.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct settings {
    struct verdict_rules rules;
    int task; /* letter of the option that chose it; 0: check */
    const char *as, *file, **names;
};

static const struct options_entry entries[] = {
    {"", 0, "[EXERCISE]...", NULL},
    {"watch", 'w', NULL, "check what is saved, until Ctrl-C"},
    {"hint", 'H', NULL, "give the next hint, for the exercise to do next"},
    {"progress", 'p', NULL, "show a bar for each chapter"},
    {"reset", 'r', NULL, "save the file of an exercise, put its stub back"},
    {"solution", 'x', NULL,
     "show the worked solution, once an exercise passes"},
    {"list", 'l', NULL, "list the exercises and check nothing"},
    {"as", 'a', "EXERCISE", "check the file of --file as this exercise"},
    {"file", 'f', "FILE", "see --as"},
    {"seconds", 's', "N", "processor time that a test may take (5)"},
    {"strict", 'S', NULL, "take compiler warnings for errors"},
    {0}};

static const char purpose[] =
    "Check the exercises named (01a, or 01 for a chapter), or all.\n"
    "Exit status: 0 all that is begun passes, 1 it does not, 2 trouble.";

static void add_names(struct settings *s, const char *argument)
{
    size_t count = 0;
    while (s->names && s->names[count])
        ++count;
    const size_t most = count + strlen(argument) / 2 + 2;
    s->names = realloc(s->names, most * sizeof *s->names);
    char *list = strdup(argument);
    if (!s->names || !list)
        text_fail("out of memory");
    s->names[count] = strtok(list, ", ");
    while (s->names[count])
        s->names[++count] = strtok(NULL, ", ");
}

static void take_option(struct settings *s, struct options *o, int letter)
{
    switch (letter) {
    case OPTIONS_ARGUMENT: add_names(s, options_text(o)); break;
    case 'a': s->as = options_text(o); break;
    case 'f': s->file = options_text(o); break;
    case 's': s->rules.seconds = (int)options_count(o, 1, 3600); break;
    case 'S': s->rules.strict = true; break;
    default:
        if (s->task)
            options_fail(o, "one thing at a time, please");
        s->task = letter;
    }
}

static struct settings read_settings(int argc, char **argv)
{
    struct settings s = {.rules = {.use_cache = true, .seconds = 5}};
    struct options o;
    add_names(&s, "");
    options_begin(&o, "examine", purpose, entries, argc, argv);
    for (int letter; (letter = options_next(&o)) != -1;)
        take_option(&s, &o, letter);
    if (!s.as != !s.file)
        options_fail(&o, "--as and --file go together");
    if (s.as && s.names[0])
        options_fail(&o, "with --as, '%s' is one exercise too many",
                     s.names[0]);
    if (s.as && s.task)
        options_fail(&o, "--as is for checking alone");
    s.rules.use_cache = !s.as;
    return s;
}

/* Makes the file given by --file the student's file for the exercise given
   by --as. This is for tests and lecturers. The verdict is not stored. */
static void take_file(struct course *course, const struct settings *s)
{
    struct exercise *e = course_choose(course, s->as);
    if (access(s->file, R_OK) != 0)
        text_fail("cannot read '%s': %s", s->file, strerror(errno));
    if (!text_plain(s->file))
        text_fail("'%s' is not a plain file", s->file);
    if (strcmp(e->name, s->as) != 0)
        text_fail("--as wants one exercise, and '%s' is a chapter", s->as);
    snprintf(e->file, sizeof e->file, "%s", s->file);
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

/* Does what the command line asks. Returns false if any exercise begun so
   far does not pass. Tasks without a verdict return true, because make
   would otherwise print "Error 1" below their output. */
static bool do_task(struct course *course, const struct settings *s)
{
    const struct verdict_rules *rules = &s->rules;
    const char *const *names = s->names;
    switch (s->task) {
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
    default: return round_check(course, rules, names[0] || s->as);
    }
    return true;
}

/* Returns 0 if all exercises begun so far pass, or if none is begun, and 1
   otherwise. Exits with status 2 if nothing could be checked. */
int main(int argc, char **argv)
{
    const struct settings s = read_settings(argc, argv);
    struct course course = course_learn();
    process_catch_signals();
    if (s.as)
        take_file(&course, &s);
    for (int i = 0; s.names[i]; ++i)
        course_choose(&course, s.names[i]);
    for (size_t i = 0; i < course.count; ++i)
        course.exercises[i].chosen |= !s.as && !s.names[0];
    const bool fine = do_task(&course, &s);
    if (!s.task && !s.as)
        round_next(&course);
    return fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
