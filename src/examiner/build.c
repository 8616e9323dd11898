/* Compiles exercises and projects, and explains errors and warnings. */
#include "examiner/build.h"
#include "examiner/message.h"
#include "examiner/process.h"
#include "examiner/text.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Returns the text of build/check/flags, which make writes: the compiler's
   command on line 1 and the libraries on line 2. Flags in the environment
   are ignored, because objects compiled with different sanitizers cannot be
   linked. */
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

/* Usually make check has compiled the tests already. This function is for a
   student who begins another exercise while make watch is running. */
void build_suite(const char *exercise)
{
    static char script[] = "exec ${MAKE:-make} -s \"$@\" >&2";
    const struct process_limits limits = {120, RLIM_INFINITY, RLIM_INFINITY,
                                          RLIM_INFINITY};
    const struct process_files files = {.output = STDERR_FILENO};
    struct process_end end;
    char suite[64], given[64];
    snprintf(suite, sizeof suite, "build/check/%s.suite.o", exercise);
    snprintf(given, sizeof given, "build/check/%s.given.o", exercise);
    char *command[] = {"sh", "-c",  script,
                       "sh", suite, *exercise == 'P' ? given : NULL,
                       NULL};
    if (access(suite, F_OK) != 0 &&
        (!process_run(command, ".", &files, &limits, &end) ||
         end.status != 0) &&
        !process_signal())
        text_fail("the tests of %s cannot be built; try: make %s", exercise,
                  suite);
}

/* The shell script that compiles and links the student's file. It includes
   a header that declares the exercise's functions, because the linker does
   not notice wrong types and the results would look like wrong physics.
   `strict` turns warnings into errors. Only the kit's own tests set it: an
   unfinished file may have an unused variable and still be worth
   running. */
static char function[] = BUILD_MEMBERS
    "types=build/check/$5.types.h && [ -f $types ] || types=\n"
    "$1 $2 ${types:+-include $types} -Isrc -Isrc/examiner "
    "-Wall -Wextra -fmax-errors=20 "
    "-o \"$3/runner\" \"$4\" build/check/$5.suite.o $6 &&\n"
    "members \"$types\" \"$4\" $1 -Isrc -Isrc/examiner";
static char runner[] = "exec $1 -o \"$3/runner\" build/check/$5.suite.o $6";
/* The shell script that builds a project several times, each time with
   another version of the function that the project's header declares.
   Version 0 is right and the others are wrong. Only version 0 is built with
   sanitizers and warnings: the other versions would give the same warnings,
   and they compile in half the time without sanitizers. */
static char program[] =
    "given=build/check/$5.given.o law=1\n"
    "name=$(sed -n 's/^void \\([a-z]*\\)_0(.*/\\1/p' \\\n"
    "    tests/exercises/$5/*.c | head -n 1)\n"
    "build() { \"$@\" -Isrc/examiner -DEXAMINER_GIVES; }\n"
    "plain=$(printf %s \"$1\" | sed 's/-f[no-]*sanitize[^ ]*//g')\n"
    "build $1 $2 -Wall -Wextra -fmax-errors=20 \\\n"
    "    ${name:+-D$name=${name}_0} \\\n"
    "    -o \"$3/program0\" \"$4\" $given -lm || exit\n"
    "while [ \"$name\" ] &&\n"
    "    grep -q \"^void ${name}_$law(\" tests/exercises/$5/*.c; do\n"
    "    build $plain -w -D$name=${name}_$law -o \"$3/program$law\" \\\n"
    "        \"$4\" $given -lm || exit\n"
    "    law=$((law + 1))\n"
    "done\n";

/* Runs one of the scripts above and returns whether it succeeded. Names are
   passed as arguments: if they were part of the script, a quotation mark in
   a name could start a command. The compiler writes its messages in English
   and without colours, because this file parses them. A compiler that needs
   more than 30 s for an exercise is in an endless loop. */
static bool compile(const char *folder, const char *exercise, char *source,
                    bool strict, char *script)
{
    const struct process_limits limits = {30, RLIM_INFINITY, RLIM_INFINITY,
                                          RLIM_INFINITY};
    struct process_end end;
    char messages[4096];
    char *libraries = flags_read(), *flags = libraries;
    char *compiler = text_line(&libraries);
    snprintf(messages, sizeof messages, "%s/messages", folder);
    char *command[] = {
        "sh",           "-c",     script,
        "sh",           compiler, strict ? "-pedantic -Werror" : "",
        (char *)folder, source,   (char *)exercise,
        libraries,      NULL};
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

/* Returns how often `word` occurs in `text`. The blanks in " error: "
   exclude names that end in "error". */
static int count(const char *text, const char *word)
{
    int found = 0;
    for (; (text = strstr(text, word)); ++text)
        ++found;
    return found;
}

/* Returns the line of the error or warning that the student should see.
   This is the first error in the student's file, since later errors often
   follow from it. A missing return is reported only if there is no other
   error: after another error, the compiler may not have read the function
   to its end. Among warnings, the first one with an explanation is
   preferred; a warning about an unused variable, for example, seldom helps
   a beginner. */
static const char *find_first(const char *text, const char *source,
                              const char *word)
{
    const char *first = find_line(text, source, word), *line = first;
    while (line &&
           (*word == 'e' ? find_line(line, source, "return-type") == line
                         : !message_known(line)))
        line = find_line(line + strcspn(line, "\n"), source, word);
    return line ? line : first;
}

/* Explains an error that the compiler found in a header. System headers
   have no errors, so the mistake is in the student's file, above the
   #include: for example, a missing semicolon. */
static void tell_header(const char *text, const char *source, FILE *story)
{
    char place[4200];
    snprintf(place, sizeof place, "from %s:", source);
    const char *from = strstr(text, place);
    if (!from)
        return;
    const int number = atoi(from + strlen(place));
    text_quote_line(story, source, number);
    snprintf(place, sizeof place,
             "This is line %d of %s. The error was noticed behind it, and "
             "is before it: is a semicolon or a } missing above?",
             number, source);
    text_field(story, "means", place);
}

/* Returns whether the error in this line is about the types of a function
   or the members of a structure. If so, copies the name of that function or
   structure to `name`. If a function is defined in the old style, with the
   types after the parentheses, the name is not in this line but in a line
   above it. */
static bool name_function(const char *text, const char *line,
                          char name[MESSAGE_NAME])
{
    static const char *const words[] = {
        "conflicting types for '", "static declaration of '",
        "redeclared as different kind", "as different kind of symbol",
        "members changed in '"};
    const char *above = NULL, *in = text;
    for (size_t i = 0; i < sizeof words / sizeof *words; ++i)
        if (find_line(line, "", words[i]) == line) {
            message_quoted(name, line);
            return *name;
        }
    if (find_line(line, "", " match prototype") != line)
        return false;
    while ((in = strstr(in, "In function '")) && in < line)
        above = in++;
    message_quoted(name, above);
    return *name;
}

/* Returns the exercise's declaration of the function or structure `name`,
   or NULL. tests/types.awk writes these declarations into the header as
   comments. */
static char *given_function(char *header, const char *name)
{
    const size_t length = strlen(name);
    for (char *line; (line = text_line(&header));) {
        const char *given = text_after(line, "/* given: ");
        const char *found = given ? strstr(given, name) : NULL;
        char *end = given ? strstr(given, " */") : NULL;
        if (found && end && strchr(" *", found[-1]) &&
            (found[length] == '(' || text_after(found + length, " {"))) {
            *end = '\0';
            return line + strlen("/* given: ");
        }
    }
    return NULL;
}

/* Returns an explanation of an error about the types of a function that the
   exercise declares, or NULL for any other error. */
static const char *name_types(const char *text, const char *line,
                              const char *types)
{
    static char sentence[640];
    char name[MESSAGE_NAME];
    if (!name_function(text, line, name))
        return NULL;
    char *header = text_read(types);
    const char *given = header ? given_function(header, name) : NULL;
    const bool is_static =
        find_line(line, "", "static declaration of '") == line;
    snprintf(sentence, sizeof sentence,
             is_static ? "%s is static here, and the tests cannot call it. "
                         "The exercise gave: %s"
             : find_line(line, "", "members changed in '") == line
                 ? "%s has other members than the exercise gave: %s"
                 : "%s has other types than the exercise gave: %s",
             name, given ? given : "");
    free(header);
    return given ? sentence : NULL;
}

void build_tell(const char *text, const char *source, const char *types,
                FILE *story)
{
    if (text_utf16(source)) {
        text_field(story, "means",
                   "The file is UTF-16: save it as UTF-8. It has two bytes "
                   "for each letter, and a compiler reads one.");
        return;
    }
    const char *own = find_first(text, source, "error:");
    const char *line = own ? own : find_line(text, "", "error:");
    if (!own && line)
        tell_header(text, source, story);
    /* The linker names each file before that file's errors, and the
       student's file comes first. So an undefined reference that is
       reported before the suite's name is a call in the student's file; a
       later one is a call in the tests. A multiple definition is a name
       that the tests define as well. */
    const char *lost = strstr(text, "undefined reference");
    const char *twice = strstr(text, "multiple definition");
    const char *tests = strstr(text, ".suite.o");
    char name[33] = "";
    if (lost && (!tests || tests > lost) &&
        sscanf(lost, "%*[^`'\n]%*[`']%32[A-Za-z0-9_]", name) == 1)
        fprintf(
            story,
            strcmp(name, "main") == 0
                ? "  There is no %s in your file; a program begins there.\n"
                : "  Your file calls %s, which is nowhere; is it spelt "
                  "right?\n",
            name);
    else if (lost)
        fputs("  The tests call a function that is gone. Was it renamed?\n",
              story);
    else if (twice)
        fputs("  This name is taken, by the tests or their main program.\n",
              story);
    if (lost || twice)
        line = lost ? lost : twice;
    const char *told = own ? name_types(text, own, types) : NULL;
    text_quote(story, line ? line : text, told ? 3 : line ? 4 : 8);
    if (told)
        text_field(story, "means", told);
    else if (own)
        message_explain(story, own);
    const int others =
        count(text, " error: ") - count(text, "[-Werror=return-type]");
    if (others > 1)
        fprintf(story, "  and %d more that may go away with it\n",
                others - 1);
}

bool build_runner(const char *folder, const char *exercise,
                  const char *source, bool strict, FILE *story)
{
    const bool project = *exercise == 'P';
    const bool built =
        compile(folder, exercise, (char *)source, strict,
                project ? runner : function) &&
        (!project ||
         compile(folder, exercise, (char *)source, strict, program));
    char *text = read_messages(folder), types[64];
    snprintf(types, sizeof types, "build/check/%s.types.h", exercise);
    if (!built)
        build_tell(text, source, types, story);
    free(text);
    return built;
}

/* Called only after a test has failed, because a warning often names the
   cause. */
void build_warning(const char *folder, const char *source, FILE *story)
{
    char *text = read_messages(folder);
    const char *line = find_first(text, source, "warning:");
    if (line) {
        fprintf(story, "  The compiler has a warning:\n");
        text_quote(story, line, 3);
        message_explain(story, line);
    }
    free(text);
}

bool build_blames(const char *folder, const char *source)
{
    char *text = read_messages(folder);
    const bool found = find_line(text, source, "error:") != NULL;
    free(text);
    return found;
}
