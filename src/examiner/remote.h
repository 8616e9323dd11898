/* Calls the student's function in another process. */
#ifndef REMOTE_H
#define REMOTE_H

#include <stdbool.h>
#include <stddef.h>

/* Send `count` numbers from x or, on the receiving side, receive them into
   x. Both sides must call the same functions in the same order; therefore
   each exercise has one function for its arguments, which both sides call.
   If the other side has ended, the program ends. An array that the student
   should only write to is sent as well: the suite has filled it in order to
   see which values stay unchanged, and the sandbox needs the same
   values. */
void remote_doubles(double x[], size_t count);
void remote_sizes(size_t x[], size_t count);
void remote_ints(int x[], size_t count);
void remote_unsigneds(unsigned x[], size_t count);
void remote_bools(bool x[], size_t count);

/* Returns memory for data that the student's function only reads; the
   caller frees it. The block has exactly this size, so that a sanitizer
   notices an access beyond its end. Ends the program if memory runs out. */
void *remote_memory(size_t bytes);

/* Returns memory as remote_memory does, for `count` elements of this size.
   Ends the program if the product is too large, since the other side may
   send any count. */
void *remote_array(size_t count, size_t size);

/* Returns count * size. Ends the program if the product exceeds an eighth
   of SIZE_MAX. */
size_t remote_bytes(size_t count, size_t size);

/* The number of blocks that remote_memory and remote_array have
   returned. */
extern unsigned long remote_blocks;

/* Makes the next call start in a new process, with fresh static variables.
   Does nothing if the student's function runs in this process. */
void remote_restart(void);

/* Begins a call of the student's function. Next, the caller must send the
   arguments. */
void remote_call(void);

/* Ends the arguments and waits for the answer. Meanwhile, serves callbacks
   by calling remote_serve_callback. Next, the caller must receive the
   values of the answer. */
void remote_wait(void);

/* Serves callback number `which` on the judge's side: receives the
   arguments, calls remote_callback_reply and sends the values of the
   answer. Defined by an exercise whose function takes a callback.

   It may also send the answers to the calls that are likely to come next.
   In exercise 12b the next step begins where the last one ended; in 03a the
   function halves an interval repeatedly. A wrong guess costs no more than
   the usual round trip. Guessing leaves only 4 to 30 percent of the round
   trips. The calls of 05c cannot be guessed. Instead, the sandbox has a
   copy of the disks and sends a list of all calls and results. The judge
   repeats the calls with its own disks and checks the results. Grading a
   course of 25 students took 10 s of processor time with a round trip for
   each call, and takes 2.5 s this way. */
void remote_serve_callback(int which);

/* Ends the arguments of a callback. Next, the caller must send the
   answer. */
void remote_callback_reply(void);

/* Serves a call on the side of the student's function: receives the
   arguments, calls the function, calls remote_reply and sends the values of
   the answer. Defined by each exercise. */
void remote_serve(void);

/* Returns memory for an output of the student's function, between two
   guards. It is freed at the next call. `name` is shown to a student whose
   function writes outside this memory. */
void *remote_output(const char *name, size_t bytes);

/* Return memory as remote_output does, for `count` numbers, and receive
   their initial values. */
double *remote_output_doubles(const char *name, size_t count);
size_t *remote_output_sizes(const char *name, size_t count);
int *remote_output_ints(const char *name, size_t count);

/* Checks the guards and ends the call. Next, the caller must send the
   values of the answer. */
void remote_reply(void);

/* Begins callback number `which` to the judge. Next, the caller must send
   its arguments. */
void remote_callback(int which);

/* Ends the arguments of the callback and waits. Next, the caller must
   receive the values of the answer. */
void remote_callback_wait(void);

#endif
