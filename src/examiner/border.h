/* What crosses to the student's function and back, number by number. */
#ifndef BORDER_H
#define BORDER_H

#include <stdbool.h>
#include <stddef.h>

/* Move count numbers across the border: out of x on the side that speaks,
   into x on the side that listens. Both sides must move the same kinds of
   numbers in the same order; a side that finds no partner ends. The two
   sides call the same functions for the arguments of a function, so that
   they cannot disagree about their order. An array that the student should
   only write to crosses on the way in, too: the suite has filled it to see
   what is left untouched, and that must look the same from the box. */
void border_doubles(double x[], size_t count);
void border_sizes(size_t x[], size_t count);
void border_ints(int x[], size_t count);
void border_unsigneds(unsigned x[], size_t count);
void border_bools(bool x[], size_t count);

/* Memory of just this size for what the student's function only reads, so
   that a sanitizer notices who goes beyond it, for the caller to free; ends
   the program when there is none. */
void *border_memory(size_t bytes);

/* The same for count elements of so many bytes. Counts that come from the
   other side may be anything: one whose product with the size is too large
   for a size_t ends the program. */
void *border_array(size_t count, size_t size);

/* Returns that product, or ends the program. */
size_t border_bytes(size_t count, size_t size);

/* How many times it has given some. */
extern unsigned long border_blocks;

/* Has the next call made in a process in which the function has not been
   called before, so that it knows of no other call; at home, where judge
   and box are one process, it does nothing. */
void border_anew(void);

/* Begins a call of the function in the box: its arguments follow. */
void border_call(void);

/* Ends the arguments and waits for the answer: its values follow. While it
   waits, it serves what the box asks for by border_heed. */
void border_wait(void);

/* Defined by an exercise whose functions call back, where the judge is:
   takes the arguments of function number `which`, calls border_tell and
   moves the values of the answer. The judge may also answer what was not
   asked yet: a function that makes a step in 12b goes on from where it
   ended, one that has tried a length in 08d tries the next, and one that
   halves an interval in 03a halves one of the halves. A wrong guess costs
   no more than the question; of a hundred round trips four to thirty are
   left. 05c cannot be guessed, so the box gets a copy of the disks, and a
   list of all that was done and asked crosses when it is full. The judge
   does it over again with its own disks and judges those. A course of 25
   took 10 s of processor time when each of its questions went through two
   pipes, and takes 2.5 s. */
void border_heed(int which);

/* Ends the arguments of what the box has asked: the answer follows. */
void border_tell(void);

/* Defined by the exercise: takes the arguments, calls the student's
   function, calls border_reply and moves the values of the answer. */
void border_answer(void);

/* A place for what the student's function may write: so many bytes, alone
   in memory, with a guard before and a guard behind. The name is for who
   writes outside of it. It is freed when the next call comes. */
void *border_place(const char *name, size_t bytes);

/* The same, with the next of the arguments in it. */
double *border_place_doubles(const char *name, size_t count);
size_t *border_place_sizes(const char *name, size_t count);
int *border_place_ints(const char *name, size_t count);

/* Ends the arguments: the values of the answer follow. Whoever has written
   outside of a place is found out here. */
void border_reply(void);

/* Asks the judge to call function number `which`: the arguments follow. */
void border_ask(int which);

/* Ends those arguments and waits: the values of the answer follow. */
void border_hear(void);

#endif
