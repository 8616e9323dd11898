/* From chapters/works/B-examiner.nw: edit there, then run make tangle. */
/* checksum 1984340688 of the lines below */
/* What a student's file includes: the mark of a gap. */
#ifndef EXERCISE_H
#define EXERCISE_H

/* Stands where an exercise has its gap: `return NOT_DONE_YET(0.0);`
   compiles like `return 0.0;`, but a test that reaches it ends there, and
   the examiner says "not begun" instead of "failed". */
#define NOT_DONE_YET(value) (exercise_not_done(__FILE__, __LINE__), (value))

/* Ends the running test as not done yet; NOT_DONE_YET calls it. */
void exercise_not_done(const char *file, int line);

#endif
