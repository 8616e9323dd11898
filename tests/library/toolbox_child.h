/* Runs a function in a process of its own and keeps what it leaves: its
   exit status (or 128 + the signal that ended it), and what it wrote to
   standard output and standard error. */
#ifndef TOOLBOX_CHILD_H
#define TOOLBOX_CHILD_H

#include "unit.h"

#include <sys/wait.h>
#include <unistd.h>

struct child {
    int status;
    char out[4096], err[4096];
};

static inline void child_read(FILE *file, char text[4096])
{
    rewind(file);
    text[fread(text, 1, 4095, file)] = '\0';
    fclose(file);
}

/* argument goes to run; run's result is the exit status. stdout_file, if it
   is not NULL, is opened as standard output; "" closes it instead. */
static inline struct child child_run(int (*run)(void *), void *argument,
                                     const char *stdout_file)
{
    struct child c = {.status = -1};
    FILE *out = tmpfile(), *err = tmpfile();
    int status = 0;
    fflush(NULL);
    const pid_t pid = fork();
    if (pid == 0) {
        dup2(fileno(out), STDOUT_FILENO);
        dup2(fileno(err), STDERR_FILENO);
        if (stdout_file && *stdout_file)
            (void)!freopen(stdout_file, "w", stdout);
        else if (stdout_file)
            close(STDOUT_FILENO);
        alarm(30); /* a child that hangs fails */
        exit(run(argument));
    }
    if (pid > 0 && waitpid(pid, &status, 0) == pid)
        c.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status)
                                       : WEXITSTATUS(status);
    child_read(out, c.out);
    child_read(err, c.err);
    return c;
}

/* Passes when the child ends with this status and has said this, and only
   this, on standard error. */
static inline void child_says(struct child c, int status, const char *said)
{
    UNIT_EQUAL(c.status, status);
    UNIT_SAYS(c.err, said);
}

#endif
