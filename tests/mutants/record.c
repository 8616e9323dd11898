/* A runner that keeps what every check was given. Linked with a suite and
   an answer in the place of src/examiner/check.c, with all tests in one go:

       record points [SEED]   a line for each test: its number, 1 if it is
                              idle, else 0, and passed, failed or undone
       record values [SEED]   a line for each check, and no test ends at its
                              first: test, place, input, expected, got,
                              tolerance, passed (1 or 0), mistakes; tabs
                              stand between them */

#define main check_main
#define check_near check_near_told
#define exercise_not_done exercise_not_done_told
#include "examiner/check.c"
#undef main
#undef check_near
#undef exercise_not_done

#include <sys/resource.h>
#include <sys/wait.h>

enum { FAILED = 1, UNDONE = 2 };

static bool values, failed, checked;
static int number;

void exercise_not_done(const char *file, int line)
{
    (void)file;
    (void)line;
    _exit(UNDONE);
}

static void text(const char *s)
{
    for (; s && *s; ++s)
        putchar(*s == '\t' || *s == '\n' ? ' ' : *s);
    putchar('\t');
}

/* The names of all mistakes that explain a number. */
static void mistakes(double got, const struct check *c)
{
    struct check one = *c;
    one.mistakes[1].name = NULL;
    for (size_t i = 0; i < 8 && c->mistakes[i].name; ++i) {
        one.mistakes[0] = c->mistakes[i];
        if (mistake_behind(got, &one))
            printf(" %s", c->mistakes[i].name);
    }
    putchar('\n');
}

bool check_near(const char *file, int line, double got, struct check c);
bool check_near(const char *file, int line, double got, struct check c)
{
    const bool passed = near(got, c.expected, c.tolerance);
    (void)file;
    checked = true;
    failed |= !passed;
    if (!values)
        return passed;
    printf("%d\t%d\t", number, line);
    text(c.quantity);
    text(c.input);
    printf("%.17g\t%.17g\t%.17g\t%d\t", c.expected, got, c.tolerance,
           passed);
    mistakes(passed ? c.expected : got, &c);
    return true;
}

static _Noreturn void run(const struct check_test *t, uint64_t seed)
{
    const struct rlimit limit = {2, 2};
    setrlimit(RLIMIT_CPU, &limit);
    report_owner = -1;
    seed_inputs(seed, number);
    t->run();
    fflush(stdout);
    _exit(checked && !failed ? EXIT_SUCCESS : FAILED);
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 2 ? strtoull(argv[2], NULL, 10) : 0;
    values = argc > 1 && strcmp(argv[1], "values") == 0;
    for (const struct check_test *t = check_suite.tests; t->name; ++t) {
        int status;
        ++number;
        fflush(stdout);
        const pid_t pid = fork();
        if (pid == 0)
            run(t, seed);
        if (waitpid(pid, &status, 0) != pid)
            return EXIT_FAILURE;
        if (!values)
            printf("%d %d %s\n", number, is_idle(t),
                   status == 0 ? "passed"
                   : WIFEXITED(status) && WEXITSTATUS(status) == UNDONE
                       ? "undone"
                       : "failed");
    }
    return EXIT_SUCCESS;
}
