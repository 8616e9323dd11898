/* From chapters/works/B-grader.nw: edit there, then run make tangle. */
/* checksum 3056870061 of the lines below */
/* Notices that a program is again where it was, and goes round for ever. */
#ifndef ORBIT_H
#define ORBIT_H

/* From now on, and from its first fifth of a second on, this process looks
   whether it has been in its present state before, and ends by the signal
   REPORT_ENDLESS if so. */
void orbit_watch(void);

/* It has learnt something from outside: nothing of before will return. */
void orbit_leave(void);

#endif
