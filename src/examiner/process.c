/* Starts programs, watches their time, and kills what they started. */
#include "examiner/process.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#include <sys/syscall.h>

long syscall(long number, ...);
#endif

static volatile sig_atomic_t caught;

/* Stores the signal; a handler can do little else safely. Ctrl-C does not
   reach the tested program, which has a process group of its own. It
   reaches the examiner, whose loop in wait_for_end then kills the program.
   If the handler ended the examiner at once, a student's endless loop would
   run on unnoticed. */
static void catch_signal(int signal)
{
    caught = signal;
}

void process_catch_signals(void)
{
    struct sigaction action = {.sa_handler = catch_signal};
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGHUP, &action, NULL);
}

int process_signal(void)
{
    return caught;
}

/* Lowers the soft limit of a resource to `most`. This guards only against
   accidents, since a program can raise the limit again. A process that
   exceeds its processor time gets SIGXCPU; one that exceeds a file size
   gets SIGXFSZ. Memory is limited through the address space, because every
   Unix has that limit. */
static void restrain(int resource, rlim_t most)
{
    struct rlimit limit;
    if (getrlimit(resource, &limit) == 0 && limit.rlim_cur > most) {
        limit.rlim_cur = most;
        setrlimit(resource, &limit);
    }
}

/* Closes all descriptors from `first` on. Linux has had a system call for
   this since 2020. Without it, the loop stops at 1024, since some machines
   allow a million open files. */
static void close_from(int first)
{
#ifdef SYS_close_range
    if (syscall(SYS_close_range, (unsigned)first, ~0u, 0u) == 0)
        return;
#endif
    const long most = sysconf(_SC_OPEN_MAX);
    const long end = most > 0 && most < 1024 ? most : 1024;
    for (int file = first; file < end; ++file)
        close(file);
}

/* Moves the descriptors in `kept` to 3, 4, ... and returns the next number.
   First copies them to high numbers, because the number that one descriptor
   is to get may still belong to another. The copies stay open on exec. */
static int hand_over(const int kept[6])
{
    int high[6], count = 0;
    while (count < 6 && kept[count] > 0) {
        high[count] = fcntl(kept[count], F_DUPFD, 100);
        ++count;
    }
    for (int i = 0; i < count; ++i)
        dup2(high[i], 3 + i);
    return 3 + count;
}

/* Replaces this process, which was just forked, with the command. Never
   returns. The limits, the process group and the descriptors survive the
   exec. Standard input is empty; otherwise an exercise that reads a number
   would wait for it and seem to hang. All other descriptors are closed: for
   example, the pipe that make -j uses to limit its jobs. */
static void become(char *const command[], const char *folder,
                   const struct process_files *files,
                   const struct process_limits *limits)
{
    const int nothing = open("/dev/null", O_RDONLY);
    setpgid(0, 0);
    dup2(nothing, STDIN_FILENO);
    dup2(files->output, STDOUT_FILENO);
    dup2(files->output, STDERR_FILENO);
    close_from(hand_over(files->kept));
    restrain(RLIMIT_CPU, (rlim_t)limits->seconds);
    restrain(RLIMIT_AS, limits->memory_bytes);
    restrain(RLIMIT_FSIZE, limits->file_bytes);
    restrain(RLIMIT_NPROC, limits->processes);
    restrain(RLIMIT_CORE, 0);
    if (files->enter)
        files->enter();
    if (chdir(folder) == 0)
        execvp(command[0], command);
    fprintf(stderr, "cannot start '%s': %s\n", command[0], strerror(errno));
    _exit(127);
}

double process_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Returns whether a process has ended; a stopped process has not. Leaves
   the status to be collected later: until then no other process can get
   this process ID, and the process group can be killed safely. */
static bool has_ended(pid_t pid)
{
    siginfo_t about = {0};
    return waitid(P_PID, (id_t)pid, &about, WEXITED | WNOHANG | WNOWAIT) ==
               0 &&
           about.si_pid == pid;
}

/* Returns whether a process uses more than `most` bytes of memory. The
   second number in statm is the memory in use, in pages. Forked copies of a
   runner need this check, because a limit on address space is impossible:
   sanitizers map terabytes. */
static bool uses_more(pid_t pid, rlim_t most)
{
    char path[64];
    unsigned long pages = 0;
    if (most == RLIM_INFINITY)
        return false;
    snprintf(path, sizeof path, "/proc/%ld/statm", (long)pid);
    FILE *sizes = fopen(path, "r");
    if (sizes && fscanf(sizes, "%*u %lu", &pages) != 1)
        pages = 0;
    if (sizes)
        fclose(sizes);
    return pages > most / (rlim_t)sysconf(_SC_PAGESIZE);
}

int process_watch(pid_t pid)
{
#ifdef SYS_pidfd_open
    return (int)syscall(SYS_pidfd_open, pid, 0);
#else
    (void)pid;
    return -1;
#endif
}

/* Waits for a process. Returns whether it ran longer than `seconds`. Kills
   its process group if it runs too long, if it uses more than `memory`
   bytes, or if the user interrupts. Kills the group again at the end,
   because the process may have left children. waitpid has no time limit, so
   this function polls: every 20 ms if a pidfd reports the end and the
   memory is not limited, otherwise every 2 ms. */
static bool wait_for_end(pid_t pid, double seconds, rlim_t memory)
{
    struct pollfd end = {process_watch(pid), POLLIN, 0};
    const int nap = end.fd >= 0 && memory == RLIM_INFINITY ? 20 : 2;
    const double start = process_clock();
    bool late = false;
    while (!has_ended(pid)) {
        late = late || process_clock() - start > seconds;
        if (late || process_signal() || uses_more(pid, memory))
            kill(-pid, SIGKILL);
        poll(&end, 1, nap);
    }
    kill(-pid, SIGKILL);
    if (end.fd >= 0)
        close(end.fd);
    return late;
}

enum { MOST_BESIDE = 2 };

static pid_t beside[MOST_BESIDE]; /* started by process_start */
static int besides;

/* Returns true if this child was not started by process_start. */
static bool is_stray(int child)
{
    for (int i = 0; i < besides; ++i)
        if (beside[i] == child)
            return false;
    return child > 0;
}

/* Returns a child that process_start did not start, or 0. A program's child
   can leave its process group by calling setsid. On Linux, when its parent
   ends, such a child becomes a child of this process
   (PR_SET_CHILD_SUBREAPER), and a file in /proc lists all children. On
   other systems it escapes, but no program does this by accident. */
static int find_stray(void)
{
    int child = 0;
#ifdef __linux__
    char path[64];
    snprintf(path, sizeof path, "/proc/self/task/%ld/children",
             (long)getpid());
    FILE *list = fopen(path, "r");
    while (list && fscanf(list, "%d", &child) == 1 && !is_stray(child))
        child = 0;
    if (list)
        fclose(list);
#endif
    return child;
}

static void kill_strays(void)
{
    int stray;
    while ((stray = find_stray()) > 0) {
        kill(stray, SIGKILL);
        if (waitpid(stray, NULL, 0) != stray)
            return;
    }
}

/* Waits for a process and fills in how it ended. SIGKILL alone does not
   prove a time-out, since the kernel also sends it when memory runs out. */
static void collect(pid_t pid, double seconds, rlim_t memory,
                    struct process_end *end)
{
    const bool late = wait_for_end(pid, seconds, memory);
    while (waitpid(pid, &end->status, 0) < 0 && errno == EINTR)
        ;
    end->waited = late;
    end->timed_out = late || (WIFSIGNALED(end->status) &&
                              WTERMSIG(end->status) == SIGXCPU);
    kill_strays();
}

/* Starts a command in a new process. Flushes all buffers first; otherwise
   the new process would print their content again. Parent and child both
   set the process group, since either may run first. A shell with timeout
   and ulimit is no substitute: it cannot tell a segmentation fault from
   exit(139), and timeout does not kill children. */
static pid_t launch(char *const command[], const char *folder,
                    const struct process_files *files,
                    const struct process_limits *limits)
{
    fflush(NULL);
#ifdef __linux__
    prctl(PR_SET_CHILD_SUBREAPER, 1);
#endif
    const pid_t pid = fork();
    if (pid == 0)
        become(command, folder, files, limits);
    if (pid > 0)
        setpgid(pid, pid);
    return pid;
}

bool process_run(char *const command[], const char *folder,
                 const struct process_files *files,
                 const struct process_limits *limits,
                 struct process_end *end)
{
    const pid_t pid = launch(command, folder, files, limits);
    if (pid < 0)
        return false;
    collect(pid, 2.0 * limits->seconds, RLIM_INFINITY, end);
    return true;
}

bool process_start(char *const command[], const char *folder,
                   const struct process_files *files,
                   const struct process_limits *limits)
{
    const pid_t pid =
        besides < MOST_BESIDE ? launch(command, folder, files, limits) : -1;
    if (pid > 0)
        beside[besides++] = pid;
    return pid > 0;
}

struct process_end process_stop(void)
{
    struct process_end end = {0, false, false};
    if (besides == 0)
        return end;
    const pid_t pid = beside[--besides];
    kill(-pid, SIGKILL);
    collect(pid, 1.0, RLIM_INFINITY, &end);
    return end;
}

bool process_copy(int orders, const void *order, size_t length, int seconds,
                  rlim_t memory_bytes, struct process_end *end)
{
    pid_t pid = 0;
    struct pollfd answer = {.fd = orders, .events = POLLIN};
    if (send(orders, order, length, MSG_NOSIGNAL) != (ssize_t)length ||
        poll(&answer, 1, 2000 * seconds) != 1 ||
        read(orders, &pid, sizeof pid) != sizeof pid || pid <= 0)
        return false;
    setpgid(pid, pid);
    collect(pid, 2.0 * seconds, memory_bytes, end);
    return true;
}
