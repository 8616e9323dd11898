/* Remote calls of the student's function, number by number. */
#ifndef REMOTE_H
#define REMOTE_H

#include <stdbool.h>
#include <stddef.h>

/* Move count numbers between judge and box: out of x on the side that
   sends, into x on the side that receives. Both sides must move the same
   kinds of numbers in the same order; a side that finds no partner ends.
   Both call the same functions for the arguments, so that they cannot
   disagree about the order. An array that the student should only write to
   is sent along with the arguments, too: the suite has filled it to see
   what is left untouched, and that must look the same in the box. */
void remote_doubles(double x[], size_t count);
void remote_sizes(size_t x[], size_t count);
void remote_ints(int x[], size_t count);
void remote_unsigneds(unsigned x[], size_t count);
void remote_bools(bool x[], size_t count);

/* Returns memory of just this size for what the student's function only
   reads, so that a sanitizer notices an access beyond it, for the caller to
   free. Ends the program when there is none. */
void *remote_memory(size_t bytes);

/* The same for count elements of so many bytes. A count that comes from the
   other side may be any number: one whose product with the size does not
   fit a size_t ends the program. */
void *remote_array(size_t count, size_t size);

/* Returns that product, or ends the program. */
size_t remote_bytes(size_t count, size_t size);

/* Counts the blocks that remote_memory and remote_array have returned. */
extern unsigned long remote_blocks;

/* Makes the next call go to a new process, so that the function knows of no
   other call. At home, where judge and box are one process, it does
   nothing. */
void remote_restart(void);

/* Begins a call of the student's function in the box: send its arguments
   next. */
void remote_call(void);

/* Ends the arguments and waits for the answer: receive its values next.
   Calls that the box makes back meanwhile are served by
   remote_serve_callback. */
void remote_wait(void);

/* Defined by an exercise whose functions call back, where the judge is:
   takes the arguments of function number `which`, calls
   remote_callback_reply and moves the values of the answer. The judge may
   also answer what was not asked yet: a function that makes a step in 12b
   goes on from where it ended, one that has tried a length in 08d tries the
   next, and one that halves an interval in 03a halves one of the halves. A
   wrong guess costs no more than the question; of a hundred round trips
   four to thirty are left. 05c cannot be guessed, so the box gets a copy of
   the disks, and a list of all that was done and asked crosses when it is
   full. The judge does it over again with its own disks and judges those. A
   course of 25 took 10 s of processor time when each of its questions went
   through two pipes, and takes 2.5 s. */
void remote_serve_callback(int which);

/* Ends the arguments of a call back: send its answer next. */
void remote_callback_reply(void);

/* Defined by the exercise: takes the arguments, calls the student's
   function, calls remote_reply and moves the values of the answer. */
void remote_serve(void);

/* Returns so many bytes for what the student's function may write, between
   two guards. The name is told to a student whose function writes outside
   of it. It is freed when the next call comes. */
void *remote_output(const char *name, size_t bytes);

/* The same, filled with the next of the arguments. */
double *remote_output_doubles(const char *name, size_t count);
size_t *remote_output_sizes(const char *name, size_t count);
int *remote_output_ints(const char *name, size_t count);

/* Ends the call: send the values of its answer next. Looks at the guards
   first. */
void remote_reply(void);

/* Begins a call back, of function number `which` in the judge: send its
   arguments next. */
void remote_callback(int which);

/* Ends those arguments and waits: receive the values of the answer next. */
void remote_callback_wait(void);

#endif
