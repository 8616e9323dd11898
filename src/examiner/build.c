/* From chapters/B-examiner.nw: edit there, then run make tangle. */
/* checksum 884252141 of the lines below */
#include "examiner/build.h"
#include "examiner/process.h"
#include "examiner/text.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char *flags_read(void)
{
    char *flags = text_read("build/check/flags");
    if (!flags || !*flags)
        text_fail("build/check/flags is missing; start me with make check");
    return flags;
}

bool build_sanitized(void)
{
    char *flags = flags_read();
    const bool found = strstr(flags, "-fsanitize=address") != NULL;
    free(flags);
    return found;
}

static bool compile(const char *folder, char *suite, char *source,
                    bool strict)
{
    static char script[] = "exec $1 $2 -Isrc -Isrc/examiner -Wall -Wextra "
                           "-o \"$3\" \"$4\" \"$5\" $6";
    const struct process_limits limits = {30, RLIM_INFINITY, RLIM_INFINITY,
                                          RLIM_INFINITY};
    struct process_end end;
    char runner[4096], messages[4096];
    char *libraries = flags_read(), *flags = libraries;
    char *compiler = text_line(&libraries);
    char *errors = strict ? "-pedantic -Werror" : "";
    snprintf(runner, sizeof runner, "%s/runner", folder);
    snprintf(messages, sizeof messages, "%s/messages", folder);
    char *command[] = {"sh",   "-c",   script, "sh",      compiler, errors,
                       runner, source, suite,  libraries, NULL};
    setenv("LC_ALL", "C", 1);
    setenv("GCC_COLORS", "", 1);
    setenv("TMPDIR", folder, 1);
    const int file = open(messages, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const struct process_files files = {.output = file};
    const bool started = process_run(command, ".", &files, &limits, &end);
    close(file);
    free(flags);
    return started && end.status == 0;
}

static char *read_messages(const char *folder)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/messages", folder);
    char *text = text_read(path);
    if (!text)
        text_fail("cannot read '%s'", path);
    return text;
}

static const char *find_line(const char *text, const char *start,
                             const char *word)
{
    for (const char *line = text; *line;) {
        const size_t length = strcspn(line, "\n");
        const char *found = strstr(line, word);
        if (found && found < line + length && text_after(line, start))
            return line;
        line += length + (line[length] == '\n');
    }
    return NULL;
}

static int count_errors(const char *text)
{
    int count = 0;
    for (; (text = strstr(text, " error: ")); ++text)
        ++count;
    return count;
}

static void tell_build(const char *text, const char *source, FILE *story)
{
    const int errors = count_errors(text);
    const char *line = find_line(text, source, "error:");
    if (!line)
        line = find_line(text, "", "error:");
    const char *lost = strstr(text, "undefined reference");
    const char *twice = strstr(text, "multiple definition");
    const char *tests = strstr(text, ".suite.o");
    char name[33] = "";
    if (lost && (!tests || tests > lost) &&
        sscanf(lost, "%*[^`'\n]%*[`']%32[A-Za-z0-9_]", name) == 1)
        fprintf(
            story,
            "  Your file calls %s, which is nowhere; is it spelt right?\n",
            name);
    else if (lost)
        fputs("  The tests call a function that is gone. Was it renamed?\n",
              story);
    else if (twice)
        fputs("  This name is taken, by the tests or their main program.\n",
              story);
    if (lost || twice)
        line = lost ? lost : twice;
    text_quote(story, line ? line : text, line ? 4 : 8);
    if (errors > 1)
        fprintf(story, "  and %d more that may go away with it\n",
                errors - 1);
}

bool build_runner(const char *folder, const char *exercise,
                  const char *source, bool strict, FILE *story)
{
    char suite[64];
    snprintf(suite, sizeof suite, "build/check/%s.suite.o", exercise);
    const bool built = compile(folder, suite, (char *)source, strict);
    char *text = read_messages(folder);
    if (!built)
        tell_build(text, source, story);
    free(text);
    return built;
}

void build_warning(const char *folder, const char *source, FILE *story)
{
    char *text = read_messages(folder);
    const char *line = find_line(text, source, "warning:");
    if (line) {
        fprintf(story, "  The compiler has a warning:\n");
        text_quote(story, line, 3);
    }
    free(text);
}
