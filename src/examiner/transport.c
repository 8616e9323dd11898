/* Sends and receives messages through two pipes. */
#include "examiner/transport.h"

#include <stdio.h>

static FILE *ear, *mouth;

void transport_open(int listen, int speak)
{
    static char heard[4096], spoken[4096];
    ear = fdopen(listen, "r");
    mouth = fdopen(speak, "w");
    if (!ear || !mouth)
        transport_lost();
    setvbuf(ear, heard, _IOFBF, sizeof heard);
    setvbuf(mouth, spoken, _IOFBF, sizeof spoken);
}

void transport_send(int word)
{
    transport_sending = true;
    putc(word, mouth);
}

/* Flushes what was sent and receives the first byte of a message. The
   stream in our direction is flushed when the turn changes and only then,
   so that a short call is a single write. */
int transport_receive(void)
{
    if (fflush(mouth) != 0)
        transport_lost();
    transport_sending = false;
    return getc(ear);
}

void transport_move(void *x, size_t bytes)
{
    const size_t moved = transport_sending ? fwrite(x, 1, bytes, mouth)
                                           : fread(x, 1, bytes, ear);
    if (moved != bytes)
        transport_lost();
}
