/* Namespaces, limits and a shell inside, made with bubblewrap. */
#include "examiner/box.h"
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
#include <time.h>
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

#define MEMORY_KIB 524288     /* of addresses, for each process */
#define DISK_BYTES "33554432" /* of the box's folder */
#define DISK_FILES "2000"     /* in it */
#define OUTER_WORK "/mnt"     /* where it is mounted, outside the box */

enum {
    BUILD_MS = 45000, /* on the wall, to compile and link */
    START_MS = 5000,  /* from there to main */
    SETTLE_MS = 2000, /* to end a test that is over */
    DRAW_MS = 30000   /* to draw a figure */
};

enum { WORDS = 128, NUMBERS = 8 };

struct words {
    const char *list[WORDS];
    int count;
    char numbers[NUMBERS][24];
    int made;
};

/* Appends arguments to a command line. */
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

/* Returns this number or the next that belongs to no person. */
static long free_user(long user)
{
    while (getpwuid((uid_t)user))
        user += 2;
    return user;
}

/* Returns the user of this process's boxes: an even number; those of judges
   are odd. The kernel counts the processes of a user, wherever they are, so
   that a fork bomb in one box would keep another box of the same user from
   forking. The number is made of this process's own, which nothing else has
   while it lives; so two graders on one machine are kept apart as well.
   Only root can give a box another user; for others Linux counts the
   processes of each user namespace apart since 5.14. */
static long box_user(void)
{
    return free_user(20000 + 2 * ((long)getpid() % 20000));
}

long box_judge(void)
{
    static long user;
    if (!user && geteuid() == 0)
        user = free_user(20001 + 2 * ((long)getpid() % 20000));
    return user;
}

static void add_user(struct words *w)
{
    const char *user = number(w, box_user());
    ADD(w, "setpriv", "--reuid", user, "--regid", user, "--clear-groups",
        "--no-new-privs");
}

static bool bounded; /* also in files; found out by box_probe */
/* What a new process does before it becomes bubblewrap: it changes its
   user, empties its environment, mounts a folder. Each could be a command
   (setpriv, env, unshare, mount) and was; one after the other they took
   longer to start than bubblewrap took for its box. */
static long new_user; /* of the next box; 0 where ours is kept */
static bool new_view; /* and whether it gets users and mounts of its own */
static bool own_disk; /* the folder to write to is mounted before it */

static void give_up(const char *what)
{
    fprintf(stderr, "no box: cannot %s: %s\n", what, strerror(errno));
    fflush(stderr);
    _exit(127);
}

extern char **environ;

/* Empties the environment before bubblewrap starts, and not only within: a
   process can be asked for it in /proc, and bubblewrap is a process in the
   box. A server that grades may keep a platform's keys there. */
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
#endif
    if (setgid((gid_t)new_user) != 0 || setuid((uid_t)new_user) != 0)
        give_up("become another user");
#ifdef __linux__
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
#endif
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

/* Enters namespaces of users and mounts in which this process is root over
   its own view alone. A machine may allow that to bubblewrap only; then the
   bytes of the folder are bounded and its files are not. */
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

/* Mounts the writable folder with a limit on its bytes and on its number
   of files, because a million empty files fill the memory as well.
   bubblewrap can limit only the bytes. */
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

static void plan_entry(enum box_kind kind)
{
    new_user = geteuid() == 0 && kind != BOX_ROOT ? box_user() : 0;
    own_disk = bounded && kind != BOX_OPEN;
    new_view = kind != BOX_ROOT;
}

/* Puts the compiler, its libraries and one folder to write to into the box.
   /dev is a file system in memory, too, and without a limit; so it and the
   root are made read-only when all is in place. Without that a program can
   write a file of any size to /, and /etc is its own. */
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

/* Copies the files of the order into the box out of descriptors: its user
   needs no right to enter our folders, and there is no path by which to
   find them. */
static void add_copies(struct words *w, const struct box_order *order)
{
    static char source[256], header[80];
    snprintf(source, sizeof source, "/%s", order->name);
    snprintf(header, sizeof header, "/%s", order->included);
    ADD(w, "--perms", "0444", "--ro-bind-data", "5", source);
    ADD(w, "--perms", "0444", "--ro-bind-data", "6", header);
    ADD(w, "--perms", "0444", "--ro-bind-data", "7", "/kit/box.suite.o");
    ADD(w, "--seccomp", "8", "--remount-ro", "/");
}

/* Starts bubblewrap in namespaces of its own. In a new session it has no
   terminal, into which a program could otherwise type (TIOCSTI). No
   capability of root's is left, and the box dies when we die. */
static void add_namespaces(struct words *w, enum box_kind kind)
{
    ADD(w, "bwrap", "--unshare-ipc", "--unshare-pid", "--unshare-net",
        "--unshare-uts", "--unshare-cgroup-try", "--die-with-parent",
        "--new-session", "--clearenv", "--cap-drop", "ALL");
    if (kind == BOX_ROOT)
        ADD(w, "--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID",
            "--cap-add", "CAP_SETPCAP");
    else
        ADD(w, "--unshare-user");
    if (kind == BOX_SEALED)
        ADD(w, "--disable-userns");
    if (geteuid() != 0 || (bounded && kind != BOX_ROOT))
        ADD(w, "--uid", "65534", "--gid", "65534");
}

static void add_walls(struct words *w, enum box_kind kind,
                      const struct box_order *order)
{
    plan_entry(kind);
    add_namespaces(w, kind);
    add_system(w);
    add_copies(w, order);
    if (kind == BOX_ROOT) {
        add_user(w);
        ADD(w, "--inh-caps=-all", "--bounding-set=-all");
    }
}

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))
/* Calls that are refused with EPERM. A limit of addresses does not count
   memory that belongs to no process (System V's shared memory,
   memfd_create), with which a few lines could take all there is. The others
   serve to attack the kernel and not to compute; only sanitizers trace, to
   look for lost memory. */
static const int forbidden[] = {
    SYS_ptrace, /* must be the first: it is skipped for sanitizers */
    SYS_shmget,      SYS_memfd_create,    SYS_unshare,
    SYS_setns,       SYS_add_key,         SYS_process_vm_writev,
    SYS_keyctl,      SYS_request_key,     SYS_bpf,
    SYS_userfaultfd, SYS_perf_event_open, SYS_io_uring_setup};

enum { FORBIDDEN = sizeof forbidden / sizeof forbidden[0] };
#ifdef __x86_64__
enum { LAST_CALL = 0x3fffffff }; /* above begin the calls of x32 */
static const unsigned OUR_CALLS = AUDIT_ARCH_X86_64;
#else
enum { LAST_CALL = 0x7fffffff };
static const unsigned OUR_CALLS = AUDIT_ARCH_AARCH64;
#endif

#define DO(c, value) code[n++] = (struct sock_filter)BPF_STMT(c, value)
#define SKIP(c, value, yes, no)                                            \
    code[n++] =                                                            \
        (struct sock_filter)BPF_JUMP(BPF_JMP | c | BPF_K, value, yes, no)

/* Returns a pipe with the filter: a program for a machine with one
   register, which loads the call's number and compares it. An x86 processor
   has three sets of numbers; a call from one that is not ours ends the
   program. On other processors the filter is empty. */
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

static bool try_kind(enum box_kind kind, const char *compiler)
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
    const struct box_order none = {.name = "exercises/none.c",
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

static bool try_disks(enum box_kind kind)
{
    bounded = true;
    if (!try_kind(kind, ":"))
        bounded = false;
    return bounded || try_kind(kind, ":");
}

/* Tries to put up walls around a command that does nothing, and then the
   compiler in the best of them: if it were not there, no student's program
   would build, and only the marks would look wrong. */
enum box_kind box_probe(const char *compiler)
{
    enum box_kind kind = BOX_SEALED;
    while (kind != BOX_OPEN &&
           ((kind == BOX_ROOT && geteuid() != 0) || !try_disks(kind)))
        ++kind;
    if (kind != BOX_OPEN && !try_kind(kind, compiler))
        text_fail("no student's file can be compiled: '%s' or objcopy is "
                  "not in the box, which has no more than /usr",
                  compiler);
    return kind;
}

const char *box_name(enum box_kind kind)
{
    static const char *const names[] = {"sealed namespaces", "namespaces",
                                        "root's namespaces",
                                        "NONE: limits only, no isolation"};
    return names[kind];
}

/* What the shell in the box does: it compiles, hides the names of the
   student's file, links, and becomes the program.

   objcopy makes all of his symbols local but those of the exercise, so that
   his malloc, write or main are names within his own file and the driver's
   calls do not reach them. It also takes out .interp, which a file can
   bring along and which Linux would start in gold's programs. A project
   keeps main: its driver becomes a program without anything of his, and his
   own is linked once for each function that it is given, under sanitizers
   with the first alone.

   Limits are hard ones; the compiler and the program have different ones.
   The kernel is told to end this first if the machine runs out of memory.
   The pipes are closed while the compiler runs, so that a file that
   includes /proc/self/fd/3 includes nothing. gcc took 28 s to draw twenty
   thousand warnings with their lines; so what it says is kept aside without
   lines, and only if it refuses is it asked again, with lines, and without
   warnings if that was much.

   What nobody reads is not made: names and lines are for the sanitizers and
   for a linker that refuses; then all is made once more with them. gold
   needs a third of the usual linker's time with sanitizers and three
   quarters without; started without the compiler's driver, with the words
   that it had from there, it takes 4 ms in place of 12, of 90 for a file
   that is built. */
static const char script[] =
    "root=$1 name=$2 compiler=$3 keep=$4 seconds=$5 memory=$6 terse=$7\n"
    "lean=$8 linker=$9 declared=${10} types= cpu=20\n"
    "echo 1000 >/proc/self/oom_score_adj\n"
    "export PATH=/usr/bin:/bin LC_ALL=C HOME=$root/work TMPDIR=$root/work\n"
    "common=exitcode=86:color=never\n"
    "export UBSAN_OPTIONS=$common ASAN_OPTIONS=$common:handle_abort=1:"
    "hard_rss_limit_mb=512:leak_check_at_exit=0\n"
    "processes() { ulimit -p $1 2>/dev/null || ulimit -u $1; }\n"
    "ulimit -c 0 && ulimit -f 65536 && processes 64 || exit\n"
    "build() ( ulimit -t $cpu && ulimit -v 2097152 &&\n"
    "    exec \"$@\" 3<&- 4>&- )\n"
    "compile() { build $compiler -I$root/kit -DEXAMINER_GIVES \\\n"
    "    $types \"$@\" -c -o work/answer.o $name; }\n"
    "cd $root/ || exit\n"
    "[ ! \"$declared\" ] || { types='-include work/types.h'\n"
    "    printf '%s\\n' \"$declared\" >work/types.h; }\n"
    "compile $lean $terse >work/said 2>&1 || { cpu=5\n"
    "    if [ $(wc -c <work/said) -lt 9999 ]; then compile; else\n"
    "    compile -w && grep error: work/said | head -n 20; fi; exit; }\n"
    "cd work || exit\n"
    "kit=../kit/box.suite.o program=./program of=\n"
    "bound() {\n"
    "    ulimit -S -t $seconds && ulimit -H -t $((seconds + 1)) &&\n"
    "    ulimit -n 64 && ulimit -f $1 && processes 16 &&\n"
    "    { [ $memory = unlimited ] || ulimit -v $memory; }; }\n"
    "link() { build objcopy -R .interp $keep answer.o && build \"$@\"; }\n"
    "by_compiler=\"$compiler -o program answer.o $kit -lm\"\n"
    "case $keep in figure | program)\n"
    "    of=$(nm $kit | sed -n 's/.* T \\([a-z]*\\)_0$/\\1/p') ;; esac\n"
    "given() { [ ! \"$of\" ] ||\n"
    "    echo -Wl,-u,${of}_$1,--defsym=$of=${of}_$1; }\n"
    "if [ \"$keep\" = figure ]; then\n"
    "    project=${name#*/} && project=${project%%-*} && mkdir desk &&\n"
    "        build objcopy --keep-global-symbol=main answer.o &&\n"
    "        build $compiler -o desk/$project answer.o $kit -lm \\\n"
    "            $(given 0) || exit\n"
    "    cd desk && cat <&3 >$project.gp || exit\n"
    "    command -v gnuplot >/dev/null || { printf g >&4; exit; }\n"
    "    printf b >&4\n"
    "    (bound 31250 && exec gnuplot $project.gp </dev/null 3<&- 4>&-)\n"
    "    [ ! -L $project.png ] && [ -f $project.png ] &&\n"
    "        head -c 4194305 $project.png >&4\n"
    "    exit\n"
    "fi\n"
    "if [ \"$keep\" = program ]; then\n"
    "    build objcopy --keep-global-symbol=main answer.o || exit\n"
    "    laws=0 && [ ! \"$of\" ] ||\n"
    "        laws=$(nm $kit | sed -n \"s/.* T ${of}_//p\")\n"
    "    for law in $laws; do\n"
    "        [ $memory = unlimited ] && ln program0 program$law \\\n"
    "            2>/dev/null && continue\n"
    "        build $compiler -o program$law answer.o $kit -lm \\\n"
    "            $(given $law) || exit\n"
    "    done\n"
    "    build $compiler -o box $kit -lm "
    "-Wl,-u,box_main,--defsym=main=box_main \\\n"
    "        || exit\n"
    "    mkdir desk && cd desk && program=../box || exit\n"
    "else\n"
    "    set -- $linker\n"
    "    [ $# -gt 0 ] || set -- $by_compiler\n"
    "    link \"$@\" >said 2>&1 ||\n"
    "        { cd .. && compile $terse >work/said 2>&1 && cd work &&\n"
    "            link $by_compiler; } ||\n"
    "        exit\n"
    "fi\n"
    "printf b >&4\n"
    "bound 2048 && exec $program\n";
static void add_script(struct words *w, const struct box_order *order,
                       const char *root)
{
    const char *memory =
        order->sanitized ? "unlimited" : number(w, MEMORY_KIB);
    ADD(w, "/bin/sh", "-c", script, "sh", root, order->name,
        order->compiler, order->keep, number(w, order->seconds), memory,
        order->terse, order->lean, order->linker, order->types);
}

enum { GONE = -1, LATE = -2, NAP_MS = 50 };

static int wait_for_byte(int file, int milliseconds)
{
    struct pollfd wait = {.fd = file, .events = POLLIN};
    unsigned char byte;
    int ready, left = milliseconds;
    do {
        if (process_signal()) /* perhaps before we began to wait */
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

/* Makes a folder in place of a box. As root we still give it to a user of
   its own, or the program could do to us what it likes. */
static void furnish_folder(const struct box_order *order)
{
    static const char *const folders[] = {"kit", "exercises", "work"};
    char path[512];
    strcpy(open_root, "/tmp/bonkers.XXXXXX");
    if (!mkdtemp(open_root) ||
        (geteuid() == 0 && (chown(open_root, 0, (gid_t)box_user()) != 0 ||
                            chmod(open_root, 0750) != 0)))
        text_fail("cannot make a folder in /tmp: %s", strerror(errno));
    furnished = true;
    for (int i = 0; i < 3; ++i) {
        snprintf(path, sizeof path, "%s/%s", open_root, folders[i]);
        if (mkdir(path, 0755) != 0)
            text_fail("cannot make '%s': %s", path, strerror(errno));
    }
    if (geteuid() == 0 &&
        chown(path, (uid_t)box_user(), (gid_t)box_user()) != 0)
        text_fail("cannot give '%s' away: %s", path, strerror(errno));
    copy(order->source, order->name);
    copy(order->header, order->included);
    copy(order->inside, "kit/box.suite.o");
}

static void start(const struct box_order *order, int requests, int answers,
                  int prints)
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
    if (order->kind != BOX_OPEN) {
        add_walls(&w, order->kind, order);
        add_script(&w, order, "");
    } else {
        furnish_folder(order);
        plan_entry(BOX_OPEN);
        add_script(&w, order, open_root);
    }
    lseek(order->source, 0, SEEK_SET);
    lseek(order->header, 0, SEEK_SET);
    lseek(order->inside, 0, SEEK_SET);
    if (!process_start((char *const *)w.list, "/", &files, &limits))
        text_fail("cannot start '%s': %s", w.list[0], strerror(errno));
    close(filter);
}

/* Waits until the program has come to its main. Two bytes tell how far it
   is, one from the shell and one from the driver; a program that sends the
   second before its main has gained nothing. */
static enum box_stage wait_for_main(struct box *box, int seconds)
{
    const double start = process_clock();
    const int built = wait_for_byte(box->answers, BUILD_MS);
    box->build_seconds = process_clock() - start;
    if (built != TRANSPORT_BUILT)
        return built == LATE ? BOX_TOO_LONG : BOX_NOT_BUILT;
    const int started = wait_for_byte(box->answers, START_MS);
    if (started == TRANSPORT_READY)
        return BOX_READY;
    const double waited = process_clock() - start - box->build_seconds;
    return started == LATE || waited >= 0.8 * seconds ? BOX_STUCK
                                                      : BOX_NO_MAIN;
}

/* Starts a box and waits until its program is ready or has failed. The
   box's ends of the pipes are closed here, or we should never see that it
   is gone. */
enum box_stage box_open(struct box *box, const struct box_order *order,
                        int prints)
{
    int in[2], out[2];
    if (pipe(in) != 0 || pipe(out) != 0)
        text_fail("cannot make a pipe: %s", strerror(errno));
    *box = (struct box){in[1], out[0], prints, 0.0, 0};
    fcntl(box->requests, F_SETFD, FD_CLOEXEC);
    fcntl(box->answers, F_SETFD, FD_CLOEXEC);
    start(order, in[0], out[1], prints);
    close(in[0]);
    close(out[1]);
    return wait_for_main(box, order->seconds);
}

/* Sends a byte if there is room: a pipe that the program has filled takes
   none. */
static bool send_byte(int file, char byte)
{
    struct pollfd room = {.fd = file, .events = POLLOUT};
    return poll(&room, 1, SETTLE_MS) == 1 && (room.revents & POLLOUT) &&
           write(file, &byte, 1) == 1;
}

/* Ends the test's process. The student may have put himself in the driver's
   place, so no step waits without an end. */
static bool see_gone(struct box *box)
{
    unsigned char how[TRANSPORT_HOW * sizeof(int)];
    if (!send_byte(box->requests, TRANSPORT_OVER))
        return false;
    const int word = wait_for_byte(box->answers, SETTLE_MS);
    bool whole = word == TRANSPORT_OVER || word == TRANSPORT_ENDED;
    for (size_t i = 0; word == TRANSPORT_ENDED && whole && i < sizeof how;
         ++i) {
        const int byte = wait_for_byte(box->answers, SETTLE_MS);
        whole = byte >= 0;
        how[i] = (unsigned char)byte;
    }
    if (word == TRANSPORT_ENDED && whole)
        memcpy(&box->test_ms, how + sizeof(int), sizeof(int));
    return whole;
}

/* Returns whether the box is fit for the next test. A program that never
   stops writing could pass see_gone, because nine of its bytes look like a
   status; and an empty pipe does not prove that it is silent: of 400 such
   programs 8 had just lost the processor. So the driver is asked a second
   question, to which the only answer is the question itself; a program that
   has answered ahead of time has answered something else. */
bool box_settle(struct box *box)
{
    box->test_ms = 0;
    return see_gone(box) && send_byte(box->requests, TRANSPORT_ECHO) &&
           wait_for_byte(box->answers, SETTLE_MS) == TRANSPORT_ECHO &&
           wait_for_byte(box->answers, 0) == LATE;
}

/* Kills what is left of a box without walls and removes its folder. kill
   with -1 sent by root would reach everybody, sent by the box's user only
   what is its own. */
static void sweep_folder(void)
{
    char command[256];
    snprintf(command, sizeof command,
             "setpriv --reuid %ld --regid %ld --clear-groups "
             "sh -c 'kill -KILL -1' 2>/dev/null",
             box_user(), box_user());
    if (geteuid() == 0 && system(command) < 0)
        text_fail("cannot sweep '%s'", open_root);
    if (!folder_remove(open_root))
        text_fail("cannot remove '%s': %s", open_root, strerror(errno));
    furnished = false;
}

/* Ends the box: killing bubblewrap ends the first process of the box's own
   list, and then the kernel kills all others on it. */
void box_close(struct box *box)
{
    close(box->requests);
    close(box->answers);
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

/* Draws a project's figure. A gnuplot script can call the shell, and
   should, for it gets its tables from the student's own program; so it runs
   in a box with that program in it. A picture of four megabytes at most is
   all that leaves it. */
enum box_drawing box_draw(const struct box_order *order, int script,
                          int prints, char *figure, size_t room,
                          size_t *length)
{
    int out[2];
    struct box_order drawing = *order;
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
    return word == TRANSPORT_NO_GNUPLOT ? BOX_NO_GNUPLOT
           : word != TRANSPORT_BUILT    ? BOX_NO_PROGRAM
           : drawn                      ? BOX_DRAWN
                                        : BOX_DRAWS_LATE;
}
