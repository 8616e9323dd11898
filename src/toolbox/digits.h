/* Writes the 17 digits of a double faster than printf. */
/* A program that writes a row for each of a million samples spends most of
   its time there: printf handles any number of digits with numbers of any
   length, while nearly all numbers of our tables lie from 1e-4 to 1e15,
   where two machine words suffice. */
#ifndef TOOLBOX_DIGITS_H
#define TOOLBOX_DIGITS_H

#include <stddef.h>

#define DIGITS_ROOM 32 /* for any double, with the zero that ends it */

/* Writes value with 17 significant digits: the bytes that printf writes
   for %.17g. Returns how many they are, without the zero behind them. */
size_t digits_write(char text[DIGITS_ROOM], double value);

#endif
