/* Detects endless loops: the process comes back to an earlier state. */
#ifndef ENDLESS_H
#define ENDLESS_H

/* Begins to watch this process for an endless loop. Every hundredth of a
   second of processor time, from a fifth of a second on, a timer computes a
   checksum of memory and registers; if that state occurred before, the
   process ends by the signal REPORT_ENDLESS. Without new input the state
   determines all that follows, so a process that returns to a state repeats
   itself for ever. That is found after a quarter of a second instead of the
   limit of five seconds.

   A loop that counts never returns to a state, but many students' loops do
   not count: an interval is halved until it no longer shrinks, a step has
   become too small to change the time. If the loop has a thousand
   instructions, two of forty interruptions probably come at the same one
   (like birthdays in a class). Nearly all right answers end before the
   first check. */
void endless_watch(void);

/* Discards earlier states, because the process has read new input. */
void endless_forget(void);

#endif
