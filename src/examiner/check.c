/* The main program of a runner: runs one test and reports the result. */
#include "examiner/check.h"
#include "examiner/exercise.h"
#include "examiner/report.h"
#include "toolbox/random.h"

#include <CUnit/CUnit.h>
#include <CUnit/TestRun.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <linux/sched.h>
#include <sys/syscall.h>
#endif

/* Uses 32 buffers in turn: 20 as promised in the header, and 12 for calls
   in this file. Suites call this function in initializers, where allocated
   memory could not be freed. */
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

static pid_t report_owner;
static char report_nonce[REPORT_NONCE + 1];

/* Writes one line of the report. The whole line is one write, so that a
   process that dies leaves either all of it or nothing. The line begins
   with a newline, in case the program has left half a line. Only the
   process that opened the report writes: a child that the student's code
   has forked must not report. If the descriptor is closed, the process ends
   with a nonzero status, which the examiner sees. REPORT_LINE has room for
   every text of check_text. */
static void report(const char *word, const char *text)
{
    char line[REPORT_LINE];
    if (getpid() != report_owner)
        return;
    const int length = snprintf(line, sizeof line, "\n%s %s %s\n",
                                report_nonce, word, text);
    if (write(REPORT_FILE, line, (size_t)length) != length)
        _exit(EXIT_FAILURE);
}

/* Reads the nonce, a random word that marks genuine lines, from the report
   and empties the file. Returns whether that worked. FD_CLOEXEC hides the
   descriptor from programs that the student's code starts. */
static bool report_open(void)
{
    report_owner = getpid();
    return pread(REPORT_FILE, report_nonce, REPORT_NONCE, 0) ==
               REPORT_NONCE &&
           ftruncate(REPORT_FILE, 0) == 0 &&
           fcntl(REPORT_FILE, F_SETFD, FD_CLOEXEC) == 0;
}

/* Reports that the student's code has reached a gap, and ends the process.
   If NOT_DONE_YET returned its value instead, a loop might wait for another
   value for ever. */
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

void check_tell(const char *label, const char *text)
{
    say(label, text);
}

/* Writes x with this many digits. A NaN is written without its sign, which
   means nothing and differs between compilers. */
static void number_text(char *text, size_t room, int digits, double x)
{
    if (isnan(x))
        snprintf(text, room, "nan");
    else
        snprintf(text, room, "%.*g", digits, x);
}

/* Writes x and y with ten digits or, if they look equal, with 17, which
   distinguish any two doubles: "expected 1, got 1" would explain
   nothing. */
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

/* Returns whether two numbers agree. A NaN agrees with nothing, because
   every comparison with it is false. (The condition !(fabs(got - expected)
   > tolerance) would be true for a NaN.) The test for equality is needed
   for equal infinities, whose difference is a NaN. */
static bool near(double got, double expected, double tolerance)
{
    return got == expected || fabs(got - expected) <= tolerance;
}

/* Returns whether x and the NaN `mark` have the same bits, apart from the
   sign. */
static bool is_mark(double x, double mark)
{
    x = copysign(x, 1.0);
    return memcmp(&x, &mark, sizeof x) == 0;
}

static bool is_empty(double got)
{
    return is_mark(got, CHECK_EMPTY);
}

/* Returns whether this mistake explains the answer `got`. The tolerance is
   increased by 1e-9 of the mistake's value, because the suite and the
   student compute that value in different ways. A mistake that gives the
   expected value explains nothing: for example, squaring a radius of 1 by
   mistake does no harm. Only the values CHECK_EMPTY and CHECK_NAN explain a
   NaN; otherwise every mistake that happens to give a NaN would explain
   it. */
static bool explains(const struct check_mistake *mistake, double got,
                     const struct check *c)
{
    const double value = mistake->value;
    const double slack =
        isinf(value) ? 0.0 : c->tolerance + 1e-9 * fabs(value);
    if (isnan(got))
        return is_mark(value, is_empty(got) ? CHECK_EMPTY : CHECK_NAN);
    return near(got, value, slack) && !near(value, c->expected, slack);
}

/* Returns the mistake that explains `got`, or NULL. If two mistakes have
   the same value, returns neither, because the hint for the likelier
   mistake would mislead everybody who made the other. Suites should choose
   inputs that give all mistakes different values. */
static const struct check_mistake *mistake_behind(double got,
                                                  const struct check *c)
{
    const size_t room = sizeof c->mistakes / sizeof c->mistakes[0];
    const struct check_mistake *found = NULL, *m = c->mistakes;
    for (size_t i = 0; i < room && m[i].name; ++i) {
        if (!explains(&m[i], got, c))
            continue;
        if (found && strcmp(found->name, m[i].name) != 0)
            return NULL;
        found = &m[i];
    }
    return found;
}

/* Returns the question for an answer that is a NaN. It replaces the suite's
   question about physics, because a NaN has many causes and the input does
   not show which one it was. */
static const char *ask_of_nan(double got)
{
    return is_empty(got)
               ? "Nothing has been put into this place. Which line of "
                 "yours should fill it, and does your function come "
                 "there?"
               : "This is not a number. Where does it begin: with zero "
                 "divided by zero, the root of something negative, an "
                 "infinity less an infinity, or a variable that has no "
                 "value yet?";
}

static char asked[512], about[512]; /* set by check_ask and check_about */

void check_ask(const char *question)
{
    snprintf(asked, sizeof asked, "%s", question);
}

const char *check_about(const char *input)
{
    if (input)
        snprintf(about, sizeof about, "%s", input);
    return about;
}

/* Reports a failed check. If the answer shows a known mistake, prints its
   hint instead of the question, which would distract from the mistake. */
static void say_failure(double got, const struct check *c)
{
    char wanted[64], found[64];
    const char *space = c->unit && *c->unit ? " " : "";
    const char *unit = c->unit ? c->unit : "";
    const char *reason = c->because ? c->because : "";
    const struct check_mistake *mistake = mistake_behind(got, c);
    number_pair(wanted, found, sizeof wanted, c->expected, got);
    say("quantity", c->quantity);
    say("input", c->input ? c->input : about);
    say("expected", check_text("%s%s%s", wanted, space, unit));
    say("got", check_text("%s%s%s", found, space, unit));
    say("tolerance", check_text("%.3g%s%s%s%s", c->tolerance, space, unit,
                                *reason ? ": " : "", reason));
    say("book", c->equation ? c->equation : check_suite.equation);
    if (mistake)
        say("hint", check_text("%s [%s]", mistake->hint, mistake->name));
    else
        say("question", isnan(got) && !isnan(c->expected) ? ask_of_nan(got)
                        : c->question                     ? c->question
                                                          : asked);
}

/* Reports that the test has failed, and ends its process. */
static _Noreturn void end_failed(void)
{
    fflush(NULL);
    report(REPORT_VERDICT, "failed");
    _exit(EXIT_SUCCESS);
}

/* Ends the test at its first failure. CUnit also counts passed comparisons,
   because a test without comparisons must not pass. */
void check_near(double got, struct check c)
{
    const bool passed = near(got, c.expected, c.tolerance);
    CU_assertImplementation(passed, 0, "CHECK_NEAR", "", "", CU_FALSE);
    if (passed)
        return;
    if (CU_get_number_of_failure_records() == 1)
        say_failure(got, &c);
    end_failed();
}

/* Reports that a function wrote outside an output. The name of the output
   comes from the program in the sandbox and may contain any bytes. It is
   cut at the first character that cannot be part of a name. */
static void say_overrun(const struct check_overrun *o)
{
    static const char low[] = "Does your function use an index below 0?";
    static const char high[] = "Which index has the last one, and which is "
                               "the largest that your function uses?";
    const int length = (int)strspn(o->place, "abcdefghijklmnopqrstuvwxyz"
                                             "0123456789_");
    const char *side = o->before ? "before" : "behind";
    const char *name = check_text("%.*s", length, o->place);
    say("quantity", check_text("what stands %s %s", side, name));
    say("expected", check_text("untouched: only %s itself is yours", name));
    say("got", check_text("%d bytes changed by your function", o->bytes));
    say("question", check_text("The first value of %s is %s[0]. %s", name,
                               name, o->before ? low : high));
}

void check_overrun(const struct check_overrun *overrun)
{
    struct check_overrun o = *overrun;
    o.place[sizeof o.place - 1] = '\0';
    if (CU_get_number_of_failure_records() == 0)
        say_overrun(&o);
    CU_assertImplementation(CU_FALSE, 0, "check_overrun", o.place, "",
                            CU_FALSE);
}

void check_demand(const char *what, double asked, double most)
{
    if (asked <= most)
        return;
    if (CU_get_number_of_failure_records() == 0) {
        say("quantity",
            check_text("%s that your function asks for at once", what));
        say("expected", check_text("at most %.10g", most));
        say("got", check_text("%.10g", asked));
        say("question", "How many does it need, and how many has the "
                        "memory room for that it hands over?");
    }
    end_failed();
}

static struct random inputs;

/* Makes the inputs of a test independent of the tests that ran before. The
   factor is odd and has many bits set, so that neighbouring seeds and tests
   get different sequences. */
static void seed_inputs(uint64_t seed, int number)
{
    random_seed(&inputs, seed + (uint64_t)number * 0x9e3779b97f4a7c15u);
}

/* The seed is computed from the report's nonce, which is new in each
   run. */
void check_shuffle(int order[], int count)
{
    struct random drawn;
    uint64_t seed = 0;
    const char *c = report_nonce;
    while (c < report_nonce + REPORT_NONCE)
        seed = seed * 0x100000001b3u + (unsigned char)*c++;
    random_seed(&drawn, seed);
    int i = 0;
    while (i < count) {
        const size_t j = random_below(&drawn, (uint64_t)i + 1);
        order[i] = order[j];
        order[j] = i++;
    }
}

/* printf rounds the number to four digits. strtod then returns the same
   double as the compiler does for these digits in a source file. */
double check_draw(double low, double high)
{
    char text[32];
    snprintf(text, sizeof text, "%.3e", random_between(&inputs, low, high));
    return strtod(text, NULL);
}

int check_draw_whole(int low, int high)
{
    const uint64_t count = (uint64_t)((int64_t)high - low + 1);
    return (int)(low + (int64_t)random_below(&inputs, count));
}

static bool is_idle(const struct check_test *t)
{
    const size_t room = sizeof check_suite.idle / sizeof *check_suite.idle;
    for (size_t i = 0; i < room; ++i)
        if (check_suite.idle[i] == t->run)
            return true;
    return false;
}

/* Prints the suite's file, title and minutes, and then a line for each
   test: its points, its points with another seed, whether it is idle (0 or
   1; see struct check_suite), and its name. Make must run this only in
   programs without a student's code, which could change the list. */
static int list_suite(void)
{
    printf("file %s\ntitle %s\nminutes %d\n", check_suite.file,
           check_suite.title, check_suite.minutes);
    for (const struct check_test *t = check_suite.tests; t->name; ++t)
        printf("test %d %d %d %s\n", t->points, t->hidden, is_idle(t),
               t->name);
    for (const struct check_test *t = check_hidden; t->name; ++t)
        printf("hidden %d %s\n", t->points, t->name);
    return fflush(stdout) ? EXIT_FAILURE : EXIT_SUCCESS;
}

#ifdef __linux__
int __lsan_do_recoverable_leak_check(void) __attribute__((weak));
#endif
static bool leaks_wanted = true;

/* Makes the sanitizer look for leaked memory. This happens in a child
   process, because the sanitizer ends its process if tracing is not
   allowed. It happens after the verdict, because a leak costs no points. */
static void look_for_leaks(void)
{
#ifdef __linux__
    const bool can = leaks_wanted && __lsan_do_recoverable_leak_check;
    const pid_t pid = can ? fork() : -1;
    if (pid == 0) {
        __lsan_do_recoverable_leak_check();
        _exit(EXIT_SUCCESS);
    }
    if (pid > 0)
        waitpid(pid, NULL, 0);
#endif
}

/* Returns whether the test has passed. A test that checked nothing fails;
   otherwise a mistake in the suite, such as a loop over an empty range,
   would let everybody pass. */
static bool has_passed(void)
{
    const bool checked = CU_get_number_of_asserts() > 0;
    if (!checked)
        say("question", "This test checked nothing. Is its suite "
                        "complete?");
    return checked && CU_get_number_of_failures() == 0;
}

/* Runs one test with CUnit, which counts the checks, and writes the verdict
   as the report's last line. Each process runs only one test, because CUnit
   does not survive a crash and does not notice that a student called
   exit(0). Buffered output is flushed before the verdict: if it exceeds the
   file size limit, the program is killed without a verdict. */
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
    const bool passed = has_passed();
    report(REPORT_VERDICT, passed ? "passed" : "failed");
    if (passed)
        look_for_leaks();
    return EXIT_SUCCESS;
}

#ifdef __linux__
/* Drops the privileges that a judge does not need, and changes to this
   user. Only the grader links this function; in other programs its address
   is NULL. */
void judge_confine(long user) __attribute__((weak));
#endif

/* Returns the test with this number, or NULL. Numbers start at 1; the
   hidden tests follow the tests of the suite. */
static const struct check_test *find_test(int number)
{
    const struct check_test *lists[] = {check_suite.tests, check_hidden};
    for (size_t i = 0; number > 0 && i < 2; ++i)
        for (const struct check_test *t = lists[i]; t->name; ++t)
            if (--number == 0)
                return t;
    return NULL;
}

#ifdef __linux__
long syscall(long number, ...);
#endif

/* Waits for orders and forks a child for each. Returns the order in the
   child, which then runs that one test. A runner with sanitizers takes as
   long to start as ten tests take to run, so it starts only once. It forks
   before it has run any of the student's code. CLONE_PARENT makes the
   examiner the parent of the child, so the examiner can wait for the child
   and get its status from the kernel. The C library has no function for
   that. */
static struct report_order next_order(void)
{
#ifdef __linux__
    struct report_order order;
    while (read(REPORT_ORDERS, &order, sizeof order) == sizeof order) {
        const pid_t pid =
            (pid_t)syscall(SYS_clone, CLONE_PARENT | SIGCHLD, 0, 0, 0, 0);
        if (pid == 0) {
            setpgid(0, 0);
            close(REPORT_ORDERS);
            return order;
        }
        if (write(REPORT_ORDERS, &pid, sizeof pid) != sizeof pid)
            break;
    }
#endif
    _exit(EXIT_FAILURE);
}

/* Lists the suite or runs one test. Output is flushed at each line end,
   because the last lines before a crash help a student most. The process
   ends with _exit, which skips exit handlers: one that the student's code
   registered could call exit(1) and turn a passed test into a crash. To
   start a runner by hand, for example in a debugger, use: `printf %032d 0
   >report; build/check/01a.stub 1 3<>report; cat report`. */
int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "--list") == 0)
        return list_suite();
    const bool known = argc >= 2 && argc <= 4;
    const bool waits = known && strcmp(argv[1], "-") == 0;
    struct report_order order = {.leaks = true};
#ifdef __linux__
    if (argc == 4 && judge_confine)
        judge_confine(atol(argv[3]));
#endif
    if (waits) {
        order = next_order();
    } else if (known) {
        order.number = atoi(argv[1]);
        order.seed = argc >= 3 ? strtoull(argv[2], NULL, 10) : 0;
    }
    leaks_wanted = order.leaks;
    const struct check_test *test = find_test(order.number);
    if (!test || !report_open()) {
        fprintf(stderr,
                "usage: %s --list, or TEST [SEED [USER]] 3<>REPORT\n",
                argv[0]);
        return EXIT_FAILURE;
    }
    seed_inputs(order.seed, order.number);
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    _exit(run_test(test));
}
