/* Calls the student's function in the sandbox, on orders of the judge. */
#include "examiner/remote.h"
#include "examiner/exercise.h"
#include "examiner/endless.h"
#include "examiner/guards.h"
#include "examiner/transport.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

enum { REQUESTS = 3, ANSWERS = 4, MEMORY_MORE = 1 << 29 };

void transport_lost(void)
{
    _exit(EXIT_FAILURE);
}

/* Begins the answer. If a guard was changed, first sends a message about
   that. A student who forges the answer gains nothing, because that would
   only hide an overrun. */
void remote_reply(void)
{
    struct check_overrun overrun;
    if (guards_overrun(&overrun)) {
        transport_send(TRANSPORT_OVERRUN);
        transport_move(&overrun, sizeof overrun);
    }
    transport_send(TRANSPORT_REPLY);
}

void remote_callback(int which)
{
    transport_send(TRANSPORT_CALLBACK);
    remote_ints(&which, 1);
}

/* Waits for the answer to a callback. If the function calls back too often,
   the suite leaves the call by longjmp. Then another message arrives
   instead of the answer, and this process ends. */
void remote_callback_wait(void)
{
    endless_forget();
    if (transport_receive() == TRANSPORT_CALLBACK_REPLY)
        return;
    fflush(NULL);
    _exit(EXIT_SUCCESS);
}

void exercise_not_done(const char *file, int line)
{
    (void)file;
    transport_send(TRANSPORT_NOT_DONE);
    remote_ints(&line, 1);
    remote_callback_wait();
    _exit(EXIT_SUCCESS);
}

int __lsan_do_recoverable_leak_check(void) __attribute__((weak));
int __sanitizer_install_malloc_and_free_hooks(
    void (*taken)(const volatile void *, size_t),
    void (*freed)(const volatile void *)) __attribute__((weak));

static unsigned long blocks;

/* Counts allocated blocks. A search for leaks goes through all memory and
   takes longer than most tests, so it is skipped if only the kit has
   allocated memory. */
static void count_taken(const volatile void *block, size_t bytes)
{
    (void)block, (void)bytes;
    ++blocks;
}

static void ignore_freed(const volatile void *block)
{
    (void)block;
}

static _Noreturn void serve(void)
{
    transport_open(REQUESTS, ANSWERS);
    const bool counts = __sanitizer_install_malloc_and_free_hooks &&
                        __sanitizer_install_malloc_and_free_hooks(
                            count_taken, ignore_freed);
    endless_watch();
    while (transport_receive() == TRANSPORT_CALL) {
        endless_forget();
        guards_clear();
        remote_serve();
    }
    fflush(NULL);
    if (__lsan_do_recoverable_leak_check &&
        (!counts || blocks > remote_blocks))
        __lsan_do_recoverable_leak_check();
    _exit(EXIT_SUCCESS);
}

static double children_seconds(void)
{
    struct rusage used;
    getrusage(RUSAGE_CHILDREN, &used);
    return (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

/* Returns the status, but with SIGXCPU in place of SIGKILL if the processor
   time was used up. SIGKILL alone is ambiguous: the kernel also sends it
   when memory runs out. */
static int name_clock(int status, double seconds)
{
    struct rlimit limit;
    const bool killed = WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
    return killed && getrlimit(RLIMIT_CPU, &limit) == 0 &&
                   seconds >= (double)limit.rlim_cur
               ? SIGXCPU
               : status;
}

/* Runs a test in a child process, which is far cheaper than a new sandbox
   and begins with fresh static variables. At the end kills the child's
   process group, because the student's code may have left processes
   running. The message about the end comes from the sandbox and proves
   nothing, but a student who forges it can only claim to have crashed. */
static void run_test(void)
{
    char message[1 + TRANSPORT_HOW * sizeof(int)] = {TRANSPORT_ENDED};
    int how[TRANSPORT_HOW] = {0};
    const double before = children_seconds();
    const pid_t pid = fork();
    if (pid == 0) {
        setpgid(0, 0);
        serve();
    }
    if (pid < 0 || waitpid(pid, &how[0], 0) != pid)
        exit(EXIT_FAILURE);
    kill(-pid, SIGKILL);
    const double used = children_seconds() - before;
    how[0] = name_clock(how[0], used);
    how[1] = (int)(1e3 * used);
    memcpy(message + 1, how, sizeof how);
    if (write(ANSWERS, message, sizeof message) != sizeof message)
        exit(EXIT_FAILURE);
}

/* Limits the address space to 512 MiB more than is mapped now. The limit
   cannot be set earlier, since sanitizers map terabytes before main. */
static void limit_addresses(void)
{
    struct rlimit limit;
    unsigned long pages;
    FILE *map = fopen("/proc/self/statm", "r");
    if (map && fscanf(map, "%lu", &pages) == 1 &&
        getrlimit(RLIMIT_AS, &limit) == 0 &&
        limit.rlim_max == RLIM_INFINITY) {
        limit.rlim_cur = limit.rlim_max =
            (rlim_t)pages * (rlim_t)sysconf(_SC_PAGESIZE) + MEMORY_MORE;
        setrlimit(RLIMIT_AS, &limit);
    }
    if (map)
        fclose(map);
}

/* Waits for tests and runs each in a child. Reads without stdio, whose
   buffer would also take bytes meant for the child. Any byte that does not
   begin a test is sent back, which tells the judge that no child was there
   to read it. PR_SET_DUMPABLE prevents children, which run as the same
   user, from writing to this process's memory through /proc. */
int main(void)
{
    char word = TRANSPORT_READY;
#ifdef __linux__
    prctl(PR_SET_DUMPABLE, 0);
#endif
    limit_addresses();
    if (write(ANSWERS, &word, 1) != 1)
        return EXIT_FAILURE;
    while (read(REQUESTS, &word, 1) == 1)
        if (word == TRANSPORT_TEST)
            run_test();
        else if (write(ANSWERS, &word, 1) != 1)
            return EXIT_FAILURE;
    return EXIT_SUCCESS;
}
