/* A CUnit program is one or more tests, each with a sentence that says what
   holds:

       TEST(test_swap, "equal masses swap")
       {
           UNIT_NEAR(got, expected, tolerance);
       }

   It runs them in the order of the file, and prints `ok NAME` or
   `not ok NAME - why` for each, as tests/run counts them. A file that has
   something to do before or after them defines UNIT_OWN_MAIN before it
   includes this, and has a main of its own that calls unit_run. */
#ifndef UNIT_H
#define UNIT_H

#include <CUnit/CUnit.h>
#include <CUnit/TestRun.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct unit_test {
    const char *name; /* a sentence that says what holds */
    void (*run)(void);
};

/* The tests of the file. Each is put here before main begins, by a function
   that the compiler calls (a constructor). */
enum { UNIT_TESTS = 64 };
static struct unit_test unit_tests[UNIT_TESTS];

static inline void unit_add(const char *name, void (*run)(void))
{
    int n = 0;
    while (unit_tests[n].name)
        ++n;
    if (n == UNIT_TESTS - 1) {
        printf("not ok %s - no place for so many tests\n", name);
        exit(1);
    }
    unit_tests[n] = (struct unit_test){name, run};
}

#define TEST(function, sentence)                                           \
    static void function(void);                                            \
    __attribute__((constructor)) static void function##_is_a_test(void)    \
    {                                                                      \
        unit_add(sentence, function);                                      \
    }                                                                      \
    static void function(void)

/* Passes when |got - expected| <= tolerance; says both numbers when not.
   A NaN on either side fails. */
#define UNIT_NEAR(got, expected, tolerance)                                \
    unit_near(__FILE__, __LINE__, #got, (got), (expected), (tolerance))

/* Passes when the two numbers are equal. */
#define UNIT_EQUAL(got, expected) UNIT_NEAR(got, expected, 0.0)

/* Passes when the list begins with these numbers, each to within the
   tolerance. */
#define UNIT_LIST(got, tolerance, ...)                                     \
    unit_list(__FILE__, __LINE__, #got, (got),                             \
              (const double[]){__VA_ARGS__},                               \
              sizeof((const double[]){__VA_ARGS__}) / sizeof(double),      \
              (tolerance))

/* Passes when the text is the expected one; says both when not. */
#define UNIT_SAYS(got, expected)                                           \
    unit_says(__FILE__, __LINE__, (got), (expected))

/* Passes when the condition holds. */
#define UNIT_TRUE(condition)                                               \
    CU_assertImplementation((condition) ? CU_TRUE : CU_FALSE, __LINE__,    \
                            #condition, __FILE__, "", CU_FALSE)

/* Ends the program, as failed, where the condition does not hold and no
   test could go on: memory has run out, say. */
#define UNIT_MUST(condition)                                               \
    unit_must(condition, #condition, __FILE__, __LINE__)

static inline void unit_must(bool holds, const char *condition,
                             const char *file, int line)
{
    if (!holds) {
        printf("not ok %s:%d: cannot go on without %s\n", file, line,
               condition);
        exit(1);
    }
}

/* A structure that is freed at the end of its block: `FREED(scene) s;` is
   `struct scene s;` and, there, `scene_free(&s);`. */
#define FREED(type)                                                        \
    __attribute__((cleanup(type##_free), unused)) struct type

/* One that ends instead: `ENDED(motion) m;` calls motion_end. */
#define ENDED(type) __attribute__((cleanup(type##_end), unused)) struct type

/* `MADE(disks, d, begin(&d, 2, 20));` is `FREED(disks) d;` and the call
   that makes it; STARTED is the same with ENDED. */
#define MADE(type, name, call)                                             \
    FREED(type) name;                                                      \
    call
#define STARTED(type, name, call)                                          \
    ENDED(type) name;                                                      \
    call

/* `CREATED(scene, s, 3);` is `FREED(scene) s;` that scene_create(&s, 3) has
   made, and BEGUN the same with motion_begin and the like. */
#define CREATED(type, name, ...)                                           \
    FREED(type) name;                                                      \
    UNIT_MUST(type##_create(&name, __VA_ARGS__))
#define BEGUN(type, name, ...)                                             \
    ENDED(type) name;                                                      \
    UNIT_MUST(type##_begin(&name, __VA_ARGS__))

/* Gives the first numbers of a list these values. */
#define PUT(list, ...)                                                     \
    memcpy((double *){list}, (const double[]){__VA_ARGS__},                \
           sizeof((const double[]){__VA_ARGS__}))

/* Bounds axis k of a scene, or makes it periodic, between two places. */
#define WALLS(scene, k, kind, from, to)                                    \
    ((scene).wall[k] = (kind), (scene).low[k] = (from),                    \
     (scene).high[k] = (to))

/* A parameter that a function must have and does not use. */
#define UNUSED __attribute__((unused))

/* A generator of this name, which has been given its seed. */
#define SEEDED(name, seed)                                                 \
    struct random name;                                                    \
    random_seed(&name, seed)

/* For qsort: the lower number comes first. */
static inline int unit_rising(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static inline void unit_near(const char *file, unsigned line,
                             const char *what, double got, double expected,
                             double tolerance)
{
    static char texts[64][256]; /* CUnit copies nothing for us to rely on */
    static unsigned next;
    char *text = texts[next++ % 64];
    snprintf(text, sizeof texts[0], "%s is %.17g, not %.17g to within %.3g",
             what, got, expected, tolerance);
    CU_assertImplementation(fabs(got - expected) <= tolerance ? CU_TRUE
                                                              : CU_FALSE,
                            line, text, file, "", CU_FALSE);
}

static inline void unit_list(const char *file, unsigned line,
                             const char *what, const double got[],
                             const double expected[], size_t count,
                             double tolerance)
{
    char number[128];
    for (size_t i = 0; i < count; ++i) {
        snprintf(number, sizeof number, "(%s)[%zu]", what, i);
        unit_near(file, line, number, got[i], expected[i], tolerance);
    }
}

static inline void unit_says(const char *file, unsigned line,
                             const char *got, const char *expected)
{
    const bool same = got && strcmp(got, expected) == 0;
    if (!same)
        printf("# %s\n# not %s\n", got ? got : "nothing", expected);
    CU_assertImplementation(same ? CU_TRUE : CU_FALSE, line,
                            "the text is another one", file, "", CU_FALSE);
}

/* Copies the next text of a list in which each ends with a bar, "1|x||",
   and goes behind it. Returns whether there was one. */
static inline bool unit_item(const char **list, char text[80])
{
    const char *bar = strchr(*list, '|');
    if (!bar)
        return false;
    snprintf(text, 80, "%.*s", (int)(bar - *list), *list);
    *list = bar + 1;
    return true;
}

/* Runs these tests under CUnit, a line each; returns what main returns. */
static inline int unit_run_these(const char *suite_name,
                                 struct unit_test tests[])
{
    CU_pSuite suite;
    int failed = 0;
    int planned = 0;
    if (CU_initialize_registry() != CUE_SUCCESS ||
        !(suite = CU_add_suite(suite_name, NULL, NULL)))
        return 1;
    while (tests[planned].name)
        ++planned;
    printf("1..%d\n", planned);
    for (; tests->name; ++tests) {
        CU_pTest test = CU_add_test(suite, tests->name, tests->run);
        CU_pFailureRecord why;
        if (!test) {
            printf("not ok %s: %s - CUnit refuses the test\n", suite_name,
                   tests->name);
            ++failed;
            continue;
        }
        CU_run_test(suite, test);
        why = CU_get_failure_list();
        if (CU_get_number_of_asserts() == 0) {
            printf("not ok %s: %s - it asserts nothing\n", suite_name,
                   tests->name);
            ++failed;
        } else if (why) {
            printf("not ok %s: %s - %s:%u: %s\n", suite_name, tests->name,
                   why->strFileName, why->uiLineNumber, why->strCondition);
            ++failed;
        } else {
            printf("ok %s: %s\n", suite_name, tests->name);
        }
        fflush(stdout);
    }
    CU_cleanup_registry();
    return failed ? 1 : 0;
}

/* The same for all tests of the file. */
static inline int unit_run(const char *suite_name)
{
    return unit_run_these(suite_name, unit_tests);
}

#ifndef UNIT_OWN_MAIN
/* The name is that of the file. */
int main(void)
{
    static char name[64];
    const char *slash = strrchr(__BASE_FILE__, '/');
    snprintf(name, sizeof name, "%s", slash ? slash + 1 : __BASE_FILE__);
    name[strcspn(name, ".")] = '\0';
    return unit_run(name);
}
#endif

#endif
