/* Sends arguments to the function in the sandbox, and receives answers. */
#include "examiner/remote.h"
#include "examiner/check.h"
#include "examiner/exercise.h"
#include "examiner/transport.h"

#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <errno.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

long syscall(long number, ...);
#endif

enum { ANSWERS = 5, REQUESTS = 6 };

#ifdef __linux__
/* The system calls that a judge needs: it reads and writes files that are
   already open, allocates memory, forks and ends. Even if a student's
   program took over the judge through the data that it sends, it could not
   reach a file, the network or another process. */
static const int allowed[] = {
    SYS_read,         SYS_write,          SYS_writev,
    SYS_pread64,      SYS_ftruncate,      SYS_lseek,
    SYS_fstat,
#ifdef SYS_newfstatat
    SYS_newfstatat,
#endif
    SYS_fcntl,        SYS_close,          SYS_brk,
    SYS_mmap,         SYS_munmap,         SYS_mremap,
    SYS_mprotect,     SYS_madvise,        SYS_futex,
    SYS_rt_sigaction, SYS_rt_sigprocmask, SYS_rt_sigreturn,
    SYS_getpid,       SYS_gettid,         SYS_tgkill, /* for raise */
    SYS_clone,        SYS_setpgid,        SYS_clock_gettime,
    SYS_getrusage,    SYS_getrandom,      SYS_exit,
    SYS_exit_group};

static void forbid_other_calls(void)
{
#if defined __x86_64__
    const unsigned ours = AUDIT_ARCH_X86_64;
#elif defined __aarch64__
    const unsigned ours = AUDIT_ARCH_AARCH64;
#else
    const unsigned ours = 0; /* unknown processor: forbid nothing */
#endif
    enum { CALLS = sizeof allowed / sizeof *allowed };
    struct sock_filter code[CALLS + 5];
    unsigned short n = 0;
    code[n++] = (struct sock_filter)BPF_STMT(
        BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, arch));
    code[n++] = (struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K,
                                             ours, 0, CALLS + 1);
    code[n++] = (struct sock_filter)BPF_STMT(
        BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr));
    for (int i = 0; i < CALLS; ++i)
        code[n++] = (struct sock_filter)BPF_JUMP(
            BPF_JMP | BPF_JEQ | BPF_K, (unsigned)allowed[i],
            (unsigned char)(CALLS - i), 0);
    code[n++] = (struct sock_filter)BPF_STMT(BPF_RET | BPF_K,
                                             SECCOMP_RET_ERRNO | EPERM);
    code[n++] =
        (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    const struct sock_fprog program = {n, code};
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    if (ours)
        prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

void judge_confine(long user);

/* Drops the privileges that a judge does not need. A judge knows the
   expected values, reads data from a sandbox, and may have been started by
   root. It keeps its privileges if the kernel has no filters, or if a
   container refuses this user ID. */
void judge_confine(long user)
{
    if (user > 0 && syscall(SYS_setgroups, 0, NULL) == 0 &&
        setgid((gid_t)user) == 0 && setuid((uid_t)user) != 0)
        transport_lost();
    forbid_other_calls();
}
#endif

void transport_lost(void)
{
    _exit(EXIT_FAILURE);
}

/* Ends the judge with the same signal or status as the test's process, so
   that trial.c reports the end as it does without a sandbox. */
static _Noreturn void end_like(int status)
{
    if (WIFSIGNALED(status)) {
        signal(WTERMSIG(status), SIG_DFL);
        raise(WTERMSIG(status));
    }
    _exit(WEXITSTATUS(status));
}

static bool opened, begun, calling;

/* Ends a call that got no answer: the suite has left it by longjmp, but the
   process in the sandbox is still in the student's function. That process
   is ended; the next call starts a new one. */
static void break_off(void)
{
    int how[TRANSPORT_HOW];
    transport_send(TRANSPORT_OVER);
    if (transport_receive() != TRANSPORT_ENDED)
        transport_lost();
    remote_ints(how, TRANSPORT_HOW);
    begun = calling = false;
}

void remote_restart(void)
{
    if (begun)
        break_off();
}

void remote_call(void)
{
    if (!opened) {
        signal(SIGPIPE, SIG_IGN);
        transport_open(ANSWERS, REQUESTS);
        opened = true;
    }
    if (calling)
        break_off();
    if (!begun)
        transport_send(TRANSPORT_TEST);
    begun = calling = true;
    transport_send(TRANSPORT_CALL);
}

/* Serves a callback, or reports that the function wrote to a guard. */
static void serve_message(int word)
{
    struct check_overrun overrun;
    int number;
    if (word == TRANSPORT_CALLBACK) {
        remote_ints(&number, 1);
        remote_serve_callback(number);
    } else {
        transport_move(&overrun, sizeof overrun);
        check_overrun(&overrun);
    }
}

void remote_wait(void)
{
    int word, line, how[TRANSPORT_HOW];
    while ((word = transport_receive()) == TRANSPORT_CALLBACK ||
           word == TRANSPORT_OVERRUN)
        serve_message(word);
    if (word == TRANSPORT_NOT_DONE) {
        remote_ints(&line, 1);
        exercise_not_done("line", line);
    }
    if (word == TRANSPORT_ENDED) {
        remote_ints(how, TRANSPORT_HOW);
        end_like(how[0]);
    }
    if (word != TRANSPORT_REPLY)
        transport_lost();
    calling = false;
}

void remote_callback_reply(void)
{
    transport_send(TRANSPORT_CALLBACK_REPLY);
}
