/* From chapters/works/B-grader.nw: edit there, then run make tangle. */
/* checksum 1109361180 of the lines below */
/* The judge's half of the border: questions go out, answers come in. */
#include "examiner/border.h"
#include "examiner/check.h"
#include "examiner/exercise.h"
#include "examiner/wire.h"

#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

enum { ANSWERS = 5, REQUESTS = 6 };

void wire_lost(void)
{
    _exit(EXIT_FAILURE);
}

static _Noreturn void end_like(int status)
{
    if (WIFSIGNALED(status)) {
        signal(WTERMSIG(status), SIG_DFL);
        raise(WTERMSIG(status));
    }
    _exit(WEXITSTATUS(status));
}

static bool opened, begun, calling;

static void break_off(void)
{
    int how[WIRE_HOW];
    wire_speak(WIRE_OVER);
    if (wire_listen() != WIRE_ENDED)
        wire_lost();
    border_ints(how, WIRE_HOW);
    begun = calling = false;
}

void border_call(void)
{
    if (!opened) {
        signal(SIGPIPE, SIG_IGN);
        wire_open(ANSWERS, REQUESTS);
        opened = true;
    }
    if (calling)
        break_off();
    if (!begun)
        wire_speak(WIRE_TEST);
    begun = calling = true;
    wire_speak(WIRE_CALL);
}

static void heed(int word)
{
    struct check_overrun overrun;
    int number;
    if (word == WIRE_ASK) {
        border_ints(&number, 1);
        border_heed(number);
    } else {
        wire_move(&overrun, sizeof overrun);
        check_overrun(&overrun);
    }
}

void border_wait(void)
{
    int word, line, how[WIRE_HOW];
    while ((word = wire_listen()) == WIRE_ASK || word == WIRE_LEFT)
        heed(word);
    if (word == WIRE_UNDONE) {
        border_ints(&line, 1);
        exercise_not_done("line", line);
    }
    if (word == WIRE_ENDED) {
        border_ints(how, WIRE_HOW);
        end_like(how[0]);
    }
    if (word != WIRE_REPLY)
        wire_lost();
    calling = false;
}

void border_tell(void)
{
    wire_speak(WIRE_TOLD);
}
