/* A runner of all tests in one go, each in a process of its own. Linked
   with a suite and an answer in the place of src/examiner/check.c:

       record [SEED]   a line for each test: its number, 1 if it is idle,
                       else 0, and passed, failed or undone */

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

static bool checked;
static int number;

void exercise_not_done(const char *file, int line)
{
    (void)file;
    (void)line;
    _exit(UNDONE);
}

void check_near(double got, struct check c);
void check_near(double got, struct check c)
{
    checked = true;
    if (!near(got, c.expected, c.tolerance))
        _exit(FAILED);
}

static _Noreturn void run(const struct check_test *t, uint64_t seed)
{
    const struct rlimit limit = {2, 2};
    setrlimit(RLIMIT_CPU, &limit);
    report_owner = -1;
    seed_inputs(seed, number);
    t->run();
    fflush(stdout);
    _exit(checked ? EXIT_SUCCESS : FAILED);
}

int main(int argc, char **argv)
{
    const uint64_t seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 0;
    for (const struct check_test *t = check_suite.tests; t->name; ++t) {
        int status;
        ++number;
        fflush(stdout);
        const pid_t pid = fork();
        if (pid == 0)
            run(t, seed);
        if (waitpid(pid, &status, 0) != pid)
            return EXIT_FAILURE;
        const bool undone =
            WIFEXITED(status) && WEXITSTATUS(status) == UNDONE;
        printf("%d %d %s\n", number, is_idle(t),
               status == 0 ? "passed"
               : undone    ? "undone"
                           : "failed");
    }
    return EXIT_SUCCESS;
}
