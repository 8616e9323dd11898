/* The interface of a suite: checks, tests, known mistakes, drawn inputs. */
#ifndef CHECK_H
#define CHECK_H

/* Includes the headers that nearly all suites need. */
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* A mistake that we can explain. From the input of the check the suite
   computes the wrong value to which the mistake leads. An answer with this
   value gets the hint, followed by the name of the mistake in brackets,
   from which the kit's own tests see that each mistake gets its hint. The
   student's source is not read: two different mistakes seldom agree in ten
   digits. */
struct check_mistake {
    const char *name; /* short, with hyphens: "mass-not-inverse" */
    double value;     /* the answer to which it leads */
    const char *hint; /* shown to the student; not the solution */
};

/* The value of an output before the call: a NaN that arithmetic never
   produces, but passes on. An answer that is this NaN was never written. */
#define CHECK_EMPTY __builtin_nan("0xe3b7")

/* The value of a mistake whose answer is a NaN. If a mistake has another
   NaN as its value, because it cannot be made with this input, it explains
   nothing. */
#define CHECK_NAN __builtin_nan("0x4a7")
/* One comparison, and what is reported if it fails. Suites fill in the
   fields by name, because in a call with nine arguments two strings could
   be exchanged. Fields that are left out are not printed. Each tolerance
   needs a reason in `because`: one that is too small rejects a right answer
   computed in another order; one that is too large accepts a missing
   term. */
struct check {
    const char *quantity; /* the quantity that is compared, in words */
    const char *unit;     /* "m/s"; NULL or "" for a pure number */
    const char *input;    /* the arguments, with units */
    double expected;
    double tolerance;     /* largest |got - expected| that passes */
    const char *because;  /* reason for the tolerance */
    const char *equation; /* label in the book; NULL: the suite's */
    const char *question; /* a question that helps the student */
    struct check_mistake mistakes[12]; /* unused ones have no name */
};
/* A test. Its name is a sentence that says what is true ("momentum is
   conserved"). Tests are listed from the simplest case to the most
   difficult, because only the first failure is reported in full. A test
   that draws its inputs earns further points when a lecturer grades it with
   another seed. */
struct check_test {
    const char *name;
    void (*run)(void);
    int points; /* points of the test, at least 1 */
    int hidden; /* further points; 0: its inputs are not drawn */
};

enum { CHECK_TESTS = 32 }; /* largest length of tests[], with its end */

/* The tests of one exercise; every suite defines one of these, named
   check_suite. Idle tests are passed by a function that does nothing (one
   that returns the velocities it was given conserves momentum), so they
   earn points only if a test that is not idle has passed. The kit's tests
   run each suite with stubs that do nothing to find out which tests are
   idle. */
struct check_suite {
    const char *file; /* "01a-collide.c", in exercises/ and solutions/ */
    const char *title;
    int minutes; /* time that a student needs */
    /* The label of the equation that failures name: "eq:difference". */
    const char *equation;
    struct check_test tests[CHECK_TESTS]; /* the last has no name */
    void (*idle[8])(void);                /* the idle tests */
};

extern const struct check_suite check_suite;

/* Hidden tests, which only the grader runs, with the lecturer's seed; the
   last has no name. Without a file hidden.c the list is empty. They earn
   points only if a test of the suite that is not idle has passed. */
extern const struct check_test check_hidden[];
/* A write outside of an output. */
struct check_overrun {
    char place[32]; /* the name of the argument */
    int before;     /* 1: before its start; 0: after its end */
    int bytes;      /* number of bytes changed */
};

/* Compares got with the expected value of the check c and tells CUnit.
   Returns whether they agree, so that a test can stop at the first failure.
   A NaN never agrees; an infinity agrees only with the same infinity. */
bool check_near(const char *file, int line, double got, struct check c);

/* Calls check_near with the file and line of the call. The arguments after
   the first are fields of a struct check: CHECK_NEAR(v, .expected = 1). */
#define CHECK_NEAR(got, ...)                                               \
    check_near(__FILE__, __LINE__, (got), (struct check){__VA_ARGS__})

/* Returns a text formatted as by printf, in a buffer that stays valid for
   the next 20 calls; longer texts are cut after 511 characters. */
const char *check_text(const char *format, ...);

/* Draws a number from low to high and rounds it to four significant digits,
   so that it may exceed a limit by half a unit of the fourth. Each test has
   its own sequence, which depends only on the seed and the test's number.
   Students could learn constant numbers by heart; numbers drawn are the
   same for everybody at home and different under a lecturer's seed. With
   four digits a student who types a number from a report gets exactly this
   double. */
double check_draw(double low, double high);

/* Draws a whole number from low to high, both included. */
int check_draw_whole(int low, int high);

/* Puts the numbers 0 to count - 1 into order[] at random. The order differs
   in each run and does not depend on the seed, so that nobody can know it
   beforehand; the verdict on a right answer must not depend on it. */
void check_shuffle(int order[], int count);

/* Ends the test as failed if the student's function has asked for more than
   `most' items, such as samples; `what' is their name. */
void check_demand(const char *what, double asked, double most);

/* Fails the test because the function wrote outside of an output, and
   reports where. */
void check_overrun(const struct check_overrun *overrun);

/* Reports one more line about a test that fails: a label of at most 12
   letters and a text, such as the command that was run. */
void check_tell(const char *label, const char *text);

#endif
