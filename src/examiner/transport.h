/* The messages between the judge and the sandbox, through two pipes. */
#ifndef TRANSPORT_H
#define TRANSPORT_H

#include <stdbool.h>
#include <stddef.h>

/* The first byte of a message to the sandbox, */
enum {
    TRANSPORT_TEST = 't', /* start the process of a test */
    TRANSPORT_CALL = 'c', /* call the function; arguments follow */
    TRANSPORT_CALLBACK_REPLY = 'a', /* the answer to a callback follows */
    TRANSPORT_OVER = 'x',           /* the test is over */
    TRANSPORT_ECHO = 's'            /* the driver sends it back */
};
/* and of one from the sandbox. */
enum {
    TRANSPORT_BUILT = 'b',      /* the program is compiled and linked */
    TRANSPORT_NO_GNUPLOT = 'g', /* there is no gnuplot */
    TRANSPORT_READY = 'h',      /* the program has reached its main */
    TRANSPORT_CALLBACK =
        'q', /* a callback: its number and arguments follow */
    TRANSPORT_OVERRUN = 'w',  /* a guard was changed: which, then a reply */
    TRANSPORT_REPLY = 'r',    /* the values of the answer follow */
    TRANSPORT_NOT_DONE = 'u', /* a NOT_DONE_YET was reached, and its line */
    TRANSPORT_ENDED =
        'e' /* the test's process ended; how: TRANSPORT_HOW ints */
};
/* The ints behind TRANSPORT_ENDED: the status as waitpid gives it, and the
   processor time used, in milliseconds. */
enum { TRANSPORT_HOW = 2 };

/* Opens the transport: receives from one descriptor, sends to the
   other. */
void transport_open(int receive, int send);

/* Begins a message with this byte. */
void transport_send(int word);

/* Sends the message and returns the first byte of the next one received, or
   EOF. */
int transport_receive(void);

/* Whether it is this side's turn to send. */
extern bool transport_sending;

/* Sends or receives this many bytes, whichever is this side's turn. No
   message has a length: the receiver takes what it waits for, so that
   there is no length about which the other side could lie. */
void transport_move(void *x, size_t bytes);

/* Defined by each side: ends the program, because its partner has ended or
   sent what makes no sense. */
_Noreturn void transport_lost(void);

#endif
