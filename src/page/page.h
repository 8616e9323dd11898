/* Declares the functions of a live figure that its script calls. */
#ifndef PAGE_H
#define PAGE_H

#include <stdbool.h>

/* Each figure is a program of its own, so all figures define these names.
   Numbers are passed as doubles, the only numbers of JavaScript, and
   through arrays in memory that both sides see. So the functions have the
   same parameters in every figure. No function reads a clock: for each
   picture, the script asks for as much simulated time as the previous
   picture was on the screen. The results depend neither on the number of
   calls of page_run nor on the speed of the browser. */

enum { PAGE_NUMBERS = 64 };

/* The parameters of a run. The script writes them before page_begin. Each
   figure lists them at its definition of page_number. */
extern double page_number[PAGE_NUMBERS];

/* Starts a new run and frees the old one. Returns false if the parameters
   are out of range or memory runs out. */
bool page_begin(void);

/* Runs until the time `until` or for `events` events, whichever ends
   first. An event is a collision, a step or a record, depending on the
   figure. Returns the number of events in this call. Requires events <
   2^63. */
double page_run(double until, double events);

/* Copies the present state into an array and returns it. The first number
   is the time. */
const double *page_look(void);

/* Functions that only some figures have. page_word returns the name of
   item `number` of a list, or NULL after the last item. page_array returns
   another array of numbers. page_make carries out what the reader chose
   with the mouse or a menu. */
const char *page_word(double number);
const double *page_array(double which);
bool page_make(double number);

#endif
