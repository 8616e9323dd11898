/* The interface of a suite: checks, tests, known mistakes, drawn inputs. */
#ifndef CHECK_H
#define CHECK_H

#include <stdbool.h>

/* A wrong answer that we know how to explain. The suite computes the value
   from the same input as the expected one; an answer that equals it gets
   the hint and the name in square brackets, by which the kit's own tests
   know that each mistake meets its own hint. Nothing looks at the student's
   source: two different mistakes seldom give the same ten digits. */
struct check_mistake {
    const char *name; /* short, with hyphens: "mass-not-inverse" */
    double value;     /* what somebody who makes it gets */
    const char *hint; /* what to tell them; no full solution */
};

/* Fills an output before the call. Arithmetic never makes this NaN of
   numbers, but hands it on: an answer that has it was left empty. */
#define CHECK_EMPTY __builtin_nan("0xe3b7")

/* The value of a mistake that makes the answer no number. A value that only
   comes out as NaN, because the mistake does not apply to this input or has
   no value for it, explains nothing. */
#define CHECK_NAN __builtin_nan("0x4a7")
/* One comparison, and all that is said when it fails. The fields are filled
   in by name (C's designated initializers), because a function with nine
   arguments, some of them strings, could be called with two of them
   exchanged. What is left out is zero and is not printed. A tolerance must
   have a reason in `because`: too small, it refuses a right answer that was
   computed in another order; too large, it lets a missing term through. */
struct check {
    const char *quantity; /* what was asked for, in words */
    const char *unit;     /* "m/s"; NULL or "" for a pure number */
    const char *input;    /* what it was computed from, with units */
    double expected;
    double tolerance;     /* largest |got - expected| that passes */
    const char *because;  /* where the tolerance comes from */
    const char *equation; /* its label in the book: "eq:difference" */
    const char *question; /* one question that leads on */
    struct check_mistake mistakes[12]; /* unused ones have no name */
};
/* A test: a sentence that says what holds, the function that checks, and
   the points that it earns. A test that draws its inputs earns further
   points when a lecturer grades it with a seed of his own. The name is a
   sentence that says what holds ("momentum is conserved"). Tests stand from
   the plainest case to the awkward ones, because the first that fails is
   told in full and the others are only named. */
struct check_test {
    const char *name;
    void (*run)(void);
    int points; /* at least 1 */
    int hidden; /* with another seed; 0: nothing in it is drawn */
};

enum { CHECK_TESTS = 32 }; /* room for tests, the last entry included */

/* The tests of one exercise. Every suite file defines one of these under
   the name check_suite. Idle tests hold when nothing was done (a function
   that returns the velocities it was given conserves momentum to the last
   bit), so they pay only if a test that is not idle has passed. The kit's
   tests find out which are idle by running each suite on stubs that do
   nothing. */
struct check_suite {
    const char *file; /* "01a-collide.c", in exercises/ and solutions/ */
    const char *title;
    int minutes;                          /* that it should take */
    struct check_test tests[CHECK_TESTS]; /* ends without a name */
    void (*idle[8])(void); /* those that a function passes which does
                              nothing: they earn only beside another */
};

extern const struct check_suite check_suite;

/* More tests, which only the grader runs, with a seed of the lecturer's;
   the last one has no name. Where nobody defines them there are none. They
   earn only beside a test of the suite that is not idle. */
extern const struct check_test check_hidden[];
/* Describes a write outside of an output. */
struct check_overrun {
    char place[32]; /* the name of the argument */
    int before;     /* 1: before its start; 0: behind its end */
    int bytes;      /* how many have changed */
};

/* Compares got with the expected value of the check c and tells CUnit.
   Returns whether it passed, so that a test can stop at the first failure.
   A NaN never passes; an infinity passes only where the same infinity is
   expected. */
bool check_near(const char *file, int line, double got, struct check c);

/* check_near with the suite's place filled in. The arguments after the
   first are the fields of a struct check: CHECK_NEAR(v, .expected = 1). */
#define CHECK_NEAR(got, ...)                                               \
    check_near(__FILE__, __LINE__, (got), (struct check){__VA_ARGS__})

/* printf into a buffer that stays valid for the next 20 calls; what is
   longer than 511 characters is cut. */
const char *check_text(const char *format, ...);

/* Draws a number from low to high, rounded to four significant digits, so
   that it may pass an end by half a unit of the fourth. Each test has a
   sequence of its own, the same in every run with the same seed. Numbers
   that stand in a suite could be learnt by heart; drawn ones are the same
   for every student at home and others under a lecturer's seed. They have
   four digits so that a student who reads one in a report and types it has
   the same double. */
double check_draw(double low, double high);

/* Draws a whole number from low to high, both included. */
int check_draw_whole(int low, int high);

/* Draws an order for count things: order[0] comes first. It does not depend
   on the seed, so that a student cannot know it beforehand, and no verdict
   on right work may depend on it. */
void check_shuffle(int order[], int count);

/* Ends the test, as failed, when the student's function has asked for more
   than so many of something: what they are, "samples". */
void check_demand(const char *what, double asked, double most);

/* Fails the test because the function wrote outside of an output, and says
   so. */
void check_overrun(const struct check_overrun *overrun);

/* Tells the student something more, under a label of at most 12 letters,
   unless the test passes: what was run, or how to go on. */
void check_tell(const char *label, const char *text);

#endif
