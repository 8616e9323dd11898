/* The header for students' files: marks what is still to be written. */
#ifndef EXERCISE_H
#define EXERCISE_H

/* Marks a gap in a stub. `return NOT_DONE_YET(0.0);` compiles like `return
   0.0;`, but ends the test that reaches it, and the examiner reports "not
   begun". Without the mark, 0 would count as a wrong answer; abort() would
   count as a crash. A stub must compile and link, because a linker error
   would be a bad first message for a beginner. The comma operator gives the
   gap the type of its value. */
#define NOT_DONE_YET(value) (exercise_not_done(__FILE__, __LINE__), (value))

/* Ends the running test as not begun. NOT_DONE_YET calls this function. */
void exercise_not_done(const char *file, int line);

#endif
