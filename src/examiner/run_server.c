/* Runs a program in the sandbox and returns what it prints. */
#include "examiner/remote.h"
#include "examiner/run.h"
#include "examiner/transport.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { TEXT_MOST = 1 << 20 };

/* Receives one string of an order. Refuses a string longer than TEXT_MOST,
   although only the judge sends orders. */
static char *take_text(void)
{
    size_t length;
    remote_sizes(&length, 1);
    if (length > TEXT_MOST)
        transport_lost();
    char *text = remote_memory(length + 1);
    transport_move(text, length);
    text[length] = '\0';
    return text;
}

static int take_number(int most)
{
    int number;
    remote_ints(&number, 1);
    if (number < 0 || number > most)
        transport_lost();
    return number;
}

static char folder[32], *words[RUN_WORDS + 1], *names[RUN_FILES];

static void write_file(const char *name, const char *text)
{
    char path[96];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    const int file = open(path, O_WRONLY | O_CREAT | O_EXCL, 0600);
    const size_t length = strlen(text);
    if (file < 0 || write(file, text, length) != (ssize_t)length)
        transport_lost();
    close(file);
}

struct order {
    int given;
    enum run_count how;
    double of_law[2]; /* force law's constant; maximum number of calls */
};

/* Receives an order and writes its files into a new folder. Stores the
   arguments and the names of the files for clean_up. */
static struct order take_order(void)
{
    struct order order;
    order.given = take_number(99);
    order.how = (enum run_count)take_number(RUN_OUTSIDE);
    remote_doubles(order.of_law, 2);
    const int count = take_number(RUN_WORDS);
    const int files = take_number(RUN_FILES);
    strcpy(folder, "run.XXXXXX");
    if (!mkdtemp(folder))
        transport_lost();
    for (int i = 0; i < count; ++i)
        words[i] = take_text();
    words[count] = NULL;
    for (int i = 0; i < files; ++i) {
        char *text;
        names[i] = take_text();
        text = take_text();
        write_file(names[i], text);
        free(text);
    }
    return order;
}

int __lsan_do_recoverable_leak_check(void) __attribute__((weak));

/* Replaces this process with the program. The program gets a process group
   of its own, the standard descriptors, the counter, and a folder that
   contains only the files of the order. Its environment is empty, except
   for the options of a sanitizer. It is started through a link named after
   the project; its own name would show the number of the function that it
   is linked with. */
static _Noreturn void become(int given, int out, int complain, int counter)
{
    char program[32], *none[] = {NULL, NULL, NULL};
    const char *start = program;
    static const char *const kept[] = {"ASAN_OPTIONS", "UBSAN_OPTIONS"};
    int count = 0;
    for (int i = 0; i < 2 && __lsan_do_recoverable_leak_check; ++i) {
        const char *value = getenv(kept[i]);
        const size_t room = value ? strlen(value) + 32 : 0;
        if (value && (none[count] = malloc(room)))
            snprintf(none[count++], room, "%s=%s", kept[i], value);
    }
    setpgid(0, 0);
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(complain, STDERR_FILENO);
    if (counter >= 0)
        dup2(counter, RUN_COUNTER);
    for (int file = RUN_COUNTER + (counter >= 0); file < 1024; ++file)
        close(file);
    snprintf(program, sizeof program, "../../program%d", given);
    signal(SIGPIPE, SIG_DFL);
    if (chdir(folder) != 0)
        _exit(127);
    if (link(program, words[0]) == 0)
        start = words[0];
    execve(start, words, none);
    _exit(127);
}

struct stream {
    int file; /* -1 if closed */
    char *text;
    size_t length, most;
    bool more; /* the text was cut after `most` bytes */
};

/* Reads new output of the program. Returns whether there was any. Output
   goes through pipes, which are read while the program runs. So no file of
   16 MB is needed, and nobody waits for a child that keeps printing. */
static bool take_down(struct stream *s)
{
    static char spill[1 << 16];
    if (s->file < 0)
        return false;
    const ssize_t got = read(s->file, spill, sizeof spill);
    if (got < 0)
        return false;
    const size_t room = s->most - s->length;
    const size_t kept = (size_t)got < room ? (size_t)got : room;
    memcpy(s->text + s->length, spill, kept);
    s->length += kept;
    s->more = s->more || (size_t)got > kept;
    if (got == 0) {
        close(s->file);
        s->file = -1;
    }
    return got > 0;
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double seconds_allowed(void)
{
    struct rlimit limit;
    if (getrlimit(RLIMIT_CPU, &limit) == 0 &&
        limit.rlim_cur != RLIM_INFINITY)
        return (double)limit.rlim_cur;
    return 5.0;
}

/* Reads the program's output until the program ends. Kills the program if
   it prints too much, or if its wall-clock time exceeds 1.8 times its limit
   on processor time, since a program that sleeps uses no processor time.
   Sets how[0] to the status, how[1] to whether the program ran too long,
   and how[2] to whether it printed too much. If it printed too much, how[0]
   and how[1] are 0. */
static void watch(pid_t pid, struct stream s[2], int how[3])
{
    const double allowed = seconds_allowed(), start = now();
    bool ended = false, busy = true;
    while (!ended || busy) {
        struct pollfd ready[] = {{s[0].file, POLLIN, 0},
                                 {s[1].file, POLLIN, 0}};
        poll(ready, 2, ended ? 0 : s[0].file < 0 && s[1].file < 0 ? 1 : 20);
        ended = ended || waitpid(pid, &how[0], WNOHANG) == pid;
        busy = take_down(&s[0]);
        busy = take_down(&s[1]) || busy;
        how[1] = how[1] || (!ended && now() - start > 1.8 * allowed);
        if (!ended && (how[1] || s[0].more))
            kill(-pid, SIGKILL);
        busy = busy && !s[0].more;
    }
    kill(-pid, SIGKILL);
    if (WIFSIGNALED(how[0]) && !s[0].more)
        how[1] = how[1] || WTERMSIG(how[0]) == SIGXCPU ||
                 (WTERMSIG(how[0]) == SIGKILL && now() - start > allowed);
    how[2] = s[0].more;
    if (s[0].more)
        how[0] = how[1] = 0;
}

/* Starts the program and watches it. Reading the pipes does not block;
   otherwise a child that the program leaves behind could keep us
   waiting. */
static void run(int given, struct stream s[2], int how[3], int counter)
{
    int out[2], complain[2];
    if (pipe(out) != 0 || pipe(complain) != 0)
        transport_lost();
    fflush(NULL);
    const pid_t pid = fork();
    if (pid == 0)
        become(given, out[1], complain[1], counter);
    close(out[1]);
    close(complain[1]);
    if (pid < 0)
        transport_lost();
    setpgid(pid, pid);
    s[0].file = out[0];
    s[1].file = complain[0];
    for (int i = 0; i < 2; ++i)
        fcntl(s[i].file, F_SETFL, O_NONBLOCK);
    watch(pid, s, how);
    for (int i = 0; i < 2; ++i)
        if (s[i].file >= 0)
            close(s[i].file);
}

/* Counts the calls of the function that the kit gives: in shared memory, or
   in a process that answers the calls. */
struct counter {
    int program, ours; /* two ends of a socket, or one file twice */
    int told;          /* pipe from the process that counts, or -1 */
    pid_t pid;
};

#ifdef __ELF__
void run_law(int which, double constant, int n, const double m[],
             const double x[], double f[]) __attribute__((weak));

/* Answers each request with the forces, until the other end is closed, a
   request is malformed, or there are too many requests. Then sends the
   number of requests. This happens in a process of its own, so that the
   student's program cannot read the constant of the law. */
static _Noreturn void answer_questions(const struct order *order, int ear,
                                       int told)
{
    double question[1 + 3 * RUN_BODIES], f[2 * RUN_BODIES];
    const double *m = question + 1;
    long calls = 0;
    for (;;) {
        const ssize_t got = recv(ear, question, sizeof question, 0);
        const bool whole = got >= (ssize_t)sizeof *question &&
                           question[0] >= 0.0 && question[0] <= RUN_BODIES;
        const int n = whole ? (int)question[0] : 0;
        const size_t masses = (size_t)n * sizeof *m;
        if (!whole || (size_t)got != sizeof *question + 3 * masses ||
            (double)++calls > order->of_law[1])
            break;
        run_law(order->given, order->of_law[0], n, m, m + n, f);
        if (send(ear, f, 2 * masses, MSG_NOSIGNAL) < 0)
            break;
    }
    shutdown(ear, SHUT_RDWR); /* close would affect only this process */
    _exit(write(told, &calls, sizeof calls) == sizeof calls ? EXIT_SUCCESS
                                                            : EXIT_FAILURE);
}

static bool count_outside(const struct order *order, struct counter *c)
{
    int ends[2], told[2];
    if (!run_law)
        return false;
    if (socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends) != 0 ||
        pipe(told) != 0)
        transport_lost();
    fflush(NULL);
    c->pid = fork();
    if (c->pid < 0)
        transport_lost();
    if (c->pid == 0) {
        close(ends[0]);
        answer_questions(order, ends[1], told[1]);
    }
    close(told[1]);
    c->program = ends[0];
    c->ours = ends[1];
    c->told = told[0];
    return true;
}
#else
static bool count_outside(const struct order *order, struct counter *c)
{
    (void)order, (void)c;
    return false;
}
#endif

/* Makes the shared memory for the count. It is a file that is unlinked
   before the program starts. */
static void count_inside(struct counter *c)
{
    char path[] = "count.XXXXXX";
    c->program = c->ours = mkstemp(path);
    if (c->program < 0 || unlink(path) != 0 ||
        ftruncate(c->program, sizeof(long)) != 0)
        transport_lost();
}

static struct counter begin_to_count(const struct order *order)
{
    struct counter c = {-1, -1, -1, 0};
    if (order->how == RUN_UNCOUNTED)
        return c;
    if (order->how != RUN_OUTSIDE || !count_outside(order, &c))
        count_inside(&c);
    return c;
}

static double take_calls(const struct counter *c)
{
    long calls = -1;
    if (c->ours < 0)
        return -1.0;
    if (c->told >= 0) {
        close(c->program);
        shutdown(c->ours,
                 SHUT_RDWR); /* wakes every reader at the other end */
        if (read(c->told, &calls, sizeof calls) != sizeof calls)
            calls = -1;
        close(c->told);
        waitpid(c->pid, NULL, 0);
    } else if (pread(c->ours, &calls, sizeof calls, 0) != sizeof calls) {
        calls = -1;
    }
    close(c->ours);
    return (double)calls;
}

/* Removes the files of the order, the link to the program, and the folder
   if it is empty. */
static void clean_up(void)
{
    char path[96];
    for (int i = 0; i < RUN_FILES && names[i]; ++i) {
        snprintf(path, sizeof path, "%s/%s", folder, names[i]);
        unlink(path);
        free(names[i]);
        names[i] = NULL;
    }
    snprintf(path, sizeof path, "%s/%s", folder, words[0]);
    unlink(path);
    rmdir(folder);
    for (int i = 0; words[i]; ++i)
        free(words[i]);
}

/* Copies the program's standard error to ours. Prints the command first,
   since a test may run the program many times. */
static void tell_complaint(const struct stream *s)
{
    if (s->length == 0)
        return;
    for (int i = 0; words[i]; ++i)
        dprintf(STDERR_FILENO, i ? " %s" : "(%s", words[i]);
    dprintf(STDERR_FILENO, ")\n");
    if (write(STDERR_FILENO, s->text, s->length) < 0)
        transport_lost();
}

void remote_serve(void)
{
    static char complaint[RUN_COMPLAINT];
    struct stream s[2] = {
        {.text = remote_memory(RUN_PRINTS), .most = RUN_PRINTS},
        {.text = complaint, .most = RUN_COMPLAINT}};
    int how[3] = {0, 0, 0};
    const struct order order = take_order();
    const struct counter counter = begin_to_count(&order);
    run(order.given, s, how, counter.program);
    double calls = take_calls(&counter);
    tell_complaint(&s[1]);
    clean_up();
    remote_reply();
    remote_ints(how, 3);
    remote_doubles(&calls, 1);
    remote_sizes(&s[0].length, 1);
    remote_sizes(&s[1].length, 1);
    transport_move(s[0].text, s[0].length);
    transport_move(s[1].text, s[1].length);
    free(s[0].text);
}
