/* Detects an endless loop by a state that comes back. */
#ifndef ORBIT_H
#define ORBIT_H

/* From now on, and from its first fifth of a second on, this process looks
   whether it has been in its present state before, and ends by the signal
   REPORT_ENDLESS if so. A program that asks nobody is in a state (memory
   and registers) that decides the next one. So one that comes back to a
   state in which it was before goes round for ever and need not be waited
   for: a quarter of a second is enough in place of five. A loop that counts
   never comes back; but many a student's loop does not count: an interval
   is halved and no longer becomes shorter, a step has become too small to
   change the time. A timer interrupts the process after each hundredth of a
   second of its own and a number is made of the state. Of forty
   interruptions of a loop of a thousand instructions two fall on the same
   one more often than not (the birthdays in a class). Nearly all right
   answers have ended before the first look. */
void orbit_watch(void);

/* Notes that the process has got new input, after which no earlier state
   counts. */
void orbit_leave(void);

#endif
