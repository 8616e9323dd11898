/* Runs a test, judges how it ended, and explains failures and crashes. */
#include "examiner/trial.h"
#include "examiner/process.h"
#include "examiner/report.h"
#include "examiner/text.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* Students read these words, and the kit's tests look for them. None of the
   words is "error" or "fatal". */
const char *state_name(enum state state)
{
    static const char *const names[] = {"not begun", "does not build",
                                        "failed",    "crashed",
                                        "timed out", "passed"};
    return names[state];
}

/* An exercise that is not begun is not wrong, so that a fresh copy of the
   kit shows no red. */
bool state_wrong(enum state state)
{
    return state != NOT_BEGUN && state != PASSED;
}

/* The limits of a test. Its memory is limited to 512 MiB, which every
   machine has and no exercise needs. Each file that it writes is limited to
   1 MiB, since an endless loop that prints would fill a disk within a
   minute. By default it may compute for five seconds: hundreds of times
   longer than needed, even with sanitizers, and about as long as people
   look at a silent terminal. */
enum { MIB = 1 << 20, MEMORY_MIB = 512, SANITIZER_STATUS = 86 };

struct result {
    struct process_end end;
    char nonce[REPORT_NONCE + 1];
    char *report;
    char *output;
    char *error; /* report of the sanitizers, or NULL */
};

/* Draws a nonce: 16 random bytes from the kernel, which no program prints
   by accident. */
static void draw_nonce(char nonce[REPORT_NONCE + 1])
{
    unsigned char bytes[REPORT_NONCE / 2];
    FILE *random = fopen("/dev/urandom", "r");
    if (!random || fread(bytes, sizeof bytes, 1, random) != 1)
        text_fail("cannot read /dev/urandom: %s", strerror(errno));
    fclose(random);
    for (size_t i = 0; i < sizeof bytes; ++i)
        snprintf(nonce + 2 * i, 3, "%02x", bytes[i]);
}

/* Creates a file, which must not exist (O_EXCL). O_APPEND sends all writes
   to its end; otherwise a program that closes one descriptor too many and
   opens a file instead could write over the verdict. */
static int open_fresh(const char *path)
{
    unlink(path);
    const int file = open(path, O_RDWR | O_CREAT | O_EXCL | O_APPEND, 0600);
    if (file < 0)
        text_fail("cannot write '%s': %s", path, strerror(errno));
    return file;
}

static void drop_words(char *text, const char *words)
{
    const size_t length = strlen(words);
    while ((text = strstr(text, words)))
        memmove(text, text + length, strlen(text + length) + 1);
}

/* Cuts the sanitizers' report off the output. Returns the report, or NULL
   if there is none. (With some compilers the sanitizer for undefined
   behaviour always writes to standard error, never to a file.) The report
   begins with a line that names a sanitizer or says "runtime error"; a line
   of equals signs may come before it. Called only if the status is a
   sanitizer's; otherwise a program that prints these words would lose
   output. */
static char *cut_error(char *output)
{
    char *error = strstr(output, "AddressSanitizer:");
    char *undefined = strstr(output, ": runtime error: ");
    if (!error || (undefined && undefined < error))
        error = undefined;
    if (!error)
        return NULL;
    while (error > output && error[-1] != '\n')
        --error;
    char *copy = strdup(error);
    while (error > output && strchr("=\n", error[-1]))
        --error;
    *error = '\0';
    return copy;
}

/* Finds the next line of the report, after `from`, that begins with the
   nonce and `word`. Copies the rest of the line to `text` and returns its
   place in the report, or NULL if there is no such line. */
static const char *find_line(const char *from, const struct result *result,
                             const char *word, char text[REPORT_LINE])
{
    char key[REPORT_NONCE + 16];
    snprintf(key, sizeof key, "\n%s %s ", result->nonce, word);
    const char *found = strstr(from, key);
    if (!found)
        return NULL;
    found += strlen(key);
    snprintf(text, REPORT_LINE, "%.*s", (int)strcspn(found, "\n"), found);
    return found;
}

static struct {
    int report, output, orders; /* the runner's descriptors, or 0 */
} served;

/* Starts a runner for one test and waits for its end. If `end` is NULL,
   starts a runner that waits for orders instead, and returns at once. The
   runner works in the empty folder `desk`, so that a student's file called
   output cannot replace ours, and temporary files are removed with the
   folder.

   The environment contains options for the sanitizers: they exit with a
   special status, catch abort, and search for leaks only on request. The
   address sanitizer maps about fourteen terabytes at its start, so a limit
   on the address space would end it before main. Instead, a thread of the
   sanitizer watches the memory in use. A forked copy has no such thread, so
   process_copy watches its memory. The address space of a judge is limited,
   because a judge runs without sanitizers, even if the program in its
   sandbox has them. */
static bool start_runner(const struct trial *trial, const char *test,
                         const struct process_files *files,
                         struct process_end *end)
{
    char desk[4096];
    snprintf(desk, sizeof desk, "%s/desk", trial->folder);
    if (mkdir(desk, 0700) != 0 && errno != EEXIST)
        text_fail("cannot make '%s': %s", desk, strerror(errno));
    setenv("TMPDIR", ".", 1);
    char user[24];
    snprintf(user, sizeof user, "%ld", trial->user);
    char *command[] = {(char *)trial->runner, (char *)test,
                       trial->seed ? (char *)trial->seed : "0",
                       trial->sandbox[0] ? user : NULL, NULL};
    const struct process_limits limits = {
        .seconds = trial->seconds,
        .memory_bytes = trial->sanitized && !trial->sandbox[0]
                            ? RLIM_INFINITY
                            : (rlim_t)MEMORY_MIB * MIB,
        .file_bytes = MIB,
        .processes = RLIM_INFINITY};
    char options[256];
    snprintf(options, sizeof options,
             "exitcode=%d:hard_rss_limit_mb=%d:handle_abort=1:"
             "detect_leaks=%d:leak_check_at_exit=0:allow_addr2line=1:"
             "color=never",
             SANITIZER_STATUS, end ? MEMORY_MIB : 0, !end || trial->leaks);
    setenv("ASAN_OPTIONS", options, 1);
    setenv("UBSAN_OPTIONS", options, 1);
    return end ? process_run(command, desk, files, &limits, end)
               : process_start(command, desk, files, &limits);
}

/* Starts a runner that waits for orders and forks a copy of itself for each
   test. A socket carries the orders and the process IDs of the copies; the
   runner ends when our end of the socket is closed. Only Linux can make
   such copies. In the grader this runner is the judge, which gets the pipes
   to its sandbox when it starts. */
void trial_open(const struct trial *trial)
{
#ifdef __linux__
    char report[4096], output[4096];
    int ends[2];
    if (served.orders > 0 || socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0)
        return;
    snprintf(report, sizeof report, "%s/report", trial->folder);
    snprintf(output, sizeof output, "%s/output", trial->folder);
    served.report = open_fresh(report);
    served.output = open_fresh(output);
    served.orders = ends[0];
    const struct process_files files = {.output = served.output,
                                        .kept = {served.report, ends[1],
                                                 trial->sandbox[0],
                                                 trial->sandbox[1]}};
    if (!start_runner(trial, "-", &files, NULL))
        trial_close();
    close(ends[1]);
#else
    (void)trial;
#endif
}

void trial_close(void)
{
    if (served.orders <= 0)
        return;
    close(served.orders);
    process_stop();
    close(served.report);
    close(served.output);
    served.orders = 0;
}

/* Runs one test. If the waiting runner has died, for example because its
   own copy killed it, kills every process that it left and runs the test
   with a new runner and a new report. Reads the report and the output only
   when no process is left that could write to them.

   In the grader, the program in the sandbox writes its output to the file
   `prints`. If the program ran as our user, it may have removed our
   permission to read that file; chmod restores it. */
static void run_runner(const struct trial *trial, int number,
                       struct result *result)
{
    char report[4096], output[4096];
    snprintf(report, sizeof report, "%s/report", trial->folder);
    snprintf(output, sizeof output, "%s/output", trial->folder);
    const bool copies = served.orders > 0;
    const int report_file = copies ? served.report : open_fresh(report);
    const int output_file = copies ? served.output : open_fresh(output);
    draw_nonce(result->nonce);
    if (ftruncate(report_file, 0) != 0 || ftruncate(output_file, 0) != 0 ||
        write(report_file, result->nonce, REPORT_NONCE) != REPORT_NONCE)
        text_fail("cannot write '%s': %s", report, strerror(errno));
    const struct report_order order = {
        trial->seed ? strtoull(trial->seed, NULL, 10) : 0, number,
        trial->leaks};
    if (copies &&
        !process_copy(served.orders, &order, sizeof order, trial->seconds,
                      trial->sandbox[0] ? RLIM_INFINITY
                                        : (rlim_t)MEMORY_MIB * MIB,
                      &result->end)) {
        trial_close();
        run_runner(trial, number, result);
        return;
    }
    if (!copies) {
        char test[16];
        snprintf(test, sizeof test, "%d", number);
        const struct process_files files = {
            .output = output_file,
            .kept = {report_file, output_file, trial->sandbox[0],
                     trial->sandbox[1]}};
        if (!start_runner(trial, test, &files, &result->end))
            text_fail("cannot start '%s': %s", trial->runner,
                      strerror(errno));
        close(report_file);
        close(output_file);
    }
    result->report = text_read(report);
    result->output = text_read(output);
    if (!result->report || !result->output)
        text_fail("cannot read '%s': %s", trial->folder, strerror(errno));
    if (trial->prints) {
        free(result->output);
        chmod(trial->prints, 0600);
        result->output = text_read(trial->prints);
    }
    if (!result->output)
        text_fail("cannot read '%s': %s", trial->folder, strerror(errno));
    drop_words(result->output, "AddressSanitizer:DEADLYSIGNAL\n");
    if (WIFEXITED(result->end.status) &&
        WEXITSTATUS(result->end.status) == SANITIZER_STATUS)
        result->error = cut_error(result->output);
}

static bool is_endless(const struct trial *trial,
                       const struct process_end *end)
{
    return trial->sandbox[0] && WIFSIGNALED(end->status) &&
           WTERMSIG(end->status) == REPORT_ENDLESS;
}

static const char round_and_round[] =
    "This test was stopped, for it would never have ended: your program "
    "had come back to where it was before, with the same values in all its "
    "variables. Which loop was it in, and what was to end it?";

/* Reports a time-out. Asks a question that may help the student, since only
   a debugger could tell where the program was. */
static void tell_time_out(const struct trial *trial,
                          const struct process_end *end, FILE *story)
{
    char text[320], later[64] = "";
    if (is_endless(trial, end)) {
        text_field(story, "what", round_and_round);
        return;
    }
    if (trial->later > 0)
        snprintf(later, sizeof later,
                 " (once one was, after %d s of computing)", trial->later);
    snprintf(text, sizeof text,
             "This test was stopped after %d s of computing or %d s of "
             "waiting%s. Is there a loop that never ends, or one whose "
             "condition never turns false?",
             trial->seconds, 2 * trial->seconds, later);
    text_field(story, "what", text);
}

/* Explanations of how a process ended, found by a sanitizer's word or by a
   signal. Some are only likely: SIGSEGV is nearly always caused by a wrong
   pointer or index, and a SIGKILL that is not ours by a lack of memory. */
static const struct {
    const char *word;
    int signal;
    const char *meaning;
} endings[] = {
    {"SEGV", SIGSEGV,
     "SIGSEGV: it used a pointer or an index that leads nowhere, or called "
     "itself without end."},
    {"BUS", SIGBUS, "SIGBUS: it used a pointer that leads nowhere."},
    {"FPE", SIGFPE, "SIGFPE: a whole number was divided by zero."},
    {"ILL", SIGILL, "SIGILL: it did what C leaves undefined."},
    {"ABRT", SIGABRT,
     "SIGABRT: it called abort; a false assertion does, too."},
    {"hard rss limit", SIGKILL,
     "It used more memory than it may have, 512 MiB, or than there was."},
    {"", SIGXFSZ,
     "SIGXFSZ: it printed or wrote more than 1 MiB. Is there a loop that "
     "prints without end?"},
    {"heap-buffer-overflow", 0,
     "it went past the end of memory that malloc gave"},
    {"stack-buffer-overflow", 0, "it went past the end of an array"},
    {"stack-buffer-underflow", 0, "it went before the start of an array"},
    {"global-buffer-overflow", 0, "it went past the end of an array"},
    {"use-after-poison", 0,
     "it went before the start or past the end of what it was given"},
    {"heap-use-after-free", 0, "it used memory after free"},
    {"attempting double-free", 0, "it freed the same memory twice"},
    {"attempting free", 0, "it freed what malloc had not given"},
    {"stack-overflow", 0,
     "the stack is full; does a function call itself without end?"},
    {"requested allocation size", 0,
     "it asked for more memory than there is"},
    {"out of memory", 0, "it asked for more memory than there is"}};

static const char *meaning(const char *word, int signal)
{
    for (size_t i = 0; i < sizeof endings / sizeof *endings; ++i)
        if (word ? *endings[i].word && text_after(word, endings[i].word)
                 : endings[i].signal == signal)
            return endings[i].meaning;
    return NULL;
}

/* Explains a sanitizer's report in a sentence. Quotes the report if it is
   about undefined behaviour, or if the table lacks the error, as with a
   newer compiler. */
static void error_text(const char *report, char *text, size_t room)
{
    const char *undefined = strstr(report, "runtime error: ");
    const char *address = strstr(report, "Sanitizer: ");
    const char *word = report, *known = NULL;
    if (undefined)
        word = undefined + strlen("runtime error: ");
    else if (address)
        known = meaning(word = address + strlen("Sanitizer: "), 0);
    const int length = (int)strcspn(word, "\n");
    snprintf(text, room, "%.*s", known ? (int)room : length,
             known ? known : word);
}

/* Explains a crash in a sentence. Checks first for a sanitizer's report,
   because a sanitizer also ends the program with a status. */
static void crash_text(const struct result *result, char *text, size_t room)
{
    const int status = result->end.status;
    if (result->error) {
        error_text(result->error, text, room);
    } else if (WIFSIGNALED(status)) {
        const char *known = meaning(NULL, WTERMSIG(status));
        snprintf(text, room, "It was ended by signal %d.",
                 WTERMSIG(status));
        if (known)
            snprintf(text, room, "%s", known);
    } else {
        snprintf(text, room,
                 "The program ended, with status %d, before the test had "
                 "said how it went. Does your file call exit, or close "
                 "what it has not opened?",
                 WEXITSTATUS(status));
    }
}

/* Shows the line of the student's file that was running. The report lists
   the calls, the innermost first. So the line is in the first call that
   mentions the student's file, even if the error is in a library function.
   Paths in the report may be absolute, so only their ends are compared. The
   function's name comes before the path, after " in ". */
static void tell_place(const char *report, const char *source, FILE *story)
{
    char name[4096], text[4600], function[128] = "";
    snprintf(name, sizeof name, "%s:", source);
    const char *place = strstr(report, name);
    if (!place)
        return;
    const int number = atoi(place + strlen(name));
    const char *line = place;
    while (line > report && line[-1] != '\n')
        --line;
    const char *in = strstr(line, " in ");
    if (in && in < place)
        snprintf(function, sizeof function, "%.*s",
                 (int)strcspn(in + 4, " ("), in + 4);
    snprintf(text, sizeof text, "%s%d%s%s", name, number,
             *function ? ", in the function " : "", function);
    text_field(story, "where", text);
    text_quote_line(story, source, number);
}

static const char nowhere[] =
    "Only a compiler with sanitizers could tell the line. Let your "
    "function print something, with \\n at the end, at several places: "
    "what was printed last was reached.";

static void tell_crash(const struct trial *trial,
                       const struct result *result, FILE *story)
{
    char text[REPORT_LINE];
    crash_text(result, text, sizeof text);
    text_field(story, "what", text);
    if (result->error)
        tell_place(result->error, trial->source, story);
    else if (WIFSIGNALED(result->end.status) && !trial->sanitized &&
             !trial->prints)
        text_field(story, "where", nowhere);
}

bool trial_leak(const char *prints, const char *source, FILE *story)
{
    char *text = text_read(prints);
    const char *report =
        text ? strstr(text, "LeakSanitizer: detected") : NULL;
    const bool own = report && strstr(report, source);
    if (own) {
        text_field(story, "what",
                   "it took memory, and lost it without free");
        tell_place(report, source, story);
    }
    free(text);
    return own;
}

/* Returns "equation (NUMBER)", with the number of the equation in the book.
   A suite knows only the equation's label, since numbers change when an
   equation is added. If the table lacks the label, because the chapter is
   still being written, returns "the equation LABEL". */
static const char *equation_in_book(const char *label,
                                    char text[REPORT_LINE])
{
    char *table = text_read("tests/equations.txt");
    char *rest = table;
    char name[128], number[32];
    snprintf(text, REPORT_LINE, "the equation %s", label);
    for (char *line; (line = text_line(&rest));)
        if (sscanf(line, "%127s %31s", name, number) == 2 &&
            strcmp(name, label) == 0)
            snprintf(text, REPORT_LINE, "equation (%s)", number);
    free(table);
    return text;
}

/* Writes the report of a failed test: the quantity, the input, the expected
   and the actual answer, the tolerance and its reason, the equation, and a
   question. The report never says what to type. */
static void tell_failure(const struct result *result, FILE *story)
{
    char text[REPORT_LINE], book[REPORT_LINE];
    const char *place = result->report;
    while ((place = find_line(place, result, REPORT_SAYS, text))) {
        const size_t length = strcspn(text, " ");
        const char *what = text + length + strspn(text + length, " ");
        text[length] = '\0';
        if (strcmp(text, "book") == 0)
            what = equation_in_book(what, book);
        text_field(story, text, what);
    }
}

static bool waited, mistaken;

bool trial_waited(void)
{
    return waited;
}

bool trial_mistake(void)
{
    return mistaken;
}

static bool is_mistake(const char *report)
{
    return report && !strstr(report, "hard rss limit") &&
           !strstr(report, "requested allocation size") &&
           !strstr(report, "out of memory") &&
           !strstr(report, "failed to allocate");
}

/* Judges a test. The order of the conditions matters. A program that was
   stopped has timed out, whatever it reported. A program that ended by a
   signal or with a nonzero status, such as a sanitizer's, has crashed. A
   program without a verdict under its nonce has crashed, too: it called
   exit or closed the report. NOT_DONE_YET is checked before the verdict,
   since a program that forked may report both. "Passed" comes last;
   otherwise a program that overruns its stack after the verdict would
   pass. */
enum state trial_run(const struct trial *trial, int number, FILE *story)
{
    struct result result = {0};
    run_runner(trial, number, &result);
    waited = result.end.waited;
    mistaken = is_mistake(result.error);
    enum state state;
    char verdict[REPORT_LINE] = "", undone[REPORT_LINE] = "";
    find_line(result.report, &result, REPORT_VERDICT, verdict);
    find_line(result.report, &result, REPORT_UNDONE, undone);
    if (result.end.timed_out || is_endless(trial, &result.end)) {
        state = TIMED_OUT;
        tell_time_out(trial, &result.end, story);
        tell_failure(&result, story);
    } else if (result.end.status != 0 || (!*verdict && !*undone)) {
        state = CRASHED;
        tell_crash(trial, &result, story);
        tell_failure(&result, story);
    } else if (*undone) {
        state = NOT_BEGUN;
        fprintf(story, "  NOT_DONE_YET still stands at %s\n", undone);
    } else if (strcmp(verdict, "passed") != 0) {
        state = FAILED;
        tell_failure(&result, story);
    } else {
        state = PASSED;
    }
    if (state_wrong(state) && *result.output) {
        fprintf(story, "  Your program printed:\n");
        text_quote(story, result.output, 12);
    }
    free(result.report);
    free(result.output);
    free(result.error);
    return state;
}
