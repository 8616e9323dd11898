/* Runs a program under limits on time, memory and files. */
#ifndef PROCESS_H
#define PROCESS_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/resource.h>
#include <sys/types.h>

/* The limits of a program; RLIM_INFINITY means none. An endless loop is
   stopped when its processor time is used up, which is fair on a busy
   machine; a program that sleeps or waits uses no processor time, so it is
   stopped after twice that wall-clock time. */
struct process_limits {
    int seconds;         /* processor time; half the wall-clock limit */
    rlim_t memory_bytes; /* address space, bytes */
    rlim_t file_bytes;   /* bytes of each file written */
    rlim_t processes;    /* processes and threads of the user */
};

/* Open descriptors for a program, and a function called before it
   starts. */
struct process_files {
    int output;          /* standard output and standard error */
    int kept[6];         /* become 3, 4, ...; 0: unused */
    void (*enter)(void); /* called in the new process; NULL: none */
};

/* The end of a program. */
struct process_end {
    int status;     /* status as from waitpid */
    bool timed_out; /* a limit on time was reached */
    bool waited;    /* it was the limit on wall-clock time */
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
   a time. The caller has to enforce the limit on wall-clock time, which is
   the only one not enforced. Returns false when no process could be
   started. */
bool process_start(char *const command[], const char *folder,
                   const struct process_files *files,
                   const struct process_limits *limits);

/* Makes the process that process_start has started copy itself, and sends
   the copy an order, both through the socket `orders'. The copy is our
   child, in a group of its own: this waits for it as process_run does, for
   twice this number of seconds, and also kills it when it uses more than
   memory_bytes. Returns false when there was no copy. */
bool process_copy(int orders, const void *order, size_t length, int seconds,
                  rlim_t memory_bytes, struct process_end *end);

/* Kills the process that process_start started last, with its group, and
   returns how it ended; does nothing when there is none. */
struct process_end process_stop(void);

/* Returns a descriptor that becomes readable when the child has ended, or
   -1. */
int process_watch(pid_t pid);

/* Returns seconds of the monotonic clock. */
double process_clock(void);

/* Makes SIGINT, SIGTERM and SIGHUP end the running program, not this
   one. */
void process_catch_signals(void);

/* Returns the signal that was caught, or 0. */
int process_signal(void);

#endif
