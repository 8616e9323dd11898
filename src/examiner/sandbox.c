/* Builds and runs programs in sandboxes, which bubblewrap makes. */
#include "examiner/sandbox.h"
#include "examiner/build.h"
#include "examiner/folder.h"
#include "examiner/process.h"
#include "examiner/text.h"
#include "examiner/transport.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pwd.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef __linux__
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

long syscall(long number, ...);
#endif

#define MEMORY_KIB 524288     /* address space of each process, KiB */
#define DISK_BYTES "33554432" /* size of the sandbox's folder, bytes */
#define DISK_FILES "2000"     /* maximum number of files in it */
#define OUTER_WORK "/mnt"     /* its mount point outside the sandbox */

enum {
    BUILD_MS = 45000, /* wall-clock time to compile and link */
    START_MS = 5000,  /* wall-clock time from the build to main */
    SETTLE_MS = 2000, /* wall-clock time to end a test's process */
    DRAW_MS = 30000   /* wall-clock time to draw a figure */
};

enum { WORDS = 128, NUMBERS = 8 };

struct words {
    const char *list[WORDS];
    int count;
    char numbers[NUMBERS][24];
    int made;
};

static void add(struct words *w, const char *const words[])
{
    for (int i = 0; words[i] && w->count < WORDS - 1; ++i)
        w->list[w->count++] = words[i];
    w->list[w->count] = NULL;
}

#define ADD(w, ...) add(w, (const char *const[]){__VA_ARGS__, NULL})
static const char *number(struct words *w, long long x)
{
    char *text = w->numbers[w->made++ % NUMBERS];
    snprintf(text, sizeof w->numbers[0], "%lld", x);
    return text;
}

/* Returns the first of the user IDs `user`, `user` + 2, `user` + 4, ...
   that belongs to no account. */
static long free_user(long user)
{
    while (getpwuid((uid_t)user))
        user += 2;
    return user;
}

/* Returns the user ID for the sandboxes of this process: an even number,
   since judges have odd ones. The kernel counts processes by user, so a
   fork bomb in one sandbox would keep other sandboxes of the same user from
   forking. The ID depends on our process ID, so that two graders on one
   machine use different IDs. Only root can give a sandbox another user. For
   other users, Linux has counted the processes of each user namespace
   separately since version 5.14. */
static long sandbox_user(void)
{
    return free_user(20000 + 2 * ((long)getpid() % 20000));
}

long sandbox_judge(void)
{
    static long user;
    if (!user && geteuid() == 0)
        user = free_user(20001 + 2 * ((long)getpid() % 20000));
    return user;
}

static bool bounded; /* whether mount_disk works; set by sandbox_probe */
/* Settings for enter(), which a new process calls before it becomes
   bubblewrap: enter() empties the environment, changes the user and mounts
   a folder. The commands for these steps (setpriv, env, unshare, mount)
   took longer to start than bubblewrap itself. */
static long new_user; /* user of the next sandbox; 0: our user */
static bool new_view; /* make a new user namespace */
static bool own_disk; /* mount a writable folder with mount_disk */

static void give_up(const char *what)
{
    fprintf(stderr, "no sandbox: cannot %s: %s\n", what, strerror(errno));
    _exit(127);
}

extern char **environ;

/* Removes everything but PATH from the environment before bubblewrap
   starts: a server that grades may keep secret keys in its environment.
   bubblewrap is a process in the sandbox, where /proc would show them. */
static void forget_environment(void)
{
    static char path[4096], *only[] = {path, NULL};
    snprintf(path, sizeof path, "PATH=%s",
             getenv("PATH") ? getenv("PATH") : "/usr/bin:/bin");
    environ = only;
}

static void become_user(void)
{
#ifdef __linux__
    if (syscall(SYS_setgroups, 0, NULL) != 0)
        give_up("leave the groups");
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
#endif
    if (setgid((gid_t)new_user) != 0 || setuid((uid_t)new_user) != 0)
        give_up("become another user");
}

#ifdef __linux__
static void put(const char *path, const char *text)
{
    const int file = open(path, O_WRONLY);
    const ssize_t length = (ssize_t)strlen(text);
    if (file < 0 || write(file, text, (size_t)length) != length)
        give_up("choose users");
    close(file);
}

/* Enters new user and mount namespaces, in which this process is root, but
   only over its own mounts. Some machines allow only bubblewrap to do this;
   there the writable folder has a limit on bytes, but none on files. */
static void become_root_of_a_view(void)
{
    char users[32], groups[32];
    snprintf(users, sizeof users, "0 %ld 1", (long)geteuid());
    snprintf(groups, sizeof groups, "0 %ld 1", (long)getegid());
    if (syscall(SYS_unshare, CLONE_NEWUSER | CLONE_NEWNS) != 0)
        give_up("have users of its own");
    prctl(PR_SET_DUMPABLE, 1);
    put("/proc/self/setgroups", "deny");
    put("/proc/self/uid_map", users);
    put("/proc/self/gid_map", groups);
}

/* Mounts the writable folder, with limits on bytes and on files: a million
   empty files would fill the memory, too. bubblewrap can limit only the
   bytes. */
static void mount_disk(void)
{
    if (new_view)
        become_root_of_a_view();
    else if (syscall(SYS_unshare, CLONE_NEWNS) != 0)
        give_up("have mounts of its own");
    if (mount("none", "/", NULL, MS_REC | MS_PRIVATE, NULL) != 0 ||
        mount("work", OUTER_WORK, "tmpfs", MS_NOSUID | MS_NODEV,
              "size=" DISK_BYTES ",nr_inodes=" DISK_FILES
              ",mode=0777") != 0)
        give_up("mount a folder");
}
#else
static void mount_disk(void)
{
    give_up("mount a folder");
}
#endif

static void enter(void)
{
    forget_environment();
    if (new_user > 0)
        become_user();
    if (own_disk)
        mount_disk();
}

static void plan_entry(enum sandbox_kind kind)
{
    new_user = geteuid() == 0 && kind != SANDBOX_ROOT ? sandbox_user() : 0;
    own_disk = bounded && kind != SANDBOX_NONE;
    new_view = kind != SANDBOX_ROOT;
}

/* Adds the files that the program can see: the compiler, its libraries, and
   one writable folder. /dev and the root directory are in memory, without a
   limit. They are made read-only at the end; otherwise a program could fill
   / and write its own /etc. */
static void add_system(struct words *w)
{
    ADD(w, "--ro-bind", "/usr", "/usr", "--symlink", "usr/bin", "/bin",
        "--symlink", "usr/lib", "/lib", "--symlink", "usr/lib64", "/lib64");
    ADD(w, "--perms", "0755", "--dir", "/etc", "--ro-bind-try",
        "/etc/alternatives", "/etc/alternatives", "--ro-bind-try",
        "/etc/ld.so.cache", "/etc/ld.so.cache", "--ro-bind-try",
        "/etc/fonts", "/etc/fonts");
    ADD(w, "--proc", "/proc", "--dev", "/dev", "--remount-ro", "/dev");
    if (bounded)
        ADD(w, "--bind", OUTER_WORK, "/work");
    else
        ADD(w, "--perms", "0777", "--size", DISK_BYTES, "--tmpfs", "/work");
    ADD(w, "--perms", "0755", "--dir", "/kit", "--perms", "0755", "--dir",
        "/exercises");
}

/* Adds copies of the order's files, made from open descriptors. So the
   sandbox's user needs no access to our folders and learns no path to
   them. */
static void add_copies(struct words *w, const struct sandbox_order *order)
{
    static char source[256], header[80];
    snprintf(source, sizeof source, "/%s", order->name);
    snprintf(header, sizeof header, "/%s", order->included);
    ADD(w, "--perms", "0444", "--ro-bind-data", "5", source);
    ADD(w, "--perms", "0444", "--ro-bind-data", "6", header);
    ADD(w, "--perms", "0444", "--ro-bind-data", "7",
        "/kit/sandbox.suite.o");
    ADD(w, "--seccomp", "8", "--remount-ro", "/");
}

/* Adds bubblewrap's options for namespaces. A new session has no terminal,
   so the program cannot send input to one (TIOCSTI). The sandbox has none
   of root's capabilities, and is killed when this process ends. */
static void add_namespaces(struct words *w, enum sandbox_kind kind)
{
    ADD(w, "bwrap", "--unshare-ipc", "--unshare-pid", "--unshare-net",
        "--unshare-uts", "--unshare-cgroup-try", "--die-with-parent",
        "--new-session", "--clearenv", "--cap-drop", "ALL");
    if (kind == SANDBOX_ROOT)
        ADD(w, "--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID",
            "--cap-add", "CAP_SETPCAP");
    else
        ADD(w, "--unshare-user");
    if (kind == SANDBOX_SEALED)
        ADD(w, "--disable-userns");
    if (geteuid() != 0 || (bounded && kind != SANDBOX_ROOT))
        ADD(w, "--uid", "65534", "--gid", "65534");
}

static void add_walls(struct words *w, enum sandbox_kind kind,
                      const struct sandbox_order *order)
{
    plan_entry(kind);
    add_namespaces(w, kind);
    add_system(w);
    add_copies(w, order);
    if (kind == SANDBOX_ROOT) {
        const char *user = number(w, sandbox_user());
        ADD(w, "setpriv", "--reuid", user, "--regid", user,
            "--clear-groups", "--no-new-privs", "--inh-caps=-all",
            "--bounding-set=-all");
    }
}

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))
/* System calls that fail with EPERM. shmget and memfd_create give memory
   that belongs to no process and that no limit counts, so a few lines of
   code could take all memory. The other calls help to attack the kernel and
   are not needed to compute. Sanitizers may use ptrace, which they need to
   search for leaks. */
static const int forbidden[] = {
    SYS_ptrace, /* must be first: allowed for sanitizers */
    SYS_shmget,      SYS_memfd_create,    SYS_unshare,
    SYS_setns,       SYS_add_key,         SYS_process_vm_writev,
    SYS_keyctl,      SYS_request_key,     SYS_bpf,
    SYS_userfaultfd, SYS_perf_event_open, SYS_io_uring_setup};

enum { FORBIDDEN = sizeof forbidden / sizeof forbidden[0] };
#ifdef __x86_64__
enum { LAST_CALL = 0x3fffffff }; /* calls of x32 have higher numbers */
static const unsigned OUR_CALLS = AUDIT_ARCH_X86_64;
#else
enum { LAST_CALL = 0x7fffffff };
static const unsigned OUR_CALLS = AUDIT_ARCH_AARCH64;
#endif

#define DO(c, value) code[n++] = (struct sock_filter)BPF_STMT(c, value)
#define SKIP(c, value, yes, no)                                            \
    code[n++] =                                                            \
        (struct sock_filter)BPF_JUMP(BPF_JMP | c | BPF_K, value, yes, no)

/* Returns a pipe that contains the filter of system calls, a BPF program.
   The filter compares the number of each call with the forbidden numbers.
   x86 has three sets of call numbers; a call from a set other than ours
   ends the program. On processors other than x86-64 and ARM64 the filter is
   empty. */
static int open_filter(bool sanitized)
{
    struct sock_filter code[2 * FORBIDDEN + 8];
    int n = 0, ends[2];
    DO(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, arch));
    SKIP(BPF_JEQ, OUR_CALLS, 1, 0);
    DO(BPF_RET | BPF_K, SECCOMP_RET_KILL);
    DO(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr));
    SKIP(BPF_JGT, LAST_CALL, 0, 1);
    DO(BPF_RET | BPF_K, SECCOMP_RET_KILL);
    for (int i = sanitized; i < FORBIDDEN; ++i) {
        SKIP(BPF_JEQ, (unsigned)forbidden[i], 0, 1);
        DO(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM);
    }
    DO(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    const size_t bytes = (size_t)n * sizeof *code;
    if (pipe(ends) != 0 || write(ends[1], code, bytes) != (ssize_t)bytes)
        text_fail("cannot write a filter: %s", strerror(errno));
    close(ends[1]);
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    return ends[0];
}
#else
static int open_filter(bool sanitized)
{
    (void)sanitized;
    return open("/dev/null", O_RDONLY | O_CLOEXEC);
}
#endif

static bool try_kind(enum sandbox_kind kind, const char *compiler)
{
    struct words w = {.count = 0};
    struct process_end end;
    const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
    const int filter = open_filter(false);
    const struct process_files files = {
        .output = nothing,
        .kept = {nothing, nothing, nothing, nothing, nothing, filter},
        .enter = enter};
    const struct process_limits limits = {5, RLIM_INFINITY, RLIM_INFINITY,
                                          RLIM_INFINITY};
    const struct sandbox_order none = {.name = "exercises/none.c",
                                       .included = "kit/exercise.h"};
    add_walls(&w, kind, &none);
    ADD(&w, "/usr/bin/env", "PATH=/usr/bin:/bin", "/bin/sh", "-c",
        "set -- $1; \"$1\" --version && objcopy --version", "sh", compiler);
    const bool ran =
        process_run((char *const *)w.list, "/", &files, &limits, &end);
    close(nothing);
    close(filter);
    return ran && end.status == 0;
}

static bool try_disks(enum sandbox_kind kind)
{
    bounded = true;
    bounded = try_kind(kind, ":");
    return bounded || try_kind(kind, ":");
}

/* Returns the best kind of sandbox in which a command can be started. Also
   tries the compiler in it: if the compiler were missing, no student's
   program would build, and only the marks would show it. */
enum sandbox_kind sandbox_probe(const char *compiler)
{
    enum sandbox_kind kind = SANDBOX_SEALED;
    while (kind != SANDBOX_NONE &&
           ((kind == SANDBOX_ROOT && geteuid() != 0) || !try_disks(kind)))
        ++kind;
    if (kind != SANDBOX_NONE && !try_kind(kind, compiler))
        text_fail("no student's file can be compiled: '%s' or objcopy is "
                  "not in the sandbox, which has no more than /usr",
                  compiler);
    return kind;
}

const char *sandbox_name(enum sandbox_kind kind)
{
    static const char *const names[] = {"sealed namespaces", "namespaces",
                                        "root's namespaces",
                                        "NONE: limits only, no isolation"};
    return names[kind];
}

/* Adds the shell that becomes the student's program: sandbox.sh. */
static void add_script(struct words *w, const struct sandbox_order *order,
                       const char *root)
{
    const char *memory =
        order->sanitized ? "unlimited" : number(w, MEMORY_KIB);
    ADD(w, "/bin/sh", "-c", order->script, "sh", root, order->name,
        order->compiler, order->keep, number(w, order->seconds), memory,
        order->terse, order->lean, order->linker, order->types,
        BUILD_MEMBERS);
}

enum { GONE = -1, LATE = -2, NAP_MS = 50 };

static int wait_for_byte(int file, int milliseconds)
{
    struct pollfd wait = {.fd = file, .events = POLLIN};
    unsigned char byte;
    int ready, left = milliseconds;
    do {
        if (process_signal()) /* a signal may come before the wait */
            return GONE;
        ready = poll(&wait, 1, left < NAP_MS ? left : NAP_MS);
        left -= NAP_MS;
    } while (ready == 0 && left > 0);
    if (ready == 0)
        return LATE;
    return ready > 0 && read(file, &byte, 1) == 1 ? byte : GONE;
}

static char open_root[] = "/tmp/bonkers.XXXXXX";
static bool furnished;

static void copy(int from, const char *name)
{
    char path[512], bytes[4096];
    snprintf(path, sizeof path, "%s/%s", open_root, name);
    const int to = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    ssize_t length;
    lseek(from, 0, SEEK_SET);
    while ((length = read(from, bytes, sizeof bytes)) > 0)
        if (write(to, bytes, (size_t)length) != length)
            text_fail("cannot write '%s': %s", path, strerror(errno));
    if (to < 0 || length < 0)
        text_fail("cannot write '%s': %s", path, strerror(errno));
    close(to);
}

/* Makes the folder that --unsafe uses instead of a sandbox. Root gives
   another user access to it, because the program must not run with root's
   rights. */
static void furnish_folder(const struct sandbox_order *order)
{
    static const char *const folders[] = {"kit", "exercises", "work"};
    char path[512];
    strcpy(open_root, "/tmp/bonkers.XXXXXX");
    if (!mkdtemp(open_root) ||
        (geteuid() == 0 &&
         (chown(open_root, 0, (gid_t)sandbox_user()) != 0 ||
          chmod(open_root, 0750) != 0)))
        text_fail("cannot make a folder in /tmp: %s", strerror(errno));
    furnished = true;
    for (int i = 0; i < 3; ++i) {
        snprintf(path, sizeof path, "%s/%s", open_root, folders[i]);
        if (mkdir(path, 0755) != 0)
            text_fail("cannot make '%s': %s", path, strerror(errno));
    }
    if (geteuid() == 0 &&
        chown(path, (uid_t)sandbox_user(), (gid_t)sandbox_user()) != 0)
        text_fail("cannot give '%s' away: %s", path, strerror(errno));
    copy(order->source, order->name);
    copy(order->header, order->included);
    copy(order->inside, "kit/sandbox.suite.o");
}

static void start(const struct sandbox_order *order, int requests,
                  int answers, int prints)
{
    struct words w = {.count = 0};
    const int filter = open_filter(order->sanitized);
    const struct process_files files = {
        .output = prints,
        .kept = {requests, answers, order->source, order->header,
                 order->inside, filter},
        .enter = enter};
    const struct process_limits limits = {3600, RLIM_INFINITY, 33554432,
                                          RLIM_INFINITY};
    if (order->kind != SANDBOX_NONE) {
        add_walls(&w, order->kind, order);
        add_script(&w, order, "");
    } else {
        furnish_folder(order);
        plan_entry(SANDBOX_NONE);
        add_script(&w, order, open_root);
    }
    lseek(order->source, 0, SEEK_SET);
    lseek(order->header, 0, SEEK_SET);
    lseek(order->inside, 0, SEEK_SET);
    if (!process_start((char *const *)w.list, "/", &files, &limits))
        text_fail("cannot start '%s': %s", w.list[0], strerror(errno));
    close(filter);
}

/* Waits until the program has reached main. The shell sends a byte when the
   program is built, and the driver sends another when it starts. A program
   gains nothing by sending the second byte itself. */
static enum sandbox_stage wait_for_main(struct sandbox *sandbox,
                                        int seconds)
{
    const double start = process_clock();
    const int built = wait_for_byte(sandbox->answers, BUILD_MS);
    sandbox->build_seconds = process_clock() - start;
    if (built != TRANSPORT_BUILT)
        return built == LATE ? SANDBOX_TOO_LONG : SANDBOX_NOT_BUILT;
    const int started = wait_for_byte(sandbox->answers, START_MS);
    if (started == TRANSPORT_READY)
        return SANDBOX_READY;
    const double waited = process_clock() - start - sandbox->build_seconds;
    return started == LATE || waited >= 0.8 * seconds ? SANDBOX_STUCK
                                                      : SANDBOX_NO_MAIN;
}

/* Starts a sandbox and waits until its program is ready or has failed.
   Closes our copies of the sandbox's ends of the pipes; otherwise we would
   not notice when the sandbox ends. */
enum sandbox_stage sandbox_open(struct sandbox *sandbox,
                                const struct sandbox_order *order,
                                int prints)
{
    int in[2], out[2];
    if (pipe(in) != 0 || pipe(out) != 0)
        text_fail("cannot make a pipe: %s", strerror(errno));
    *sandbox = (struct sandbox){in[1], out[0], prints, 0.0, 0};
    fcntl(sandbox->requests, F_SETFD, FD_CLOEXEC);
    fcntl(sandbox->answers, F_SETFD, FD_CLOEXEC);
    start(order, in[0], out[1], prints);
    close(in[0]);
    close(out[1]);
    return wait_for_main(sandbox, order->seconds);
}

/* Sends a byte, unless the program has filled the pipe. Returns whether the
   byte was sent. */
static bool send_byte(int file, char byte)
{
    struct pollfd room = {.fd = file, .events = POLLOUT};
    return poll(&room, 1, SETTLE_MS) == 1 && (room.revents & POLLOUT) &&
           write(file, &byte, 1) == 1;
}

/* Ends the test's process. Returns whether the driver has confirmed the
   end. Each step has a time limit, since the student's code may have
   replaced the driver. */
static bool end_test(struct sandbox *sandbox)
{
    unsigned char how[TRANSPORT_HOW * sizeof(int)];
    if (!send_byte(sandbox->requests, TRANSPORT_OVER))
        return false;
    const int word = wait_for_byte(sandbox->answers, SETTLE_MS);
    bool whole = word == TRANSPORT_OVER || word == TRANSPORT_ENDED;
    for (size_t i = 0; word == TRANSPORT_ENDED && whole && i < sizeof how;
         ++i) {
        const int byte = wait_for_byte(sandbox->answers, SETTLE_MS);
        whole = byte >= 0;
        how[i] = (unsigned char)byte;
    }
    if (word == TRANSPORT_ENDED && whole)
        memcpy(&sandbox->test_ms, how + sizeof(int), sizeof(int));
    return whole;
}

/* Ends the test's process and returns whether the sandbox can run another
   test. end_test is not enough: if a program never stops writing, nine of
   its bytes may look like a status. An empty pipe does not prove that such
   a program has ended: of 400 such programs, 8 were only suspended at that
   moment. So the driver must also return a byte that is sent to it. A
   program that keeps writing would send other bytes first. */
bool sandbox_settle(struct sandbox *sandbox)
{
    sandbox->test_ms = 0;
    return end_test(sandbox) &&
           send_byte(sandbox->requests, TRANSPORT_ECHO) &&
           wait_for_byte(sandbox->answers, SETTLE_MS) == TRANSPORT_ECHO &&
           wait_for_byte(sandbox->answers, 0) == LATE;
}

/* Kills the processes that --unsafe has started, and removes their folder.
   `kill -1` runs as the sandbox's user and kills only that user's
   processes. Run by root, it would kill all processes. */
static void sweep_folder(void)
{
    char command[256];
    snprintf(command, sizeof command,
             "setpriv --reuid %ld --regid %ld --clear-groups "
             "sh -c 'kill -KILL -1' 2>/dev/null",
             sandbox_user(), sandbox_user());
    if (geteuid() == 0 && system(command) < 0)
        text_fail("cannot sweep '%s'", open_root);
    if (!folder_remove(open_root))
        text_fail("cannot remove '%s': %s", open_root, strerror(errno));
    furnished = false;
}

/* Ends the sandbox. Killing bubblewrap ends the sandbox's first process;
   the kernel then kills all others in its namespace. */
void sandbox_close(struct sandbox *sandbox)
{
    close(sandbox->requests);
    close(sandbox->answers);
    process_stop();
    if (furnished)
        sweep_folder();
}

static bool take_figure(int file, char *figure, size_t room, size_t *length)
{
    const double end = process_clock() + 1e-3 * DRAW_MS;
    ssize_t got = 1;
    for (*length = 0; got > 0 && *length < room;) {
        struct pollfd wait = {.fd = file, .events = POLLIN};
        const double left = end - process_clock();
        if (left <= 0.0 || poll(&wait, 1, (int)(1e3 * left) + 1) == 0)
            return false;
        got = read(file, figure + *length, room - *length);
        *length += got > 0 ? (size_t)got : 0;
    }
    return true;
}

/* Draws a project's figure. A gnuplot script can call the shell, and is
   meant to, since its tables come from the student's program. Therefore it
   runs in a sandbox, together with that program. Only a picture of at most
   four megabytes leaves the sandbox. */
enum sandbox_drawing sandbox_draw(const struct sandbox_order *order,
                                  int script, int prints, char *figure,
                                  size_t room, size_t *length)
{
    int out[2];
    struct sandbox_order drawing = *order;
    drawing.keep = "figure";
    if (pipe(out) != 0)
        text_fail("cannot make a pipe: %s", strerror(errno));
    fcntl(out[0], F_SETFD, FD_CLOEXEC);
    start(&drawing, script, out[1], prints);
    close(out[1]);
    const int word = wait_for_byte(out[0], BUILD_MS);
    const bool drawn = word == TRANSPORT_BUILT &&
                       take_figure(out[0], figure, room, length);
    close(out[0]);
    process_stop();
    return word == TRANSPORT_NO_GNUPLOT ? SANDBOX_NO_GNUPLOT
           : word != TRANSPORT_BUILT    ? SANDBOX_NO_PROGRAM
           : drawn                      ? SANDBOX_DRAWN
                                        : SANDBOX_DRAWS_LATE;
}
