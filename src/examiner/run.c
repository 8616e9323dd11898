/* Runs a program in the sandbox and reads its table. */
#include "examiner/run.h"
#include "examiner/remote.h"
#include "examiner/check.h"
#include "examiner/transport.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static const char *project(void)
{
    return check_text("%.2s", check_suite.file);
}

const char *run_text(const struct run_order *o)
{
    static char text[400];
    size_t at = (size_t)snprintf(text, sizeof text, "%s", project());
    for (int i = 0; o->arguments[i] && at < sizeof text; ++i)
        at += (size_t)snprintf(text + at, sizeof text - at, " %s",
                               o->arguments[i]);
    for (int i = 0; i < RUN_FILES && o->files[i].name; ++i) {
        if (at < sizeof text)
            at += (size_t)snprintf(text + at, sizeof text - at,
                                   "; in %s: ", o->files[i].name);
        for (const char *c = o->files[i].text; *c && at + 8 < sizeof text;
             ++c) {
            const int width = *c != '\n' ? 1 : c[1] ? 3 : 0;
            at += (size_t)snprintf(text + at, sizeof text - at, "%.*s",
                                   width, width == 1 ? c : " / ");
        }
        if (at < sizeof text)
            text[at] = '\0';
    }
    if (at + 8 >= sizeof text)
        strcpy(text + sizeof text - 8, " ...");
    return text;
}

static void send_text(const char *text)
{
    size_t length = strlen(text);
    remote_sizes(&length, 1);
    transport_move((void *)text, length);
}

static void send_order(const struct run_order *o)
{
    int given = o->given, count = (int)o->count, words = 1, files = 0;
    double of_law[] = {o->constant, o->most};
    while (o->arguments[words - 1])
        ++words;
    while (files < RUN_FILES && o->files[files].name)
        ++files;
    remote_ints(&given, 1);
    remote_ints(&count, 1);
    remote_doubles(of_law, 2);
    remote_ints(&words, 1);
    remote_ints(&files, 1);
    send_text(project());
    for (int i = 0; o->arguments[i]; ++i)
        send_text(o->arguments[i]);
    for (int i = 0; i < files; ++i) {
        send_text(o->files[i].name);
        send_text(o->files[i].text);
    }
}

/* Reads at most `most` numbers from a line into x. Returns how many numbers
   the line has, or 0 if it contains anything else. If no blank separates
   two numbers, sets r->glued, and sets r->broken to the first of them. Such
   numbers cannot be told apart: strtod reads 1e-3001.5 as 1e-3001 and 0.5,
   not as 1e-300 and 1.5. */
static size_t read_row(struct run *r, const char *line, double x[],
                       size_t most)
{
    const char *last = line;
    size_t count = 0;
    char *end;
    for (;; last = line, line = end, ++count) {
        const double value = strtod(line, &end);
        if (end == line)
            break;
        if (count > 0 && !strchr(" \t\r", *line)) {
            r->broken = last + strspn(last, " \t\r");
            r->glued = true;
            return 0;
        }
        if (count < most)
            x[count] = value;
    }
    line += strspn(line, " \t\r");
    return *line ? 0 : count;
}

static void add_row(struct run *r, const char *line)
{
    double row[320]; /* enough for 64 bodies in the plane */
    const size_t count = read_row(r, line, row, 320);
    if (count == 0 || count > 320 || (r->rows > 0 && count != r->columns)) {
        r->broken = check_text("%.60s", r->glued ? r->broken : line);
        return;
    }
    r->columns = count;
    if ((r->rows & (r->rows - 1)) == 0) { /* 0, or a power of 2 */
        r->numbers =
            realloc(r->numbers, (2 * r->rows + 1) * sizeof row[0] * count);
        if (!r->numbers)
            transport_lost();
    }
    memcpy(r->numbers + r->rows++ * count, row, count * sizeof *row);
}

/* Reads the rows and remarks in the program's output. Moves the remarks to
   the front of the text, where they overwrite rows that were already
   read. */
static void read_table(struct run *r, char *text)
{
    char *rest = text, *remarks = text;
    r->broken = "";
    for (char *line = rest; line && *line; line = rest) {
        rest = strchr(line, '\n');
        if (rest)
            *rest++ = '\0';
        if (*line == '#') {
            const size_t length = strlen(line);
            memmove(remarks, line, length);
            remarks += length;
            *remarks++ = '\n';
        } else if (!*r->broken)
            add_row(r, line);
    }
    *remarks = '\0';
    r->remarks = text;
}

int run_remark(const struct run *run, const char *words, double x[],
               int count)
{
    const size_t length = strlen(words);
    const char *line = run->remarks;
    while (*line && strncmp(line, words, length) != 0) {
        line += strcspn(line, "\n");
        line += *line == '\n';
    }
    int found = 0;
    char *end;
    for (line += *line ? length : 0; found < count; ++found, line = end) {
        x[found] = strtod(line, &end);
        if (end == line || memchr(line, '\n', (size_t)(end - line)))
            break;
    }
    return found;
}

enum { SANITIZER_STATUS = 86 };

/* Ends the test if the program crashed or was stopped. Uses the
   program's signal, so that the examiner reports the crash like that of
   a function. */
static void end_like(const struct run_order *o, int status, bool late)
{
    const bool sane =
        WIFEXITED(status) && WEXITSTATUS(status) != SANITIZER_STATUS;
    if (!late && sane)
        return;
    check_tell("run", run_text(o));
    if (late)
        check_tell("question", o->late);
    fflush(NULL);
    if (!late && WIFEXITED(status))
        _exit(SANITIZER_STATUS);
    const int number = late ? SIGXCPU : WTERMSIG(status);
    signal(number, SIG_DFL);
    raise(number);
    _exit(EXIT_FAILURE);
}

/* The result arrives in the order in which run_server.c sends it. Ends the
   test if the sandbox announces more output than is allowed. */
const struct run *run_program(const struct run_order *order)
{
    static struct run r;
    static char *text;
    int how[3];
    size_t sizes[2];
    free(r.numbers);
    free(text);
    free(r.complaint);
    r = (struct run){.status = -1};
    check_about(run_text(order));
    remote_call();
    send_order(order);
    remote_wait();
    remote_ints(how, 3);
    remote_doubles(&r.calls, 1);
    remote_sizes(sizes, 2);
    if (sizes[0] > RUN_PRINTS || sizes[1] > RUN_COMPLAINT)
        transport_lost();
    text = remote_memory(sizes[0] + 2);
    r.complaint = remote_memory(sizes[1] + 1);
    transport_move(text, sizes[0]);
    transport_move(r.complaint, sizes[1]);
    text[sizes[0]] = text[sizes[0] + 1] = '\0';
    r.complaint[sizes[1]] = '\0';
    end_like(order, how[0], how[1]);
    r.status = WEXITSTATUS(how[0]);
    r.flooded = how[2];
    read_table(&r, text);
    return &r;
}
