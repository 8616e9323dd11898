/* Prints results, reports, the next step and bars of progress. */
#include "examiner/round.h"
#include "examiner/build.h"
#include "examiner/process.h"
#include "examiner/text.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Returns the escape sequence for a state's colour, or "" if NO_COLOR is
   set or the output is a file. The state is printed as a word, too, since
   one student in twelve cannot tell red from green. */
static const char *colour(enum state state)
{
    if (state == NOT_BEGUN || !isatty(STDOUT_FILENO) || getenv("NO_COLOR"))
        return "";
    return state_wrong(state) ? "\033[31m" : "\033[32m";
}

/* Prints the line of an exercise and flushes it, so that a long round shows
   its progress. The kit's tests rely on the columns of this line. */
void round_line(const struct exercise *e)
{
    const char *code = colour(e->state);
    printf("%-3s  %-36.36s%s%-14s%s %2d of %2d points %2d min\n", e->name,
           e->title, code, state_name(e->state), *code ? "\033[0m" : "",
           e->earned, e->points, e->minutes);
    fflush(stdout);
}

void round_story(const struct exercise *e)
{
    printf("\n%s: %s %s\n%s", e->name, *e->file ? e->file : e->title,
           e->gap                       ? "is under way"
           : e->state == NOT_BEGUN      ? "is not begun"
           : e->state == DOES_NOT_BUILD ? "does not build"
           : e->state == PASSED         ? "passes"
                                        : "does not pass yet",
           e->story ? e->story : "");
}

void round_solution(const struct exercise *e)
{
    if (e->state == PASSED && *e->name == 'P')
        printf("\nWhat is left is for a person: %s.gp and %s.txt.\n",
               e->name, e->name);
    if (e->state == PASSED && *e->solution)
        printf("\n%s passes. The worked solution: make solution EX=%s\n",
               e->name, e->name);
}

/* Returns the urgency of an exercise, or 0 if it passes. Exercises named by
   the user come before all others. Within each group, an exercise that
   fails comes first, then an unfinished one (`gap`), then one that is not
   begun. */
static int urgency(const struct exercise *e)
{
    if (e->judged && e->state == PASSED)
        return 0;
    const int kind = state_wrong(e->state) ? 3 : e->gap ? 2 : 1;
    return kind + (e->chosen ? 3 : 0);
}

/* Returns the most urgent exercise. An exercise that was not judged counts
   as not begun. */
const struct exercise *round_current(const struct course *course)
{
    const struct exercise *current = NULL;
    int highest = 0;
    for (size_t i = 0; i < course->count; ++i)
        if (urgency(&course->exercises[i]) > highest) {
            current = &course->exercises[i];
            highest = urgency(current);
        }
    return current;
}

static bool any_passed(const struct course *course)
{
    for (size_t i = 0; i < course->count; ++i)
        if (course->exercises[i].state == PASSED)
            return true;
    return false;
}

static bool any_touched(const struct course *course)
{
    for (size_t i = 0; i < course->count; ++i)
        if (course_touched(&course->exercises[i]))
            return true;
    return false;
}

/* Prints the name of the file to open. If it is missing, proposes make
   reset: the student must not edit the stub itself. */
static void invite(const struct course *course, const struct exercise *e)
{
    if (e->gap)
        printf("%s is under way; its gap is at line %d.\n", e->name,
               e->gap);
    else if (any_passed(course))
        printf("So far, so good.\n");
    else if (!any_touched(course))
        printf("Nothing is begun yet; every course starts there.\n");
    if (*e->file)
        printf("Next: open %s, then: make check EX=%s\n", e->file, e->name);
    else
        printf("Next: fetch the missing file: make reset EX=%s\n", e->name);
}

void round_next(const struct course *course)
{
    const struct exercise *e = round_current(course);
    putchar('\n');
    if (!e)
        printf("Everything here passes. Well done.\n");
    else if (state_wrong(e->state))
        printf("Next: mend %s, then: make check EX=%s\n"
               "Stuck? make hint EX=%s\n",
               e->file, e->name, e->name);
    else
        invite(course, e);
}

void round_learn(struct course *course, const struct verdict_rules *rules)
{
    for (size_t i = 0; i < course->count; ++i) {
        struct exercise *e = &course->exercises[i];
        verdict_reach(e, rules);
        if (process_signal())
            text_fail("interrupted");
    }
}

/* Prints the reports on exercises. After a full round these are the reports
   on the first failure and on missing files; otherwise they are the reports
   on the exercises that were named. If the compiler has no sanitizers, adds
   that a pass is less certain. */
static void tell_stories(const struct course *course, bool named)
{
    bool told = false, run = false;
    for (size_t i = 0; i < course->count; ++i) {
        const struct exercise *e = &course->exercises[i];
        const bool mend = state_wrong(e->state) && !told;
        if (!e->chosen)
            continue;
        run |= e->gap || e->state != NOT_BEGUN;
        if (e->story && *e->story && (named || mend || !*e->file)) {
            round_story(e);
            told |= mend;
        }
    }
    if (run && !build_sanitized())
        printf("\nThis compiler has no sanitizers: errors of memory may "
               "pass unseen.\n");
}

/* After a signal, exits before it prints the current exercise, whose test
   was killed. */
bool round_check(struct course *course, const struct verdict_rules *rules,
                 bool named)
{
    bool fine = true;
    for (size_t i = 0; i < course->count; ++i) {
        struct exercise *e = &course->exercises[i];
        if (!e->chosen) {
            verdict_from_cache(e, rules);
            continue;
        }
        verdict_reach(e, rules);
        if (process_signal())
            text_fail("interrupted");
        round_line(e);
        fine &= !state_wrong(e->state);
    }
    tell_stories(course, named);
    for (size_t i = 0; named && rules->use_cache && i < course->count; ++i)
        if (course->exercises[i].chosen)
            round_solution(&course->exercises[i]);
    return fine;
}

enum { BAR = 24 };

/* Rounds down, so that a full bar means all points. */
static void draw_bar(char bar[BAR + 1], int earned, int points)
{
    const int full = points > 0 ? BAR * earned / points : 0;
    for (int i = 0; i < BAR; ++i)
        bar[i] = i < full ? '#' : '.';
    bar[BAR] = '\0';
}

static void add_up(const char *label, const struct course *course,
                   size_t first, size_t end)
{
    int earned = 0, points = 0, passed = 0;
    for (size_t i = first; i < end; ++i) {
        const struct exercise *e = &course->exercises[i];
        earned += e->earned;
        points += e->points;
        passed += e->state == PASSED;
    }
    char bar[BAR + 1];
    draw_bar(bar, earned, points);
    printf("%-10s  %s  %3d of %3d points, %2d of %2d exercises\n", label,
           bar, earned, points, passed, (int)(end - first));
}

void round_progress(const struct course *course)
{
    size_t first = 0;
    while (first < course->count) {
        char label[32];
        size_t end = first;
        while (end < course->count &&
               strncmp(course->exercises[end].name,
                       course->exercises[first].name, 2) == 0)
            ++end;
        if (*course->exercises[first].name == 'P')
            snprintf(label, sizeof label, "project %s",
                     course->exercises[first].name + 1);
        else
            snprintf(label, sizeof label, "chapter %d",
                     atoi(course->exercises[first].name));
        add_up(label, course, first, end);
        first = end;
    }
    add_up("all", course, 0, course->count);
}
