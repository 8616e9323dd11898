/* The words that judge and box exchange. */
#ifndef WIRE_H
#define WIRE_H

#include <stdbool.h>
#include <stddef.h>

/* What a message begins with. To the box: */
enum {
    WIRE_TEST = 't', /* make a process for a test */
    WIRE_CALL = 'c', /* call the function; arguments follow */
    WIRE_TOLD = 'a', /* what was asked for follows */
    WIRE_OVER = 'x', /* the test is over */
    WIRE_ECHO = 's'  /* for nobody but the driver, who repeats it */
};
/* From the box: */
enum {
    WIRE_BUILT = 'b',  /* said by the box's shell: compiled and linked */
    WIRE_BARE = 'g',   /* said by the same: there is no gnuplot */
    WIRE_READY = 'h',  /* the program has come to its main */
    WIRE_ASK = 'q',    /* the number of a function and its arguments */
    WIRE_LEFT = 'w',   /* a place was left: how follows, then a reply */
    WIRE_REPLY = 'r',  /* the values of the answer follow */
    WIRE_UNDONE = 'u', /* a NOT_DONE_YET was reached, and its line */
    WIRE_ENDED = 'e'   /* the test's process ended; how: WIRE_HOW ints */
};
/* What follows WIRE_ENDED: its status, as waitpid gives it, and how many
   milliseconds of the processor's time it has used. */
enum { WIRE_HOW = 2 };

/* Listens at one descriptor and speaks into the other from now on. */
void wire_open(int listen, int speak);

/* Begins to speak, with this word. */
void wire_speak(int word);

/* Sends what was spoken and returns the next word heard, or EOF. */
int wire_listen(void);

/* Whether it is our turn to speak. */
extern bool wire_speaking;

/* Moves so many bytes in the direction of the turn. Nothing in a message
   says how long it is: the listener takes what it waits for, so that there
   is no length about which the other side could lie. */
void wire_move(void *x, size_t bytes);

/* Defined by each side: what it does when its partner is gone or talks
   nonsense. */
_Noreturn void wire_lost(void);

#endif
