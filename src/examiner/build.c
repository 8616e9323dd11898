/* From chapters/B-examiner.nw: edit there, then run make tangle. */
/* checksum 1696125624 of the lines below */
#include "examiner/build.h"
#include "examiner/process.h"
#include "examiner/text.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static char *flags_read(void)
{
    char *flags = text_read("build/check/flags", TEXT_LIMIT);
    if (flags && *flags)
        return flags;
    fprintf(stderr, "examine: build/check/flags is missing; start me with "
                    "make check\n");
    exit(2);
}

bool build_sanitized(void)
{
    char *flags = flags_read();
    const bool found = strstr(flags, "-fsanitize=address") != NULL;
    free(flags);
    return found;
}

enum { COMMAND_WORDS = 128 };

static void add_word(char *command[], char *word)
{
    size_t count = 0;
    while (command[count])
        ++count;
    if (count < COMMAND_WORDS - 1)
        command[count] = word;
}

static void add_words(char *command[], char *text)
{
    for (char *word; (word = strtok_r(text, " \n", &text));)
        add_word(command, word);
}

static void make_command(char *command[], char *flags, bool strict,
                         char *output, char *source, char *suite)
{
    static char always[] = "-Isrc -Isrc/examiner -Wall -Wextra -o";
    static char errors[] = "-pedantic -Werror";
    char *libraries = flags;
    add_words(command, text_line(&libraries));
    if (strict)
        add_words(command, errors);
    add_words(command, always);
    add_word(command, output);
    add_word(command, source);
    add_word(command, suite);
    add_words(command, libraries);
}

static int count_errors(const char *text)
{
    int count = 0;
    while ((text = strstr(text, " error: "))) {
        ++count;
        ++text;
    }
    return count;
}

static const char *first_line_with(const char *text, const char *start,
                                   const char *words)
{
    for (const char *line = text; line && *line;) {
        const size_t length = strcspn(line, "\n");
        const char *found = strstr(line, words);
        if (found && found < line + length &&
            (!start || text_after(line, start)))
            return line;
        line += length + (line[length] == '\n');
    }
    return NULL;
}

static void tell_build(const char *text, const char *source, FILE *story)
{
    const char *line = first_line_with(text, source, "error:");
    const int errors = count_errors(text);
    if (!line)
        line = first_line_with(text, NULL, "error:");
    const char *lost = first_line_with(text, NULL, "undefined reference");
    const char *twice = first_line_with(text, NULL, "multiple definition");
    if (lost) {
        line = strstr(lost, "undefined reference");
        fputs("  The tests call a function that is gone. Was it renamed?\n",
              story);
    } else if (twice) {
        line = strstr(twice, "multiple definition");
        fputs("  This name is taken, by the tests or their main program.\n",
              story);
    }
    text_quote(story, line ? line : text, line ? 4 : 8);
    if (errors > 1)
        fprintf(story, "  and %d more that may go away with it\n",
                errors - 1);
}

static void tell_warning(const char *text, const char *source, FILE *story)
{
    const char *line = first_line_with(text, source, "warning:");
    if (!line)
        return;
    fprintf(story, "  The compiler has a warning:\n");
    text_quote(story, line, 3);
}

bool build_runner(const char *folder, const char *exercise,
                  const char *source, bool strict, FILE *story,
                  FILE *warning)
{
    const struct process_limits limits = {30, 60, 0, 0};
    struct process_end end;
    char output[4096], messages[4096], suite[64];
    char *command[COMMAND_WORDS] = {NULL};
    char *flags = flags_read();
    snprintf(output, sizeof output, "%s/runner", folder);
    snprintf(messages, sizeof messages, "%s/messages", folder);
    snprintf(suite, sizeof suite, "build/check/%s.suite.o", exercise);
    make_command(command, flags, strict, output, (char *)source, suite);
    const int file = open(messages, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    setenv("LC_ALL", "C", 1);
    setenv("GCC_COLORS", "", 1);
    const bool started = process_run(command, file, -1, &limits, &end);
    close(file);
    char *text = text_read(messages, TEXT_LIMIT);
    const bool built = started && end.status == 0;
    if (!built)
        tell_build(text ? text : "", source, story);
    else
        tell_warning(text ? text : "", source, warning);
    free(text);
    free(flags);
    return built;
}
