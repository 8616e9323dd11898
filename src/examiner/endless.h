/* Detects endless loops: the process returns to an earlier state. */
#ifndef ENDLESS_H
#define ENDLESS_H

/* Starts to watch this process for an endless loop. When the process has
   used 0.2 s of processor time, and then every 0.01 s, a timer computes a
   checksum of memory and registers. If the same checksum occurred before,
   the process ends with the signal REPORT_ENDLESS. Without new input, the
   state determines everything that follows, so a process that returns to a
   state repeats itself for ever. This takes a quarter of a second, while
   the limit on processor time is five seconds.

   A loop that counts never returns to a state, but many students' loops do
   not count. For example, an interval is halved until it does not shrink
   any further, or a step has become too small to change the time. If such a
   loop has a thousand instructions, two of forty interruptions probably hit
   the same instruction (the birthday problem). Nearly all right answers end
   before the first check. */
void endless_watch(void);

/* Discards earlier states. Must be called whenever the process has read new
   input. */
void endless_forget(void);

#endif
