/* The header for students' files: marks what is still to be written. */
#ifndef EXERCISE_H
#define EXERCISE_H

/* Marks a gap: `return NOT_DONE_YET(0.0);` compiles like `return 0.0;`, but
   ends the test that reaches it, and the examiner says "not begun" instead
   of "failed". A stub has to compile and link, since a beginner's first
   message should not be the linker's; without the mark it would run, and
   its 0 would be a wrong answer. The comma operator gives the gap the type
   of its value. abort() would end the test as well, but as a crash. */
#define NOT_DONE_YET(value) (exercise_not_done(__FILE__, __LINE__), (value))

/* Ends the running test as not begun; NOT_DONE_YET calls it. */
void exercise_not_done(const char *file, int line);

#endif
