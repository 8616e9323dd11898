/* Calls the student's function in another process, number by number. */
#ifndef REMOTE_H
#define REMOTE_H

#include <stdbool.h>
#include <stddef.h>

/* Move count numbers from the side that sends, out of x, to the side that
   receives, into x. Both sides must call the same functions in the same
   order, so an exercise has one function for the arguments, which both
   call; a side that is left without a partner ends. An array that the
   student should only write to is sent along with the arguments: the suite
   has filled it to see what stays untouched, and it has to look the same
   in the sandbox. */
void remote_doubles(double x[], size_t count);
void remote_sizes(size_t x[], size_t count);
void remote_ints(int x[], size_t count);
void remote_unsigneds(unsigned x[], size_t count);
void remote_bools(bool x[], size_t count);

/* Returns memory of exactly this size for what the student's function only
   reads, so that a sanitizer notices an access beyond its end. The caller
   frees it. Ends the program when there is none. */
void *remote_memory(size_t bytes);

/* Returns such memory for count elements of this size. A count from the
   other side may be any number: if the product does not fit a size_t the
   program ends. */
void *remote_array(size_t count, size_t size);

/* Returns that product, or ends the program. */
size_t remote_bytes(size_t count, size_t size);

/* Counts the blocks that remote_memory and remote_array have returned. */
extern unsigned long remote_blocks;

/* Makes the next call start in a new process, with fresh static variables.
   At home, where there is one process, it does nothing. */
void remote_restart(void);

/* Begins a call of the student's function: send its arguments next. */
void remote_call(void);

/* Ends the arguments and waits for the answer: receive its values next.
   Meanwhile callbacks are served by remote_serve_callback. */
void remote_wait(void);

/* Defined by an exercise whose functions take a function, on the judge's
   side: receives the arguments of callback number `which`, calls
   remote_callback_reply and sends the values of the answer.

   It may also send answers that were not asked for yet: a function that
   makes a step in 12b goes on from where it ended, one that has tried a
   length in 08d tries the next, and one that halves an interval in 03a
   halves one of the halves. A wrong guess costs no more than the question;
   of a hundred round trips four to thirty are left. What 05c asks cannot
   be guessed. There the sandbox has a copy of the disks and sends a list
   of all that was done and asked, whenever the list is full; the judge
   repeats it with disks of its own and checks those. A course of 25 took
   10 s of processor time when each question went through two pipes, and
   takes 2.5 s. */
void remote_serve_callback(int which);

/* Ends the arguments of a callback: send its answer next. */
void remote_callback_reply(void);

/* Defined by the exercise, on the server's side: receives the arguments,
   calls the student's function, calls remote_reply and sends the values of
   the answer. */
void remote_serve(void);

/* Returns memory for an output of the student's function, between two
   guards; it is freed when the next call comes. A student whose function
   writes outside of it is told the name. */
void *remote_output(const char *name, size_t bytes);

/* Return such memory for count numbers, filled with the next ones received.
 */
double *remote_output_doubles(const char *name, size_t count);
size_t *remote_output_sizes(const char *name, size_t count);
int *remote_output_ints(const char *name, size_t count);

/* Ends the call, after a look at the guards: send the values of the answer
   next. */
void remote_reply(void);

/* Begins callback number `which` to the judge: send its arguments next. */
void remote_callback(int which);

/* Ends the arguments of the callback and waits: receive the values of the
   answer next. */
void remote_callback_wait(void);

#endif
