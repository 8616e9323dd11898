/* Runs a program under limits on time, memory and files. */
#ifndef PROCESS_H
#define PROCESS_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/resource.h>
#include <sys/types.h>

/* The limits of a program; RLIM_INFINITY means no limit. The limit on
   processor time stops an endless loop, and is fair on a busy machine. A
   program that sleeps uses no processor time, so there is also a limit on
   wall-clock time, which is twice as long. */
struct process_limits {
    int seconds;         /* processor time, s; wall-clock time: twice */
    rlim_t memory_bytes; /* address space, bytes */
    rlim_t file_bytes;   /* size of each file written, bytes */
    rlim_t processes;    /* number of processes and threads of the user */
};

/* Open descriptors for a program, and a function called before it
   starts. */
struct process_files {
    int output;          /* standard output and standard error */
    int kept[6];         /* descriptors to become 3, 4, ...; 0: unused */
    void (*enter)(void); /* called in the new process; NULL: none */
};

/* How a program ended. */
struct process_end {
    int status;     /* status from waitpid */
    bool timed_out; /* a limit on time was reached */
    bool waited;    /* that limit was on wall-clock time */
};

/* Runs a command in the given folder. The command is a NULL-terminated list
   whose first word is looked up in PATH. It gets a process group of its
   own, an empty standard input, and these descriptors and limits; it makes
   no core file. Returns when the command has ended and its process group
   has been killed. Returns false if no process could be started; errno says
   why. */
bool process_run(char *const command[], const char *folder,
                 const struct process_files *files,
                 const struct process_limits *limits,
                 struct process_end *end);

/* Starts a command as process_run does, but returns at once. At most two
   such commands may run at a time. The limit on wall-clock time is not
   enforced; the caller must do that. Returns false if no process could be
   started. */
bool process_start(char *const command[], const char *folder,
                   const struct process_files *files,
                   const struct process_limits *limits);

/* Sends an order through the socket `orders` to a process started by
   process_start. That process forks a copy of itself and answers with the
   copy's process ID. The copy is a child of this process and has a process
   group of its own. Waits for the copy to end. Kills it if it uses more
   than memory_bytes, or after twice the given number of seconds. Returns
   false if there was no copy. */
bool process_copy(int orders, const void *order, size_t length, int seconds,
                  rlim_t memory_bytes, struct process_end *end);

/* Kills the process that process_start started last, together with its
   process group. Returns how the process ended. Does nothing if there is
   none. */
struct process_end process_stop(void);

/* Returns a descriptor that becomes readable when the child ends, or -1 if
   the system has no such descriptors. */
int process_watch(pid_t pid);

/* Returns the time of the monotonic clock (in s), which cannot be set back
   during a test. */
double process_clock(void);

/* Makes SIGINT, SIGTERM and SIGHUP end the program that is being run, not
   this process. */
void process_catch_signals(void);

/* Returns the signal that was caught, or 0. */
int process_signal(void);

#endif
