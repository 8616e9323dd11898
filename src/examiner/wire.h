/* The messages between judge and box. */
#ifndef WIRE_H
#define WIRE_H

#include <stdbool.h>
#include <stddef.h>

/* The first byte of a message to the box, */
enum {
    WIRE_TEST = 't', /* make a process for a test */
    WIRE_CALL = 'c', /* call the function; arguments follow */
    WIRE_TOLD = 'a', /* what was asked for follows */
    WIRE_OVER = 'x', /* the test is over */
    WIRE_ECHO = 's'  /* for the driver alone, which sends it back */
};
/* and of one from the box. */
enum {
    WIRE_BUILT = 'b',  /* the box's shell has compiled and linked */
    WIRE_BARE = 'g',   /* the box's shell has found no gnuplot */
    WIRE_READY = 'h',  /* the program has come to its main */
    WIRE_ASK = 'q',    /* the number of a function and its arguments */
    WIRE_LEFT = 'w',   /* a guard was changed: which, then a reply */
    WIRE_REPLY = 'r',  /* the values of the answer follow */
    WIRE_UNDONE = 'u', /* a NOT_DONE_YET was reached, and its line */
    WIRE_ENDED = 'e'   /* the test's process ended; how: WIRE_HOW ints */
};
/* What follows WIRE_ENDED: its status, as waitpid gives it, and how many
   milliseconds of the processor's time it has used. */
enum { WIRE_HOW = 2 };

/* Receives from one descriptor and sends to the other from now on. */
void wire_open(int listen, int speak);

/* Begins a message with this byte. */
void wire_speak(int word);

/* Sends the message and returns the first byte of the next one received, or
   EOF. */
int wire_listen(void);

/* Whether it is this side's turn to send. */
extern bool wire_speaking;

/* Sends or receives so many bytes, whichever is this side's turn. No
   message says how long it is: the receiver takes what it waits for, so
   that there is no length about which the other side could lie. */
void wire_move(void *x, size_t bytes);

/* Defined by each side: ends it when its partner is gone or sends
   nonsense. */
_Noreturn void wire_lost(void);

#endif
