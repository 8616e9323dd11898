/* From chapters/works/A-page.nw: edit there, then run make tangle. */
/* checksum 783376808 of the lines below */
/* What the script of a figure asks for; each front has it in its way. */
#ifndef PAGE_H
#define PAGE_H

#include <stdbool.h>

enum { PAGE_NUMBERS = 64 };

/* With what a run begins; each front says what its numbers mean. */
extern double page_number[PAGE_NUMBERS];

/* Begins anew. Returns false when that cannot be. */
bool page_begin(void);

/* Runs until the time `until`, or until so many more events have taken
   place (collisions, steps, records: the front says which), whichever
   comes first. Returns how many did. Requires events < 2^63. */
double page_run(double until, double events);

/* Notes where everything is now; returns the numbers, the time first. */
const double *page_look(void);

/* Not every front has these: the name of a thing of which there are
   several, NULL behind the last; more numbers; what the hand has done. */
const char *page_word(double number);
const double *page_array(double which);
bool page_make(double number);

#endif
