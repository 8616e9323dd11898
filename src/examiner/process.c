/* From chapters/B-examiner.nw: edit there, then run make tangle. */
/* checksum 15085282 of the lines below */
#include "examiner/process.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

static volatile sig_atomic_t caught;

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

static void restrain(int resource, rlim_t most)
{
    struct rlimit limit;
    if (getrlimit(resource, &limit) == 0 && limit.rlim_cur > most) {
        limit.rlim_cur = most;
        setrlimit(resource, &limit);
    }
}

static void close_others(int keep)
{
    const long most = sysconf(_SC_OPEN_MAX);
    const long end = most > 0 && most < 1024 ? most : 1024;
    for (int file = 3; file < end; ++file)
        if (file != keep)
            close(file);
}

static void become(char *const command[], const char *folder, int output,
                   int keep, const struct process_limits *limits)
{
    const int nothing = open("/dev/null", O_RDONLY);
    setpgid(0, 0);
    dup2(nothing, STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    close_others(keep);
    restrain(RLIMIT_CPU, (rlim_t)limits->seconds);
    restrain(RLIMIT_AS, limits->memory_bytes);
    restrain(RLIMIT_FSIZE, limits->file_bytes);
    restrain(RLIMIT_CORE, 0);
    if (chdir(folder) == 0)
        execvp(command[0], command);
    fprintf(stderr, "cannot start '%s': %s\n", command[0], strerror(errno));
    _exit(127);
}

static double wall_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static bool has_ended(pid_t pid)
{
    siginfo_t about = {0};
    return waitid(P_PID, (id_t)pid, &about, WEXITED | WNOHANG | WNOWAIT) ==
               0 &&
           about.si_pid == pid;
}

static bool wait_for_end(pid_t pid, double seconds)
{
    const struct timespec nap = {0, 2000000};
    const double start = wall_clock();
    bool late = false;
    while (!has_ended(pid)) {
        late = late || wall_clock() - start > seconds;
        if (late || process_signal())
            kill(-pid, SIGKILL);
        nanosleep(&nap, NULL);
    }
    kill(-pid, SIGKILL);
    return late;
}

static void kill_strays(void)
{
#ifdef __linux__
    char path[64];
    int stray = 0;
    snprintf(path, sizeof path, "/proc/self/task/%ld/children",
             (long)getpid());
    do {
        FILE *list = fopen(path, "r");
        if (!list || fscanf(list, "%d", &stray) != 1)
            stray = 0;
        if (list)
            fclose(list);
        if (stray)
            kill(stray, SIGKILL);
    } while (stray && waitpid(stray, NULL, 0) == stray);
#endif
}

bool process_run(char *const command[], const char *folder, int output,
                 int keep, const struct process_limits *limits,
                 struct process_end *end)
{
    fflush(NULL);
#ifdef __linux__
    prctl(PR_SET_CHILD_SUBREAPER, 1);
#endif
    const pid_t pid = fork();
    if (pid == 0)
        become(command, folder, output, keep, limits);
    if (pid < 0)
        return false;
    setpgid(pid, pid);
    const bool late = wait_for_end(pid, 2.0 * limits->seconds);
    while (waitpid(pid, &end->status, 0) < 0 && errno == EINTR)
        ;
    end->timed_out = late || (WIFSIGNALED(end->status) &&
                              WTERMSIG(end->status) == SIGXCPU);
    kill_strays();
    return true;
}
