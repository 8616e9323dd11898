/* Runs a program under limits on time, memory and files. */
#ifndef PROCESS_H
#define PROCESS_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/resource.h>
#include <sys/types.h>

/* The limits of a program; RLIM_INFINITY means none. An endless loop is
   stopped when its processor time is used up, which is fair on a busy
   machine; a program that sleeps or waits uses none, so it is stopped after
   twice that time by the wall clock. */
struct process_limits {
    int seconds;         /* of processor time; twice that of wall-clock time
                          */
    rlim_t memory_bytes; /* of address space */
    rlim_t file_bytes;   /* of each file that it writes */
    rlim_t processes;    /* of its user, with threads */
};

/* Open descriptors for a program, and what is done before it starts. */
struct process_files {
    int output;          /* standard output and standard error */
    int kept[6];         /* become 3, 4, ...; unused ones are 0 */
    void (*enter)(void); /* called in the new process first, or NULL */
};

/* How a program ended. */
struct process_end {
    int status;     /* as waitpid gives it */
    bool timed_out; /* it reached a limit on time */
    bool waited;    /* and that was the wall clock's */
};

/* Runs a command (a NULL-terminated list, the program looked up in PATH)
   in a folder and a process group of its own, with empty input, these
   descriptors and limits, and no core files. Returns when it has ended and
   everything in its group is killed; false when no process could be
   started (errno says why). */
bool process_run(char *const command[], const char *folder,
                 const struct process_files *files,
                 const struct process_limits *limits,
                 struct process_end *end);

/* Starts a command as process_run does, but returns at once; two may run at
   a time. All limits are enforced except that on wall-clock time, which the
   caller has to watch. Returns false when no process could be started. */
bool process_start(char *const command[], const char *folder,
                   const struct process_files *files,
                   const struct process_limits *limits);

/* Has the process that process_start has started copy itself, through the
   socket `orders', and tells the copy what to do. The copy is our child, in
   a group of its own: this waits for it as process_run does, for twice this
   number of seconds, and also kills it when it uses more than memory_bytes.
   Returns false when there was no copy. */
bool process_copy(int orders, const void *order, size_t length, int seconds,
                  rlim_t memory_bytes, struct process_end *end);

/* Kills what process_start has started last, with its group, and returns
   how it ended; does nothing when there is none. */
struct process_end process_stop(void);

/* Returns a descriptor by which poll learns that the child has ended, or
   -1. */
int process_watch(pid_t pid);

/* Returns seconds of the monotonic clock. */
double process_clock(void);

/* Makes SIGINT, SIGTERM and SIGHUP stop the running program instead of
   us. */
void process_catch_signals(void);

/* Returns the signal that was caught, or 0. */
int process_signal(void);

#endif
