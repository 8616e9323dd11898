/* The interface of a suite: checks, tests, known mistakes, drawn inputs. */
#ifndef CHECK_H
#define CHECK_H

/* What a suite measures and draws with is included for all suites here. */
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* A mistake that we can explain. The suite computes the value that it
   leads to from the same input as the expected one; an answer that equals
   it gets the hint, with the name in square brackets, by which the kit's
   own tests check that each mistake gets its hint. The student's source is
   not read: two different mistakes seldom agree in ten digits. */
struct check_mistake {
    const char *name; /* short, with hyphens: "mass-not-inverse" */
    double value;     /* the answer to which it leads */
    const char *hint; /* what to tell the student; not the solution */
};

/* The value of an output before the call. Arithmetic with numbers never
   makes this NaN, but passes it on: an answer that has it was not
   filled. */
#define CHECK_EMPTY __builtin_nan("0xe3b7")

/* The value of a mistake whose answer is a NaN. A value that is merely
   computed as NaN, because the mistake cannot be made with this input,
   explains nothing. */
#define CHECK_NAN __builtin_nan("0x4a7")
/* One comparison, and what is said when it fails. Suites fill in the
   fields by name, because a function with nine arguments, several of them
   strings, could be called with two exchanged. Fields that are left out
   are not printed. A tolerance needs a reason in `because`: too small, it
   refuses a right answer that was computed in another order; too large, it
   lets a missing term through. */
struct check {
    const char *quantity; /* which quantity was asked for, in words */
    const char *unit;     /* "m/s"; NULL or "" for a pure number */
    const char *input;    /* the arguments, with units */
    double expected;
    double tolerance;     /* largest |got - expected| that passes */
    const char *because;  /* where the tolerance comes from */
    const char *equation; /* its label in the book: "eq:difference" */
    const char *question; /* a question that helps to go on */
    struct check_mistake mistakes[12]; /* unused ones have no name */
};
/* A test. Its name is a sentence that says what holds ("momentum is
   conserved"). Tests stand from the plainest case to the most awkward,
   because the first that fails is told in full and the others are only
   named. A test that draws its inputs earns further points when a lecturer
   grades it with a seed of his own. */
struct check_test {
    const char *name;
    void (*run)(void);
    int points; /* at least 1 */
    int hidden; /* further points; 0: its inputs are not drawn */
};

enum { CHECK_TESTS = 32 }; /* size of the list, the end included */

/* The tests of one exercise; every suite defines one of these, named
   check_suite. Idle tests pass when nothing was done (a function that
   returns the velocities it was given conserves momentum), so they earn
   points only if a test that is not idle has passed. The kit's tests find
   out which tests are idle by running each suite with stubs that do
   nothing. */
struct check_suite {
    const char *file; /* "01a-collide.c", in exercises/ and solutions/ */
    const char *title;
    int minutes; /* how long the exercise should take */
    struct check_test tests[CHECK_TESTS]; /* ends without a name */
    void (*idle[8])(void); /* those that an empty function passes */
};

extern const struct check_suite check_suite;

/* Hidden tests, which only the grader runs, with a seed of the lecturer's;
   the last has no name. Without a file hidden.c the list is empty. They
   earn points only if a test of the suite that is not idle has passed. */
extern const struct check_test check_hidden[];
/* Describes a write outside of an output. */
struct check_overrun {
    char place[32]; /* the name of the argument */
    int before;     /* 1: before its start; 0: behind its end */
    int bytes;      /* how many bytes have changed */
};

/* Compares got with the expected value of the check c and tells CUnit.
   Returns whether it passed, so that a test can stop at the first failure.
   A NaN never passes; an infinity passes only where the same infinity is
   expected. */
bool check_near(const char *file, int line, double got, struct check c);

/* Calls check_near with the file and line of the call. The arguments after
   the first are fields of a struct check: CHECK_NEAR(v, .expected = 1). */
#define CHECK_NEAR(got, ...)                                               \
    check_near(__FILE__, __LINE__, (got), (struct check){__VA_ARGS__})

/* Formats as printf does, into a buffer that stays valid for the next 20
   calls; a text is cut after 511 characters. */
const char *check_text(const char *format, ...);

/* Draws a number from low to high and rounds it to four significant
   digits, so that it may pass an end by half a unit of the fourth. Each
   test has its own sequence, which depends on the seed alone. Students
   could learn constant numbers by heart; drawn ones are the same for all
   at home and others under a lecturer's seed. With four digits a student
   who types a number from a report gets the same double. */
double check_draw(double low, double high);

/* Draws a whole number from low to high, both included. */
int check_draw_whole(int low, int high);

/* Shuffles count things: order[0] comes first. The order differs in each
   run and does not depend on the seed, so that nobody can know it
   beforehand; a verdict on right work must not depend on it. */
void check_shuffle(int order[], int count);

/* Ends the test as failed if the student's function has asked for more
   than `most' of something; `what' names it, as in "samples". */
void check_demand(const char *what, double asked, double most);

/* Fails the test because the function wrote outside of an output, and says
   so. */
void check_overrun(const struct check_overrun *overrun);

/* Reports one more line about a test that does not pass: a label of at
   most 12 letters and a text, such as the command that was run. */
void check_tell(const char *label, const char *text);

#endif
