/* From chapters/B-examiner.nw: edit there, then run make tangle. */
/* checksum 4207129916 of the lines below */
#ifndef CHECK_H
#define CHECK_H

#include <stdbool.h>

/* A wrong answer that we know how to explain. */
struct check_mistake {
    const char *name; /* short, with hyphens: "mass-not-inverse" */
    double value;     /* what somebody who makes it gets */
    const char *hint; /* what to tell them; no full solution */
};
/* One comparison, and all that is said when it fails. */
struct check {
    const char *quantity; /* what was asked for, in words */
    const char *unit;     /* "m/s"; NULL or "" for a pure number */
    const char *input;    /* what it was computed from, with units */
    double expected;
    double tolerance;     /* largest |got - expected| that passes */
    const char *because;  /* where the tolerance comes from */
    const char *equation; /* its label in the book: "eq:difference" */
    const char *question; /* one question that leads on */
    struct check_mistake mistakes[8]; /* unused ones have no name */
};
/* A test: a sentence that says what holds, and the function that checks. */
struct check_test {
    const char *name;
    void (*run)(void);
};

enum { CHECK_TESTS = 32 }; /* room for tests, the last entry included */

/* The tests of one exercise. Every suite file defines one of these under
   the name check_suite. */
struct check_suite {
    const char *exercise; /* "01a" */
    const char *title;
    int minutes; /* that it should take */
    int points;
    struct check_test tests[CHECK_TESTS]; /* ends with {NULL, NULL} */
};

extern const struct check_suite check_suite;

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

#endif
