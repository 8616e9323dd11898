/* Sends and receives messages through two pipes. */
#include "examiner/wire.h"

#include <stdio.h>

static FILE *ear, *mouth;

void wire_open(int listen, int speak)
{
    static char heard[4096], spoken[4096];
    ear = fdopen(listen, "r");
    mouth = fdopen(speak, "w");
    if (!ear || !mouth)
        wire_lost();
    setvbuf(ear, heard, _IOFBF, sizeof heard);
    setvbuf(mouth, spoken, _IOFBF, sizeof spoken);
}

void wire_speak(int word)
{
    wire_speaking = true;
    putc(word, mouth);
}

/* Flushes what was sent and receives the first byte of a message. The
   stream in our direction is flushed when the turn changes and only then,
   so that a short call is a single write. */
int wire_listen(void)
{
    if (fflush(mouth) != 0)
        wire_lost();
    wire_speaking = false;
    return getc(ear);
}

void wire_move(void *x, size_t bytes)
{
    const size_t moved = wire_speaking ? fwrite(x, 1, bytes, mouth)
                                       : fread(x, 1, bytes, ear);
    if (moved != bytes)
        wire_lost();
}
