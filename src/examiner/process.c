/* From chapters/B-examiner.nw: edit there, then run make tangle. */
/* checksum 1193103804 of the lines below */
#include "examiner/process.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

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

static void restrain_one(int resource, size_t soft, size_t hard)
{
    struct rlimit now;
    if (getrlimit(resource, &now) != 0)
        return;
    if (now.rlim_max == RLIM_INFINITY || now.rlim_max > hard)
        now.rlim_max = hard;
    now.rlim_cur = now.rlim_max < soft ? now.rlim_max : soft;
    setrlimit(resource, &now);
}

static void restrain(const struct process_limits *limits)
{
    const size_t cpu = (size_t)limits->cpu_seconds;
    restrain_one(RLIMIT_CORE, 0, 0);
    if (cpu)
        restrain_one(RLIMIT_CPU, cpu, cpu + 1);
    if (limits->memory_bytes)
        restrain_one(RLIMIT_AS, limits->memory_bytes, limits->memory_bytes);
    if (limits->file_bytes)
        restrain_one(RLIMIT_FSIZE, limits->file_bytes, limits->file_bytes);
}

static void close_others(int keep)
{
    const long most = sysconf(_SC_OPEN_MAX);
    const long end = most > 0 && most < 1024 ? most : 1024;
    for (int file = 3; file < end; ++file)
        if (file != keep)
            close(file);
}

static void become(char *const command[], int output, int keep,
                   const struct process_limits *limits)
{
    const int nothing = open("/dev/null", O_RDONLY);
    setpgid(0, 0);
    dup2(nothing, STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    close_others(keep);
    restrain(limits);
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

static void wait_for_end(struct process_end *end, int wall_seconds)
{
    const struct timespec nap = {0, 2000000};
    const double start = wall_clock();
    while (!has_ended(end->pid)) {
        end->seconds = wall_clock() - start;
        if (wall_seconds && end->seconds > wall_seconds)
            end->timed_out = true;
        if (end->timed_out || process_signal())
            kill(-end->pid, SIGKILL);
        nanosleep(&nap, NULL);
    }
    kill(-end->pid, SIGKILL);
    while (waitpid(end->pid, &end->status, 0) < 0 && errno == EINTR)
        ;
}

bool process_run(char *const command[], int output, int keep,
                 const struct process_limits *limits,
                 struct process_end *end)
{
    *end = (struct process_end){0};
    fflush(NULL);
    end->pid = fork();
    if (end->pid == 0)
        become(command, output, keep, limits);
    if (end->pid < 0)
        return false;
    setpgid(end->pid, end->pid);
    wait_for_end(end, limits->wall_seconds);
    return true;
}
