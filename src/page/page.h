/* The functions of a live figure that its script calls from JavaScript. */
#ifndef PAGE_H
#define PAGE_H

#include <stdbool.h>

/* Each figure is a program of its own, so all of them define these names.
   Numbers are passed as doubles, the only numbers of JavaScript, and
   through arrays in memory that both sides see, so that the functions have
   the same parameters in every figure. No function reads a clock: the
   script asks for as much time as the last picture was shown. The results
   depend neither on the number of calls of page_run nor on the speed of the
   browser. */

enum { PAGE_NUMBERS = 64 };

/* The parameters of a run, which the script writes before page_begin; each
   figure lists them at its definition of page_number. */
extern double page_number[PAGE_NUMBERS];

/* Starts a new run and frees the old one. Returns false if it cannot: the
   parameters are out of range, or memory is short. */
bool page_begin(void);

/* Runs until the time `until`, or for this number of events, whichever ends
   first; an event is a collision, a step or a record, as the figure says.
   Returns the number of events in this call. Requires events < 2^63. */
double page_run(double until, double events);

/* Copies the present state into an array and returns it; the time is
   first. */
const double *page_look(void);

/* Functions of some figures only. page_word returns the name of item
   `number` of a list, NULL after the last; page_array returns more numbers;
   page_make does what the reader did with the mouse or a menu. */
const char *page_word(double number);
const double *page_array(double which);
bool page_make(double number);

#endif
