/* Hashes memory and registers at each tick of a timer. */
#define _XOPEN_SOURCE 700 /* setitimer, SA_ONSTACK */
#include "examiner/endless.h"
#include "examiner/report.h"

static volatile unsigned long inputs_read;

void endless_forget(void)
{
    ++inputs_read;
}

#if defined __linux__ && defined __x86_64__
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <time.h>
#include <ucontext.h>
#include <unistd.h>

enum {
    FIRST_MS = 200, /* processor time before the first check */
    NEXT_MS = 10,   /* processor time between checks */
    STATES = 1024,
    MEMORY_MOST = 1 << 23 /* bytes; larger states are not checked */
};

/* All memory that the checks themselves write to. It is one struct, which
   the checksum leaves out. */
static struct {
    unsigned char stack[1 << 16];
    char maps[1 << 14];
    uint64_t sum, states[STATES];
    size_t count, bytes;
} scratch;

int __lsan_do_recoverable_leak_check(void) __attribute__((weak));

static void set_timer(int milliseconds)
{
    const struct itimerval timer = {.it_value = {0, 1000 * milliseconds}};
    setitimer(ITIMER_PROF, &timer, NULL);
}

static void add(const void *from, size_t bytes)
{
    const unsigned char *p = from;
    for (; bytes >= sizeof(uint64_t); bytes -= sizeof(uint64_t)) {
        uint64_t word;
        memcpy(&word, p, sizeof word);
        scratch.sum = (scratch.sum ^ word) * 0x9e3779b97f4a7c15u;
        scratch.sum ^= scratch.sum >> 32;
        p += sizeof word;
    }
}

static const char *read_address(const char *text, uintptr_t *address)
{
    static const char digits[] = "0123456789abcdef";
    const char *digit;
    for (*address = 0; *text && (digit = strchr(digits, *text)); ++text)
        *address = *address << 4 | (uintptr_t)(digit - digits);
    return *text ? text + 1 : text;
}

static void add_range(uintptr_t start, uintptr_t end)
{
    if (start < end)
        add((const void *)start, end - start);
}

/* Adds the writable memory in one line of /proc/self/maps to the checksum,
   except `scratch`. Returns false if the memory cannot be read, exceeds
   MEMORY_MOST, or is shared with other processes and can change by itself.
   The process is then never checked again. */
static bool add_piece(const char *line)
{
    const uintptr_t from = (uintptr_t)&scratch, to = from + sizeof scratch;
    uintptr_t start, end;
    line = read_address(read_address(line, &start), &end);
    if (line[1] != 'w')
        return true;
    scratch.bytes += end - start;
    if (line[0] != 'r' || line[3] != 'p' || scratch.bytes > MEMORY_MOST)
        return false;
    add_range(start, end < from ? end : from);
    add_range(start > to ? start : to, end);
    return true;
}

static bool add_memory(void)
{
    const int file = open("/proc/self/maps", O_RDONLY | O_CLOEXEC);
    size_t length = 0;
    ssize_t got = file < 0 ? -1 : 1;
    while (got > 0 && length < sizeof scratch.maps - 1) {
        got = read(file, scratch.maps + length,
                   sizeof scratch.maps - 1 - length);
        length += got > 0 ? (size_t)got : 0;
    }
    if (file >= 0)
        close(file);
    scratch.maps[length] = '\0';
    bool whole = got == 0 && length > 0;
    for (const char *line = scratch.maps; whole && *line;) {
        whole = add_piece(line);
        line = strchr(line, '\n');
        line = line ? line + 1 : "";
    }
    return whole;
}

/* Adds the registers to the checksum. context->uc_mcontext has 23 words and
   the address of the floating-point registers, which take 464 bytes. On
   processors with wider registers, a list of the register sets in use
   follows at LIST, and the rest of the registers at NEW. */
static void add_registers(const ucontext_t *context)
{
    enum { WORDS = 23, OLD = 464, LIST = 512, NEW = 576 };
    enum { MARK = 0x46505853 };
    struct {
        uint64_t words[WORDS];
        const unsigned char *floating;
    } now;
    struct {
        uint32_t mark, all;
        uint64_t may;
        uint32_t bytes;
    } more;
    uint64_t list;
    memcpy(&now, &context->uc_mcontext, sizeof now);
    add(now.words, sizeof now.words);
    if (!now.floating)
        return;
    add(now.floating, OLD);
    memcpy(&more, now.floating + OLD, sizeof more);
    memcpy(&list, now.floating + LIST, sizeof list);
    if (more.mark == MARK && more.bytes > NEW && list > 3)
        add(now.floating + NEW, more.bytes - NEW);
}

static long milliseconds_of(struct timeval t)
{
    return 1000 * (long)t.tv_sec + (long)t.tv_usec / 1000;
}

/* Returns whether the state of the process alone determines what it does
   next. The process must have no other threads, which it might be waiting
   for. It must have spent less than a fifth of its time in the kernel: a
   larger share suggests a loop that polls the system until something
   changes. */
static bool is_alone(void)
{
    enum { ONE_THREAD = 3 }; /* link count of a folder with one subfolder */
    struct rusage used;
    struct stat tasks;
    getrusage(RUSAGE_SELF, &used);
    return stat("/proc/self/task", &tasks) == 0 &&
           tasks.st_nlink == ONE_THREAD &&
           milliseconds_of(used.ru_stime) <
               milliseconds_of(used.ru_utime) / 4;
}

/* Replaces the C library's time(), which makes no system call and returns
   the same number for a whole second: a loop that waits for the next second
   would look endless. This function counts each call as new input. */
time_t time(time_t *when)
{
    struct timespec now = {0, 0};
    clock_gettime(CLOCK_REALTIME, &now);
    endless_forget();
    if (when)
        *when = now.tv_sec;
    return now.tv_sec;
}

/* Handles the timer's signal: stores the checksum of the state, and ends
   the process if an earlier state had the same checksum. The memory
   includes inputs_read, so new input, such as an answer of the judge,
   changes the state. */
static void check_state(int number, siginfo_t *about, void *context)
{
    const int error = errno;
    (void)number, (void)about;
    if (scratch.count == STATES || !is_alone())
        return;
    scratch.sum = scratch.bytes = 0;
    const bool whole = add_memory();
    errno = error;
    if (!whole)
        return;
    add_registers(context);
    for (size_t i = 0; i < scratch.count; ++i)
        if (scratch.states[i] == scratch.sum) {
            signal(REPORT_ENDLESS, SIG_DFL);
            raise(REPORT_ENDLESS);
        }
    scratch.states[scratch.count++] = scratch.sum;
    set_timer(NEXT_MS);
}

void endless_watch(void)
{
    const stack_t stack = {.ss_sp = scratch.stack,
                           .ss_size = sizeof scratch.stack};
    const struct sigaction act = {.sa_sigaction = check_state,
                                  .sa_flags =
                                      SA_SIGINFO | SA_ONSTACK | SA_RESTART};
    if (!__lsan_do_recoverable_leak_check &&
        sigaltstack(&stack, NULL) == 0 &&
        sigaction(SIGPROF, &act, NULL) == 0)
        set_timer(FIRST_MS);
}
#else
void endless_watch(void)
{
}
#endif
