/* From chapters/works/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 1538412231 of the lines below */
/* The digits of a double, written fast. */
#ifndef TOOLBOX_DIGITS_H
#define TOOLBOX_DIGITS_H

#include <stddef.h>

#define DIGITS_ROOM 32 /* for any double, with the zero that ends it */

/* Writes value with 17 significant digits: the bytes that printf writes
   for %.17g. Returns how many they are, without the zero behind them. */
size_t digits_write(char text[DIGITS_ROOM], double value);

#endif
