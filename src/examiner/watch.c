/* Checks the files and the keyboard ten times a second. */
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

/* Puts this process into the terminal's foreground, in a process group of
   its own. Ctrl-C goes to every process of the foreground group; if make
   were among them, it would end with an error message. Ctrl-Z is ignored;
   otherwise make would wait for ever. */
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
    uint64_t judged, last; /* checksums as last judged and last seen */
};

/* Returns whether a file was saved and must be judged. Its checksum must
   differ from that of the file last judged. It must also be the same as at
   the previous check, because an editor may empty a file before writing it.
   If the editor pauses for more than a tenth of a second in between, half a
   file is judged. */
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

enum { WATCH_PAUSE = 100 }; /* time between two checks, ms */

/* Waits a tenth of a second for a command from the keyboard. Returns
   whether to continue. A command ends with Enter: reading single keys would
   need another mode of the terminal, which would remain if this process
   were killed. */
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

/* Judges every chosen file that was saved. This computes forty checksums
   ten times a second; each time takes half a millisecond. Notifications of
   changed files differ between systems, and fail if an editor replaces the
   file, as most editors do. */
static void judge_saved(struct course *course,
                        const struct verdict_rules *rules,
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
    struct seen *seen = text_must(calloc(course->count, sizeof *seen));
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
        judge_saved(course, rules, seen, &shown);
    free(seen);
    puts("\nThe watch has ended; your files are as you left them.");
}
