/* Runs a program under limits on time, memory and files. */
#ifndef PROCESS_H
#define PROCESS_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/resource.h>
#include <sys/types.h>

/* The limits of a program; RLIM_INFINITY means none. A loop without end is
   stopped by the processor's clock, which is fair on a busy machine but
   stands still while a program sleeps or waits; so the clock on the wall
   runs as well, to twice as much. */
struct process_limits {
    int seconds;         /* of processor time; twice that on the wall */
    rlim_t memory_bytes; /* of address space */
    rlim_t file_bytes;   /* of any one file that it writes */
    rlim_t processes;    /* of its user, threads included */
};

/* What a program is given open, and what is done before it starts. */
struct process_files {
    int output;  /* where it prints and complains */
    int kept[6]; /* become 3, 4, ... as far as they go; the rest are 0 */
    void (*enter)(void); /* called in its process just before, or NULL */
};

/* How a program ended. */
struct process_end {
    int status;     /* as waitpid gives it */
    bool timed_out; /* it reached one of the limits on time */
    bool waited;    /* and that was the one on the wall */
};

/* Runs a command (a NULL-terminated list, the program looked for in PATH)
   in a folder and in a process group of its own, with nothing to read,
   the files given, within the limits and without core files.
   Returns when it has ended, with everything in its group killed; false
   when no process could be started (errno says why). */
bool process_run(char *const command[], const char *folder,
                 const struct process_files *files,
                 const struct process_limits *limits,
                 struct process_end *end);

/* Starts a command in the same way and lets it run beside us, two at most;
   returns false when no process could be started. Its limits hold,
   but for the time on the wall, which is ours to watch. */
bool process_start(char *const command[], const char *folder,
                   const struct process_files *files,
                   const struct process_limits *limits);

/* Tells the process that process_start has started, through the socket
   orders, to copy itself and what the copy is to do. The copy is our child,
   in a group of its own: this waits for it as process_run does, for twice
   so many seconds, and kills it, too, when it uses more than memory_bytes.
   Returns false when there was no copy. */
bool process_copy(int orders, const void *order, size_t length, int seconds,
                  rlim_t memory_bytes, struct process_end *end);

/* Kills what process_start has started last, with its group, and returns
   how it ended; nothing happens when there is none. */
struct process_end process_stop(void);

/* Returns a descriptor that wakes poll when the child has ended, or -1. */
int process_watch(pid_t pid);

/* Returns seconds of the monotonic clock. */
double process_clock(void);

/* Makes SIGINT, SIGTERM and SIGHUP stop the running program instead of
   us. */
void process_catch_signals(void);

/* Returns the signal that was caught, or 0. */
int process_signal(void);

#endif
