/* Calls the student's function in the same process, without a sandbox. */
#include "examiner/remote.h"
#include "examiner/check.h"
#include "examiner/guards.h"
#include "examiner/transport.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void transport_lost(void)
{
    _exit(EXIT_FAILURE);
}

static unsigned char *messages;
static size_t capacity, sent, received;

static void grow(size_t bytes)
{
    unsigned char *longer = realloc(messages, bytes);
    if (!longer)
        transport_lost();
    messages = longer;
    capacity = bytes;
}

/* Sends bytes by copying them into `messages`, or receives bytes by copying
   them out. So the student's function gets its arguments in the same kind
   of memory as in the grader. Both sides and the function are linked into
   one program, in which a name can be defined only once. Therefore the
   makefile renames the functions of the suite, for example to
   suite_velocities_after. */
void transport_move(void *x, size_t bytes)
{
    if (transport_sending && capacity - sent <= bytes)
        grow(2 * (sent + bytes) + 1);
    if (!transport_sending && sent - received < bytes)
        transport_lost();
    if (transport_sending)
        memcpy(messages + sent, x, bytes);
    else
        memcpy(x, messages + received, bytes);
    *(transport_sending ? &sent : &received) += bytes;
}

static void set_sending(bool on)
{
    if (on)
        sent = received = 0;
    transport_sending = on;
}

void remote_call(void)
{
    guards_clear();
    set_sending(true);
}

/* Runs the other side, which produces the answer. */
void remote_wait(void)
{
    set_sending(false);
    remote_serve();
    set_sending(false);
}

void remote_reply(void)
{
    struct check_overrun overrun;
    if (guards_overrun(&overrun))
        check_overrun(&overrun);
    set_sending(true);
}
void remote_restart(void)
{
}

static int callback;

void remote_callback(int which)
{
    callback = which;
    set_sending(true);
}

void remote_callback_wait(void)
{
    set_sending(false);
    remote_serve_callback(callback);
    set_sending(false);
}

void remote_callback_reply(void)
{
    set_sending(true);
}
