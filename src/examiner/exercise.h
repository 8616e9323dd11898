/* What a student's file includes: the mark of a gap. */
#ifndef EXERCISE_H
#define EXERCISE_H

/* Marks a gap: `return NOT_DONE_YET(0.0);` compiles like `return 0.0;`,
   but ends the test that reaches it, and the examiner says "not begun"
   instead of "failed". A stub has to compile and link, since a message of
   the linker should not be a beginner's first; without the mark it would
   run, and its 0 would be a wrong answer. The comma operator gives the gap
   whatever type its value has. abort() would end the test as well, but
   would count as a crash. */
#define NOT_DONE_YET(value) (exercise_not_done(__FILE__, __LINE__), (value))

/* Ends the running test as not done yet; NOT_DONE_YET calls it. */
void exercise_not_done(const char *file, int line);

#endif
