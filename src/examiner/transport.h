/* Sends messages between the judge and the sandbox, through two pipes. */
#ifndef TRANSPORT_H
#define TRANSPORT_H

#include <stdbool.h>
#include <stddef.h>

/* The first bytes of messages to the sandbox. */
enum {
    TRANSPORT_TEST = 't', /* start the process of a test */
    TRANSPORT_CALL = 'c', /* call the function; arguments follow */
    TRANSPORT_CALLBACK_REPLY = 'a', /* the answer to a callback follows */
    TRANSPORT_OVER = 'x',           /* the test is over */
    TRANSPORT_ECHO = 's'            /* the driver must return this byte */
};
/* The first bytes of messages from the sandbox. */
enum {
    TRANSPORT_BUILT = 'b',      /* the program is compiled and linked */
    TRANSPORT_NO_GNUPLOT = 'g', /* there is no gnuplot */
    TRANSPORT_READY = 'h',      /* the program has reached its main */
    TRANSPORT_CALLBACK = 'q',   /* number and arguments follow */
    TRANSPORT_OVERRUN = 'w',    /* a guard was changed; details follow */
    TRANSPORT_REPLY = 'r',      /* the values of the answer follow */
    TRANSPORT_NOT_DONE = 'u',   /* NOT_DONE_YET reached; its line follows */
    TRANSPORT_ENDED = 'e'       /* test ended; TRANSPORT_HOW ints follow */
};
/* The number of ints after TRANSPORT_ENDED: the status as waitpid gives it,
   and the processor time used (in ms). */
enum { TRANSPORT_HOW = 2 };

/* Opens the transport, to receive from one descriptor and send to the
   other. */
void transport_open(int receive, int send);

/* Begins a message with this byte. */
void transport_send(int word);

/* Sends the message and returns the first byte of the next one received, or
   EOF. */
int transport_receive(void);

/* true if this side sends, false if it receives */
extern bool transport_sending;

/* Sends or receives `bytes` bytes at x, depending on transport_sending.
   Messages contain no lengths. The receiver reads as many bytes as it
   expects, so that the other side cannot give a false length. */
void transport_move(void *x, size_t bytes);

/* Ends the program, because the other side has ended or sent nonsense. Each
   side has its own definition. */
_Noreturn void transport_lost(void);

#endif
