/* The interface for test suites: checks, tests, mistakes, random inputs. */
#ifndef CHECK_H
#define CHECK_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* A known mistake. The suite computes the wrong value that this mistake
   gives for the input of a check. If a student's answer has this value, the
   report shows the hint and, in brackets, the name of the mistake. The
   kit's own tests use the name to check that each mistake gets its hint.
   The value is enough to recognize a mistake, because two different
   mistakes seldom agree in ten digits. */
struct check_mistake {
    const char *name; /* short, with hyphens: "mass-not-inverse" */
    double value;     /* the wrong answer that it gives */
    const char *hint; /* shown to the student; not the solution */
};

/* The value of every output before the call: a NaN that arithmetic passes
   on but never produces. An output that still has this value was never
   written. */
#define CHECK_EMPTY __builtin_nan("0xe3b7")

/* The value of a mistake whose result is a NaN. A mistake with any other
   NaN as its value, except CHECK_EMPTY, matches no answer; suites use NAN
   for a mistake that cannot be made with the current input. */
#define CHECK_NAN __builtin_nan("0x4a7")
/* One comparison, and the texts that are reported if it fails. Suites set
   the fields by name: in a call with nine unnamed arguments, two strings in
   the wrong order would go unnoticed. Fields that are not set are not
   printed. Every tolerance needs a reason in `because`: one that is too
   small rejects a right answer computed in another order, and one that is
   too large accepts an answer with a missing term. */
struct check {
    const char *quantity; /* the name of the quantity compared */
    const char *unit;     /* "m/s"; NULL or "" for a pure number */
    const char *input;    /* the arguments; NULL: those of check_about */
    double expected;
    double tolerance;     /* largest |got - expected|; 0: exact */
    const char *because;  /* reason for the tolerance */
    const char *equation; /* label in the book; NULL: that of the suite */
    const char *question; /* helps the student; NULL: that of check_ask */
    struct check_mistake mistakes[12]; /* unused entries have no name */
};
/* A test. Its name is a true statement, such as "momentum is conserved".
   Tests are listed from the simplest to the most difficult case, because
   only the first failure is reported in full. A test with random inputs
   earns further points when a lecturer grades it with another seed. */
struct check_test {
    const char *name;
    void (*run)(void);
    int points; /* at least 1 */
    int hidden; /* points with another seed; 0: no random inputs */
};

enum { CHECK_TESTS = 32 }; /* maximum number of tests, plus 1 */

/* The tests of one exercise. Every suite defines one of these structs,
   named check_suite. A test is idle if a function that does nothing passes
   it: for example, a function that returns the velocities it was given
   conserves momentum. Idle tests earn points only if a test that is not
   idle has passed. The kit's tests find the idle tests by running each
   suite with stubs that do nothing. */
struct check_suite {
    const char *file; /* "01a-collide.c", in exercises/ and solutions/ */
    const char *title;
    int minutes; /* time that a student needs, min */
    /* Label of the equation that reports cite, such as "eq:difference". */
    const char *equation;
    struct check_test tests[CHECK_TESTS]; /* the last has no name */
    void (*idle[8])(void);                /* the idle tests */
};

extern const struct check_suite check_suite;

/* Hidden tests, which only the grader runs, with the lecturer's seed. The
   last entry has no name. The list is empty if the exercise has no
   hidden.c. Hidden tests earn points only if a test of the suite that is
   not idle has passed. They ask no questions, because no student sees their
   reports. */
extern const struct check_test check_hidden[];
/* A write outside an output. */
struct check_overrun {
    char place[32]; /* the name of the argument */
    int before;     /* 1: before its start; 0: after its end */
    int bytes;      /* number of bytes changed */
};

/* Compares `got` with c.expected. If they disagree, reports the failure and
   ends the test as failed, so what follows a check runs only if the check
   has passed. A NaN never agrees. An infinity agrees only with the same
   infinity. */
void check_near(double got, struct check c);

/* Calls check_near. The arguments after the first are fields of a struct
   check: CHECK_NEAR(v, .expected = 1). */
#define CHECK_NEAR(got, ...) check_near((got), (struct check){__VA_ARGS__})

/* Defines a test that runs its body this many times. In the body, i is the
   number of the run, from 0. */
#define CHECK_TIMES(times, test, i)                                        \
    static void test##_case(int i);                                        \
    static void test(void)                                                 \
    {                                                                      \
        for (int turn = 0; turn < (times); ++turn)                         \
            test##_case(turn);                                             \
    }                                                                      \
    static void test##_case(int i __attribute__((unused)))

/* Set the default question and the default input for further checks of the
   test. check_about returns the input; NULL does not change it. */
void check_ask(const char *question);
const char *check_about(const char *input);

/* Returns a text formatted like printf. The buffer stays valid for the next
   20 calls. Longer texts are cut after 511 characters. */
const char *check_text(const char *format, ...);

/* Draws a random number from `low` to `high` and rounds it to four
   significant digits, so that a student who types a number from a report
   gets exactly the same double. Rounding may move it past `low` or `high`
   by half a unit in the fourth digit. Each test has its own sequence, which
   depends only on the seed and the test's number. At home all students get
   the same numbers. A lecturer's seed gives other numbers, which no student
   can know by heart. */
double check_draw(double low, double high);

/* Draws a random whole number from `low` to `high`, both included. */
int check_draw_whole(int low, int high);

/* Puts the numbers 0 to count - 1 into order[] in random order. The order
   differs in each run and does not depend on the seed, so nobody can know
   it beforehand. The verdict on a right answer must not depend on the
   order. */
void check_shuffle(int order[], int count);

/* Fails and ends the test if `asked`, the number of items that the
   student's function has requested, exceeds `most`. `what` names the items:
   for example, "samples". */
void check_demand(const char *what, double asked, double most);

/* Fails the test because the function wrote outside an output, and reports
   where. */
void check_overrun(const struct check_overrun *overrun);

/* Adds one line to the report of a failing test: a label of at most 12
   letters and a text, such as the command that was run. */
void check_tell(const char *label, const char *text);

#endif
