/* What a student's file includes: the mark of a gap. */
#ifndef EXERCISE_H
#define EXERCISE_H

/* Marks a gap: `return NOT_DONE_YET(0.0);` compiles like `return 0.0;`, but
   a test that reaches it ends there, and the examiner says "not begun"
   instead of "failed". A stub has to link, for a beginner's first message
   should not be the linker's; so it runs, and without this mark its 0 would
   be a wrong answer before the student has typed a letter. The value passes
   through the comma operator so that the gap has whatever type the function
   promises. A call of abort would do, too, but would read as a crash. */
#define NOT_DONE_YET(value) (exercise_not_done(__FILE__, __LINE__), (value))

/* Ends the running test as not done yet; NOT_DONE_YET calls it. */
void exercise_not_done(const char *file, int line);

#endif
