/* Looks at the files ten times a second, and at the keyboard. */
#include "examiner/watch.h"
#include "examiner/hint.h"
#include "examiner/process.h"
#include "examiner/round.h"
#include "examiner/sum.h"
#include "examiner/text.h"

#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

static pid_t before;

static void give_terminal_back(void)
{
    tcsetpgrp(STDIN_FILENO, before);
}

/* Makes this process the foreground, alone in a group of its own: Ctrl-C
   goes to all processes there, and make would close with a complaint about
   it. Ctrl-Z must be ignored then, or make would wait for ever. */
static void take_terminal(void)
{
    before = getpgrp();
    if (!isatty(STDIN_FILENO) || tcgetpgrp(STDIN_FILENO) != before ||
        before == getpid() || setpgid(0, 0) != 0)
        return;
    signal(SIGTTOU, SIG_IGN);
    signal(SIGTSTP, SIG_IGN);
    tcsetpgrp(STDIN_FILENO, getpid());
    atexit(give_terminal_back);
}

struct seen {
    uint64_t judged, last; /* checksums */
};

/* Returns whether a file was saved: it is another one than was judged, and
   two looks in succession have found the same, because an editor may empty
   a file first and write to it then. An editor that pauses longer than a
   tenth of a second in the middle is answered about half a file. */
static bool saved(struct exercise *e, struct seen *seen)
{
    if (!text_plain(e->file))
        course_find_file(e);
    const uint64_t now = sum_file(0, e->file);
    const bool still = now == seen->last;
    seen->last = now;
    if (!*e->file || !still || now == seen->judged)
        return false;
    seen->judged = now;
    return true;
}

static void show(const struct course *course, const struct exercise *e)
{
    if (isatty(STDOUT_FILENO))
        fputs("\033[H\033[2J\033[3J", stdout);
    if (e) {
        round_line(e);
        if (e->story && *e->story)
            round_story(e);
        round_solution(e);
    }
    round_next(course);
    puts("\nWatching: save a file, and it is checked. Ctrl-C ends it.");
    if (isatty(STDIN_FILENO))
        puts("Keys: h and Enter for a hint, q and Enter to end.");
    if (e)
        printf("In another window: make reset EX=%s, to begin afresh.\n",
               e->name);
    fflush(stdout);
}

enum { WATCH_PAUSE = 100 }; /* ms between two looks */

/* Waits a moment for a key; returns whether to go on. The keyboard is read
   by the line. Single keys would need another mode of the terminal, in
   which a watch that is killed would leave it. */
static bool key_goes_on(const struct exercise *shown)
{
    static bool silent;
    char line[64] = "";
    struct pollfd keyboard = {.fd = STDIN_FILENO, .events = POLLIN};
    const nfds_t count = silent || !isatty(STDIN_FILENO) ? 0 : 1;
    if (poll(&keyboard, count, WATCH_PAUSE) <= 0)
        return true;
    silent = read(STDIN_FILENO, line, sizeof line - 1) <= 0;
    if (line[0] == 'h' && shown) {
        hint_show(shown);
        fflush(stdout);
    }
    return line[0] != 'q';
}

/* Checksums of forty files take less than half a millisecond, ten times a
   second. The systems' own ways to hear of a saved file differ, and have to
   be told again when an editor puts a new file in the place of the old one,
   as most do. */
static void look(struct course *course, const struct verdict_rules *rules,
                 struct seen seen[], const struct exercise **shown)
{
    for (size_t i = 0; i < course->count; ++i) {
        struct exercise *e = &course->exercises[i];
        if (!e->chosen || !saved(e, &seen[i]))
            continue;
        verdict_reach(e, rules);
        if (process_signal())
            return;
        show(course, e);
        *shown = e;
    }
}

void watch_files(struct course *course, const struct verdict_rules *rules)
{
    struct seen *seen = calloc(course->count, sizeof *seen);
    if (!seen)
        text_fail("out of memory");
    take_terminal();
    for (size_t i = 0; i < course->count; ++i)
        seen[i].judged = sum_file(0, course->exercises[i].file);
    puts("Looking at how things stand ...");
    fflush(stdout);
    for (size_t i = 0; i < course->count && !process_signal(); ++i)
        if (course->exercises[i].chosen)
            verdict_reach(&course->exercises[i], rules);
    const struct exercise *shown = round_current(course);
    if (!process_signal())
        show(course, shown);
    while (!process_signal() && key_goes_on(shown))
        look(course, rules, seen, &shown);
    free(seen);
    puts("\nThe watch has ended; your files are as you left them.");
}
