/* The messages between judge and box. */
#ifndef TRANSPORT_H
#define TRANSPORT_H

#include <stdbool.h>
#include <stddef.h>

/* The first byte of a message to the box, */
enum {
    TRANSPORT_TEST = 't', /* make a process for a test */
    TRANSPORT_CALL = 'c', /* call the function; arguments follow */
    TRANSPORT_CALLBACK_REPLY = 'a', /* what was asked for follows */
    TRANSPORT_OVER = 'x',           /* the test is over */
    TRANSPORT_ECHO = 's' /* for the driver alone, which sends it back */
};
/* and of one from the box. */
enum {
    TRANSPORT_BUILT = 'b', /* the box's shell has compiled and linked */
    TRANSPORT_NO_GNUPLOT = 'g', /* the box's shell has found no gnuplot */
    TRANSPORT_READY = 'h',      /* the program has come to its main */
    TRANSPORT_CALLBACK =
        'q', /* the number of a function and its arguments */
    TRANSPORT_OVERRUN = 'w',  /* a guard was changed: which, then a reply */
    TRANSPORT_REPLY = 'r',    /* the values of the answer follow */
    TRANSPORT_NOT_DONE = 'u', /* a NOT_DONE_YET was reached, and its line */
    TRANSPORT_ENDED =
        'e' /* the test's process ended; how: TRANSPORT_HOW ints */
};
/* What follows TRANSPORT_ENDED: its status, as waitpid gives it, and how
   many milliseconds of the processor's time it has used. */
enum { TRANSPORT_HOW = 2 };

/* Receives from one descriptor and sends to the other from now on. */
void transport_open(int listen, int speak);

/* Begins a message with this byte. */
void transport_send(int word);

/* Sends the message and returns the first byte of the next one received, or
   EOF. */
int transport_receive(void);

/* Whether it is this side's turn to send. */
extern bool transport_sending;

/* Sends or receives so many bytes, whichever is this side's turn. No
   message says how long it is: the receiver takes what it waits for, so
   that there is no length about which the other side could lie. */
void transport_move(void *x, size_t bytes);

/* Defined by each side: ends it when its partner is gone or sends
   nonsense. */
_Noreturn void transport_lost(void);

#endif
