/* Calls the student's function in another process, one number at a time. */
#ifndef REMOTE_H
#define REMOTE_H

#include <stdbool.h>
#include <stddef.h>

/* Move count numbers from the side that sends, out of x, to the side that
   receives, into x. Both sides must call the same functions in the same
   order, so an exercise has one function for the arguments, which both
   call; a side without a partner ends. An array that the student should
   only write to is sent along with the arguments: the suite has filled it
   to see which values stay, and the sandbox needs the same values in it. */
void remote_doubles(double x[], size_t count);
void remote_sizes(size_t x[], size_t count);
void remote_ints(int x[], size_t count);
void remote_unsigneds(unsigned x[], size_t count);
void remote_bools(bool x[], size_t count);

/* Returns memory of exactly this size for data that the student's function
   only reads, so that a sanitizer notices an access beyond its end. The
   caller frees it. Ends the program when there is no memory. */
void *remote_memory(size_t bytes);

/* Returns memory like remote_memory for count elements of this size. A
   count from the other side may be any number: if the product does not fit
   a size_t the program ends. */
void *remote_array(size_t count, size_t size);

/* Returns count * size, or ends the program if that does not fit. */
size_t remote_bytes(size_t count, size_t size);

/* Counts the blocks that remote_memory and remote_array have returned. */
extern unsigned long remote_blocks;

/* Makes the next call start in a new process, with fresh static variables.
   At home, where there is one process, it does nothing. */
void remote_restart(void);

/* Begins a call of the student's function: the caller sends the arguments
   next. */
void remote_call(void);

/* Ends the arguments and waits for the answer: the caller receives its
   values next. Meanwhile callbacks are served by remote_serve_callback. */
void remote_wait(void);

/* Serves callback number `which`; defined, on the judge's side, by an
   exercise whose functions take a function: receives the arguments, calls
   remote_callback_reply and sends the values of the answer.

   It may also send answers to likely next calls: a function that makes a
   step in 12b goes on from where it ended, one that has tried a length in
   08d tries the next, and one that halves an interval in 03a halves one of
   the halves. A wrong guess costs no more than the call; of a hundred round
   trips four to thirty are left. The calls of 05c cannot be guessed. There
   the sandbox has a copy of the disks and sends a list of all calls and
   results whenever the list is full; the judge repeats them with disks of
   its own and checks the results. A course of 25 took 10 s of processor
   time when each call went through two pipes, and takes 2.5 s. */
void remote_serve_callback(int which);

/* Ends the arguments of a callback: the caller sends its answer next. */
void remote_callback_reply(void);

/* Serves a call, on the server's side; defined by the exercise: receives
   the arguments, calls the student's function, calls remote_reply and sends
   the values of the answer. */
void remote_serve(void);

/* Returns memory for an output of the student's function, between two
   guards; it is freed at the next call. The name is told to a student whose
   function writes outside of it. */
void *remote_output(const char *name, size_t bytes);

/* Return memory like remote_output for count numbers, and receive them. */
double *remote_output_doubles(const char *name, size_t count);
size_t *remote_output_sizes(const char *name, size_t count);
int *remote_output_ints(const char *name, size_t count);

/* Ends the call, after a check of the guards: the caller sends the values
   of the answer next. */
void remote_reply(void);

/* Begins callback number `which` to the judge: the caller sends its
   arguments next. */
void remote_callback(int which);

/* Ends the arguments of the callback and waits: the caller receives the
   values of the answer next. */
void remote_callback_wait(void);

#endif
