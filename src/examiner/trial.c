/* From chapters/B-examiner.nw: edit there, then run make tangle. */
/* checksum 379612220 of the lines below */
#include "examiner/trial.h"
#include "examiner/process.h"
#include "examiner/report.h"
#include "examiner/text.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

const char *state_name(enum state state)
{
    static const char *const names[] = {"not begun", "does not build",
                                        "failed",    "crashed",
                                        "timed out", "passed"};
    return names[state];
}

enum { MEMORY_MIB = 512, FILE_MIB = 1, SANITIZER_STATUS = 86 };

struct result {
    struct process_end end;
    char *report;    /* as it was written */
    char *output;    /* what the program printed */
    char *sanitizer; /* the sanitizers' report, or NULL */
    char nonce[REPORT_NONCE + 1];
};

static void give_up(const char *what, const char *path)
{
    fprintf(stderr, "examine: cannot %s '%s': %s\n", what, path,
            strerror(errno));
    exit(2);
}

static void draw_nonce(char nonce[REPORT_NONCE + 1])
{
    unsigned char bytes[REPORT_NONCE / 2];
    FILE *random = fopen("/dev/urandom", "r");
    if (!random || fread(bytes, sizeof bytes, 1, random) != 1)
        give_up("read", "/dev/urandom");
    fclose(random);
    for (size_t i = 0; i < sizeof bytes; ++i)
        snprintf(nonce + 2 * i, 3, "%02x", bytes[i]);
}

static int open_fresh(const char *path)
{
    unlink(path);
    const int file = open(path, O_RDWR | O_CREAT | O_EXCL | O_APPEND, 0600);
    if (file < 0)
        give_up("write", path);
    return file;
}

static void set_sanitizers(const char *folder)
{
    char options[512];
    snprintf(options, sizeof options,
             "log_path='%s/sanitizer':exitcode=%d:hard_rss_limit_mb=%d:"
             "handle_abort=1:detect_leaks=0:allow_addr2line=1:color=never",
             folder, SANITIZER_STATUS, MEMORY_MIB);
    setenv("ASAN_OPTIONS", options, 1);
    setenv("UBSAN_OPTIONS", options, 1);
}

static char *cut_off_error(char *output)
{
    char *line = strstr(output, ": runtime error: ");
    if (!line)
        return NULL;
    while (line > output && line[-1] != '\n')
        --line;
    char *error = strdup(line);
    *line = '\0';
    return error;
}

static void run_runner(const struct trial *trial, int number,
                       struct result *result)
{
    char report[4096], output[4096], test[16], descriptor[16];
    snprintf(report, sizeof report, "%s/report", trial->folder);
    snprintf(output, sizeof output, "%s/output", trial->folder);
    const int report_file = open_fresh(report);
    const int output_file = open_fresh(output);
    draw_nonce(result->nonce);
    if (write(report_file, result->nonce, REPORT_NONCE) != REPORT_NONCE)
        give_up("write", report);
    snprintf(test, sizeof test, "%d", number);
    snprintf(descriptor, sizeof descriptor, "%d", report_file);
    char *command[] = {(char *)trial->runner, test, descriptor, NULL};
    const size_t mib = 1024 * 1024;
    const struct process_limits limits = {
        .cpu_seconds = trial->seconds,
        .wall_seconds = 2 * trial->seconds,
        .memory_bytes = trial->sanitized ? 0 : MEMORY_MIB * mib,
        .file_bytes = FILE_MIB * mib,
    };
    set_sanitizers(trial->folder);
    if (!process_run(command, output_file, report_file, &limits,
                     &result->end))
        give_up("start", trial->runner);
    close(report_file);
    close(output_file);
    result->report = text_read(report, TEXT_LIMIT);
    result->output = text_read(output, TEXT_LIMIT);
    snprintf(report, sizeof report, "%s/sanitizer.%ld", trial->folder,
             (long)result->end.pid);
    result->sanitizer = text_read(report, TEXT_LIMIT);
    if (!result->sanitizer && result->output &&
        WIFEXITED(result->end.status) &&
        WEXITSTATUS(result->end.status) == SANITIZER_STATUS)
        result->sanitizer = cut_off_error(result->output);
}

static const char *record_text(const struct result *result,
                               const char *line, const char *word)
{
    const char *text = text_after(line, result->nonce);
    text = text ? text_after(text, " ") : NULL;
    text = text ? text_after(text, word) : NULL;
    return text ? text_after(text, " ") : NULL;
}

static void find_record(const struct result *result, const char *word,
                        char found[REPORT_RECORD])
{
    char *copy = strdup(result->report ? result->report : "");
    char *rest = copy;
    for (char *line; (line = text_line(&rest));) {
        const char *text = record_text(result, line, word);
        if (text)
            snprintf(found, REPORT_RECORD, "%s", text);
    }
    free(copy);
}

static const struct {
    const char *word, *meaning;
} sanitizer_words[] = {
    {"heap-buffer-overflow", "it went past the end of memory that malloc "
                             "gave"},
    {"stack-buffer-overflow", "it went past the end of an array"},
    {"stack-buffer-underflow", "it went before the start of an array"},
    {"global-buffer-overflow", "it went past the end of an array"},
    {"heap-use-after-free", "it used memory after free"},
    {"attempting double-free", "it freed the same memory twice"},
    {"attempting free", "it freed what malloc had not given"},
    {"stack-overflow", "the stack is full; does a function call itself "
                       "without end?"},
    {"SEGV", "SIGSEGV, a pointer or an index that leads nowhere"},
    {"BUS", "SIGBUS, a pointer that leads nowhere"},
    {"FPE", "SIGFPE, a whole number divided by zero"},
    {"ABRT", "SIGABRT, it called abort; a false assertion does, too"},
    {"hard rss limit", "it used more than 512 MiB of memory"},
    {"allocation-size-too-big", "it asked for more memory than there is"},
    {"requested allocation size", "it asked for more memory than there is"},
    {"out-of-memory", "it asked for more memory than there is"},
};

static void sanitizer_meaning(const char *report, char *text, size_t room)
{
    const size_t count = sizeof sanitizer_words / sizeof *sanitizer_words;
    const char *error = strstr(report, "runtime error: ");
    if (error) {
        error += strlen("runtime error: ");
        snprintf(text, room, "%.*s", (int)strcspn(error, "\n"), error);
        return;
    }
    error = strstr(report, "Sanitizer: ");
    error = error ? error + strlen("Sanitizer: ") : report;
    for (size_t i = 0; i < count; ++i)
        if (text_after(error, sanitizer_words[i].word)) {
            snprintf(text, room, "%s", sanitizer_words[i].meaning);
            return;
        }
    snprintf(text, room, "%.*s", (int)strcspn(error, "\n"), error);
}

static void find_place(const char *report, const char *source,
                       char *function, size_t room, int *number)
{
    char *copy = strdup(report);
    char *rest = copy;
    char name[4096];
    snprintf(name, sizeof name, "%s:", source);
    for (char *line; *number == 0 && (line = text_line(&rest));) {
        const char *place = strstr(line, name);
        const char *in = strstr(line, " in ");
        if (!place)
            continue;
        *number = atoi(place + strlen(name));
        if (in && in < place)
            snprintf(function, room, "%.*s", (int)strcspn(in + 4, " ("),
                     in + 4);
    }
    free(copy);
}

static void tell_sanitizer(const struct trial *trial, const char *report,
                           FILE *story)
{
    char text[512], function[128] = "";
    int number = 0;
    sanitizer_meaning(report, text, sizeof text);
    text_field(story, "what", text);
    find_place(report, trial->source, function, sizeof function, &number);
    if (!number)
        return;
    snprintf(text, sizeof text, "%s:%d%s%s", trial->source, number,
             *function ? ", in the function " : "", function);
    text_field(story, "where", text);
    text_quote_line(story, trial->source, number);
}

static const struct {
    int signal;
    const char *meaning;
} signal_words[] = {
    {SIGSEGV, "SIGSEGV: it used a pointer or an index that leads nowhere, "
              "or called itself without end."},
    {SIGBUS, "SIGBUS: it used a pointer that leads nowhere."},
    {SIGFPE, "SIGFPE: a whole number was divided by zero."},
    {SIGILL, "SIGILL: it did what C leaves undefined."},
    {SIGABRT, "SIGABRT: it called abort; a false assertion does, too."},
    {SIGXFSZ, "SIGXFSZ: it printed or wrote more than 1 MiB. Is there a "
              "loop that prints without end?"},
    {SIGKILL, "SIGKILL: the system stopped it, most often for want of "
              "memory."},
};

static const char *signal_meaning(int signal)
{
    static char other[64];
    const size_t count = sizeof signal_words / sizeof *signal_words;
    for (size_t i = 0; i < count; ++i)
        if (signal_words[i].signal == signal)
            return signal_words[i].meaning;
    snprintf(other, sizeof other, "It was ended by signal %d.", signal);
    return other;
}

static void tell_crash(const struct trial *trial,
                       const struct result *result, FILE *story)
{
    const int status = result->end.status;
    char text[256];
    if (result->sanitizer && *result->sanitizer) {
        tell_sanitizer(trial, result->sanitizer, story);
    } else if (WIFSIGNALED(status)) {
        text_fold(story, "  ", 2, signal_meaning(WTERMSIG(status)));
    } else {
        snprintf(text, sizeof text,
                 "The program ended, with status %d, before the test had "
                 "said how it went. Does your file call exit, or close "
                 "what it has not opened?",
                 WEXITSTATUS(status));
        text_fold(story, "  ", 2, text);
    }
}

static const char *equation_in_book(const char *label,
                                    char text[REPORT_RECORD])
{
    char *table = text_read("tests/equations.txt", TEXT_LIMIT);
    char *rest = table;
    char name[128], number[32];
    snprintf(text, REPORT_RECORD, "the equation %s", label);
    for (char *line; (line = text_line(&rest));)
        if (sscanf(line, "%127s %31s", name, number) == 2 &&
            strcmp(name, label) == 0)
            snprintf(text, REPORT_RECORD, "equation (%s)", number);
    free(table);
    return text;
}

static void tell_failure(const struct result *result, FILE *story)
{
    char *copy = strdup(result->report ? result->report : "");
    char *rest = copy;
    for (char *line; (line = text_line(&rest));) {
        const char *text = record_text(result, line, REPORT_SAYS);
        char label[16] = "", book[REPORT_RECORD];
        if (!text || sscanf(text, "%15s", label) != 1)
            continue;
        text += strlen(label);
        text += strspn(text, " ");
        if (strcmp(label, "book") == 0)
            text = equation_in_book(text, book);
        text_field(story, label, text);
    }
    free(copy);
}

static bool took_too_long(const struct trial *trial,
                          const struct process_end *end)
{
    if (end->timed_out)
        return true;
    if (!WIFSIGNALED(end->status))
        return false;
    return WTERMSIG(end->status) == SIGXCPU ||
           (WTERMSIG(end->status) == SIGKILL &&
            end->seconds >= trial->seconds);
}

static void tell_time_out(const struct trial *trial, FILE *story)
{
    char text[256];
    snprintf(text, sizeof text,
             "This test was stopped after %d s of computing or %d s of "
             "waiting. Is there a loop that never ends, or one whose "
             "condition never turns false?",
             trial->seconds, 2 * trial->seconds);
    text_fold(story, "  ", 2, text);
}

enum state trial_run(const struct trial *trial, int number, FILE *story)
{
    struct result result = {0};
    run_runner(trial, number, &result);
    enum state state;
    char verdict[REPORT_RECORD] = "", undone[REPORT_RECORD] = "";
    find_record(&result, REPORT_VERDICT, verdict);
    find_record(&result, REPORT_UNDONE, undone);
    if (took_too_long(trial, &result.end)) {
        state = TIMED_OUT;
        tell_time_out(trial, story);
    } else if (result.end.status != 0 || (!*verdict && !*undone)) {
        state = CRASHED;
        tell_crash(trial, &result, story);
    } else if (*undone) {
        state = NOT_BEGUN;
        fprintf(story, "  NOT_DONE_YET still stands at %s\n", undone);
    } else if (strcmp(verdict, "passed") != 0) {
        state = FAILED;
        tell_failure(&result, story);
    } else {
        state = PASSED;
    }
    if (state != PASSED && state != NOT_BEGUN && result.output &&
        *result.output) {
        fprintf(story, "  Your program printed:\n");
        text_quote(story, result.output, 12);
    }
    free(result.report);
    free(result.output);
    free(result.sanitizer);
    return state;
}
