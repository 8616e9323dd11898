/* Writes the 17 digits of a double faster than printf. */
/* A program that writes a row for each of a million samples would spend
   most of its time in printf, which uses integers of any length, while two
   machine words suffice for the numbers from 1e-4 to 1e15, nearly all in
   our tables. */
#ifndef TOOLBOX_DIGITS_H
#define TOOLBOX_DIGITS_H

#include <stddef.h>

#define DIGITS_ROOM 32 /* bytes for any double and the final NUL */

/* Writes value with 17 significant digits: the bytes that printf writes for
   %.17g. Returns their number, without the final NUL. */
size_t digits_write(char text[DIGITS_ROOM], double value);

#endif
