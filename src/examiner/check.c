/* From chapters/B-examiner.nw: edit there, then run make tangle. */
/* checksum 4019142444 of the lines below */
#include "examiner/check.h"
#include "examiner/exercise.h"
#include "examiner/report.h"

#include <CUnit/CUnit.h>
#include <CUnit/TestRun.h>
#include <fcntl.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const char *check_text(const char *format, ...)
{
    static char texts[32][512];
    static unsigned next;
    char *text = texts[next++ % 32];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof texts[0], format, arguments);
    va_end(arguments);
    return text;
}

static int report_file = -1;
static pid_t report_owner;
static char report_nonce[REPORT_NONCE + 1];

static void report(const char *word, const char *text)
{
    char record[REPORT_RECORD];
    if (getpid() != report_owner)
        return;
    const int length = snprintf(record, sizeof record, "\n%s %s %s\n",
                                report_nonce, word, text);
    if (write(report_file, record, (size_t)length) != length)
        _exit(EXIT_FAILURE);
}

static bool report_open(int file)
{
    report_file = file;
    report_owner = getpid();
    return pread(file, report_nonce, REPORT_NONCE, 0) == REPORT_NONCE &&
           ftruncate(file, 0) == 0 && fcntl(file, F_SETFD, FD_CLOEXEC) == 0;
}

void exercise_not_done(const char *file, int line)
{
    report(REPORT_UNDONE, check_text("%s:%d", file, line));
    _exit(EXIT_SUCCESS);
}

static void say(const char *label, const char *text)
{
    if (text && *text)
        report(REPORT_SAYS, check_text("%s %s", label, text));
}

static void number_text(char *text, size_t room, int digits, double x)
{
    if (isnan(x))
        snprintf(text, room, "nan");
    else
        snprintf(text, room, "%.*g", digits, x);
}

static void number_pair(char *one, char *other, size_t room, double x,
                        double y)
{
    number_text(one, room, 10, x);
    number_text(other, room, 10, y);
    if (strcmp(one, other) == 0) {
        number_text(one, room, 17, x);
        number_text(other, room, 17, y);
    }
}

static bool near(double got, double expected, double tolerance)
{
    return got == expected || fabs(got - expected) <= tolerance;
}

static const struct check_mistake *mistake_behind(double got,
                                                  const struct check *c)
{
    const size_t room = sizeof c->mistakes / sizeof c->mistakes[0];
    for (size_t i = 0; i < room && c->mistakes[i].name; ++i) {
        const double value = c->mistakes[i].value;
        const double slack = c->tolerance + 1e-9 * fabs(value);
        const bool same =
            near(got, value, slack) || (isnan(got) && isnan(value));
        if (same && !near(value, c->expected, slack))
            return &c->mistakes[i];
    }
    return NULL;
}

static void say_failure(double got, const struct check *c)
{
    char wanted[64], found[64];
    const char *space = c->unit && *c->unit ? " " : "";
    const char *unit = c->unit ? c->unit : "";
    const char *reason = c->because ? c->because : "";
    const struct check_mistake *mistake = mistake_behind(got, c);
    number_pair(wanted, found, sizeof wanted, c->expected, got);
    say("quantity", c->quantity);
    say("input", c->input);
    say("expected", check_text("%s%s%s", wanted, space, unit));
    say("got", check_text("%s%s%s", found, space, unit));
    say("tolerance", check_text("%.3g%s%s%s%s", c->tolerance, space, unit,
                                *reason ? ": " : "", reason));
    say("book", c->equation);
    if (mistake)
        say("hint", check_text("%s [%s]", mistake->hint, mistake->name));
    else
        say("question", c->question);
}

bool check_near(const char *file, int line, double got, struct check c)
{
    const bool passed = near(got, c.expected, c.tolerance);
    if (!passed && CU_get_number_of_failure_records() == 0)
        say_failure(got, &c);
    CU_assertImplementation(passed, (unsigned)line, "CHECK_NEAR", file, "",
                            CU_FALSE);
    return passed;
}

static int list_suite(void)
{
    printf("exercise %s\ntitle %s\nminutes %d\npoints %d\n",
           check_suite.exercise, check_suite.title, check_suite.minutes,
           check_suite.points);
    for (const struct check_test *t = check_suite.tests; t->name; ++t)
        printf("test %s\n", t->name);
    return fflush(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
}

static bool has_passed(void)
{
    const bool checked = CU_get_number_of_asserts() > 0;
    if (!checked)
        say("question", "This test checked nothing. Is its suite "
                        "complete?");
    return checked && CU_get_number_of_failures() == 0;
}

static int run_test(const struct check_test *t)
{
    CU_pSuite suite = NULL;
    CU_pTest test = NULL;
    if (CU_initialize_registry() == CUE_SUCCESS)
        suite = CU_add_suite(check_suite.title, NULL, NULL);
    if (suite)
        test = CU_add_test(suite, t->name, t->run);
    if (!test)
        return EXIT_FAILURE;
    CU_run_test(suite, test);
    fflush(NULL);
    report(REPORT_VERDICT, has_passed() ? "passed" : "failed");
    return EXIT_SUCCESS;
}

int main(int argc, char **argv)
{
    int count = 0;
    while (count < CHECK_TESTS - 1 && check_suite.tests[count].name)
        ++count;
    if (argc == 2 && strcmp(argv[1], "--list") == 0)
        return list_suite();
    const int number = argc == 3 ? atoi(argv[1]) : 0;
    if (number < 1 || number > count || !report_open(atoi(argv[2]))) {
        fprintf(stderr, "usage: %s --list, or TEST REPORT\n", argv[0]);
        return EXIT_FAILURE;
    }
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    _exit(run_test(&check_suite.tests[number - 1]));
}
