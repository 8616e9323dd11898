/* Writes the 17 digits of a double faster than printf. */
/* A program that writes a row for each of a million samples would spend
   most of its time in printf, which computes with integers of any length.
   Two machine words suffice for numbers from 1e-4 to 1e15, and nearly all
   numbers in our tables are in this range. */
#ifndef TOOLBOX_DIGITS_H
#define TOOLBOX_DIGITS_H

#include <stddef.h>

#define DIGITS_ROOM 32 /* bytes for any double and the final NUL */

/* Writes value with 17 significant digits to text. The bytes are those that
   printf writes for %.17g. Returns the length of text. */
size_t digits_write(char text[DIGITS_ROOM], double value);

#endif
