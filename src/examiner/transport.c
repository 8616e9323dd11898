/* Sends and receives messages through two pipes. */
#include "examiner/transport.h"

#include <stdio.h>

static FILE *in, *out;

void transport_open(int receive, int send)
{
    static char received[4096], sent[4096];
    in = fdopen(receive, "r");
    out = fdopen(send, "w");
    if (!in || !out)
        transport_lost();
    setvbuf(in, received, _IOFBF, sizeof received);
    setvbuf(out, sent, _IOFBF, sizeof sent);
}

void transport_send(int word)
{
    transport_sending = true;
    putc(word, out);
}

/* Flushes the messages sent, then receives the first byte of the next
   one. Messages are flushed only here, so that a short call is a single
   write. */
int transport_receive(void)
{
    if (fflush(out) != 0)
        transport_lost();
    transport_sending = false;
    return getc(in);
}

void transport_move(void *x, size_t bytes)
{
    const size_t moved = transport_sending ? fwrite(x, 1, bytes, out)
                                           : fread(x, 1, bytes, in);
    if (moved != bytes)
        transport_lost();
}
