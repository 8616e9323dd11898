/* From chapters/B-examiner.nw: edit there, then run make tangle. */
/* checksum 3052999210 of the lines below */
#ifndef PROCESS_H
#define PROCESS_H

#include <stdbool.h>
#include <sys/resource.h>

/* What a program may use up; RLIM_INFINITY means no limit. */
struct process_limits {
    int seconds;         /* of processor time; twice that on the wall */
    rlim_t memory_bytes; /* of address space */
    rlim_t file_bytes;   /* of any one file that it writes */
};

/* How a program ended. */
struct process_end {
    int status;     /* as waitpid gives it */
    bool timed_out; /* it reached one of the limits on time */
};

/* Runs a command (a NULL-terminated list, the program looked for in PATH)
   in a folder and in a process group of its own, with nothing to read, its
   output and errors in the file output, within the limits and without core
   files. Of our other descriptors it gets keep alone (-1: none).
   Returns when it has ended, with everything in its group killed; false
   when no process could be started (errno says why). */
bool process_run(char *const command[], const char *folder, int output,
                 int keep, const struct process_limits *limits,
                 struct process_end *end);

/* Makes SIGINT, SIGTERM and SIGHUP stop the running program instead of
   us. */
void process_catch_signals(void);

/* The signal that was caught, or 0. */
int process_signal(void);

#endif
