/* Writes reports on marks as a table, CSV, JSON and XML. */
#define _XOPEN_SOURCE 700 /* wcwidth */
#include "examiner/publish.h"
#include "examiner/text.h"
#include "toolbox/replace.h"

#include <errno.h>
#include <jansson.h>
#include <libxml/xmlwriter.h>
#include <locale.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <wchar.h>

static const struct marks *marks_of(const struct course *c, size_t s,
                                    size_t e)
{
    return &c->marks[s * c->exercises + e];
}

static bool lost(const struct marks *m)
{
    return m->count == 0;
}

static int earned(const struct marks *m)
{
    return marks_earned(m, false) + marks_earned(m, true);
}

/* Returns the points possible in an exercise. This is the maximum over all
   students, because an exercise that was not graded has no tests. */
static int possible(const struct course *c, size_t e)
{
    int most = 0;
    for (size_t s = 0; s < c->students; ++s) {
        const struct marks *m = marks_of(c, s, e);
        const int sum = marks_possible(m, false) + marks_possible(m, true);
        if (sum > most)
            most = sum;
    }
    return most;
}

static int possible_of_all(const struct course *c)
{
    int sum = 0;
    for (size_t e = 0; e < c->exercises; ++e)
        sum += possible(c, e);
    return sum;
}

/* Returns whether all of a student's exercises were graded. Otherwise no
   total is written, since it would be too small. */
static bool complete(const struct course *c, size_t s)
{
    for (size_t e = 0; e < c->exercises; ++e)
        if (lost(marks_of(c, s, e)))
            return false;
    return true;
}

static int earned_of_all(const struct course *c, size_t s)
{
    int sum = 0;
    for (size_t e = 0; e < c->exercises; ++e)
        sum += earned(marks_of(c, s, e));
    return sum;
}

static double seconds_of_all(const struct course *c, size_t s)
{
    double sum = 0;
    for (size_t e = 0; e < c->exercises; ++e)
        sum += marks_of(c, s, e)->seconds;
    return sum;
}

/* Returns a formatted and escaped text; the caller frees it. Every text is
   escaped: the course's name is that of a folder, and other texts come from
   the environment. */
static char *compose(const char *format, ...)
{
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const int length = vsnprintf(NULL, 0, format, again);
    va_end(again);
    char *raw = text_must(length < 0 ? NULL : malloc((size_t)length + 1));
    vsnprintf(raw, (size_t)length + 1, format, arguments);
    va_end(arguments);
    char *text = marks_text(raw, (size_t)length, (size_t)length);
    free(raw);
    return text;
}

/* Cuts a text to at most `most` bytes without splitting a character, and
   returns it. In UTF-8 a byte that begins with the bits 10 continues a
   character. */
static char *shorten(char *text, size_t most)
{
    if (strlen(text) <= most)
        return text;
    while (most > 0 && (text[most] & 0xc0) == 0x80)
        --most;
    text[most] = '\0';
    return text;
}

/* Returns the name under which students see a test. They do not see the
   name of a hidden test, which may reveal what it tests. Nor do they see
   its report, which contains the inputs, or the program's output, which
   might be the inputs. */
static const char *shown_name(const struct marks *m, int test,
                              char room[32])
{
    int number = 0;
    if (!m->marks[test].hidden)
        return m->marks[test].name;
    for (int i = 0; i <= test; ++i)
        number += m->marks[i].hidden;
    snprintf(room, 32, "hidden check %d", number);
    return room;
}

/* Returns the state that students see for a test. If the file does not
   build, every test is "not begun" in the marks, but students see "does not
   build". */
static enum state state_of(const struct marks *m, int test)
{
    const enum state state = m->marks[test].state;
    return state == NOT_BEGUN && m->state == DOES_NOT_BUILD ? DOES_NOT_BUILD
                                                            : state;
}

/* Returns the state that students see for an exercise; only the public
   tests count. Otherwise students would learn about hidden tests, for
   example from "failed" above 9 of 9 points. */
static enum state shown_state(const struct marks *m)
{
    for (int i = 0; i < m->count; ++i)
        if (!m->marks[i].hidden && state_of(m, i) != PASSED)
            return state_of(m, i);
    return marks_possible(m, false) > 0 ? PASSED : m->state;
}

static const char *shown_story(const struct marks *m, int test)
{
    if (m->marks[test].hidden)
        return "A hidden check. What goes into it is not shown.";
    return *m->marks[test].story ? m->marks[test].story
                                 : state_name(state_of(m, test));
}

struct draft {
    char path[4096], *temporary;
    FILE *file;
};

static _Noreturn void give_up(const struct draft *draft)
{
    const int why = errno;
    replace_cancel(draft->temporary);
    text_fail("cannot write '%s': %s", draft->path, strerror(why));
}

static void make_folder(const char *path)
{
    if (mkdir(path, 0777) != 0 && errno != EEXIST)
        text_fail("cannot make the folder '%s': %s", path, strerror(errno));
}

/* Makes the path of a report. A path that is too long is an error, because
   a truncated path would name another file. */
static void draft_name(struct draft *draft, const char *folder,
                       const char *name)
{
    const int length =
        snprintf(draft->path, sizeof draft->path, "%s/%s", folder, name);
    if (length < 0 || (size_t)length >= sizeof draft->path)
        text_fail("the path '%s/%s' is too long", folder, name);
}

/* Opens a report. If it is about people, only its owner may read it. */
static void draft_open(struct draft *draft, const char *folder,
                       const char *name, bool about_people)
{
    draft_name(draft, folder, name);
    const int file =
        replace_begin(draft->path, about_people ? 0600 : REPLACE_USUAL,
                      &draft->temporary);
    draft->file = file < 0 ? NULL : fdopen(file, "w");
    if (!draft->file)
        give_up(draft);
}

static void draft_remove(const char *folder, const char *name)
{
    struct draft draft;
    draft_name(&draft, folder, name);
    if (unlink(draft.path) != 0 && errno != ENOENT)
        text_fail("cannot remove '%s': %s", draft.path, strerror(errno));
}

/* Finishes a report and gives it its name. All errors are checked here:
   fprintf only fills a buffer, so a full disk may be noticed only now.
   fsync waits for the disk. */
static void draft_close(struct draft *draft)
{
    if (fflush(draft->file) != 0 || ferror(draft->file) ||
        fsync(fileno(draft->file)) != 0)
        give_up(draft);
    if (fclose(draft->file) != 0)
        give_up(draft);
    if (!replace_finish(draft->temporary, draft->path, false))
        text_fail("cannot write '%s': %s", draft->path, strerror(errno));
}

/* Returns whether a student's name is unique. Otherwise the marks of one
   student would overwrite those of another. */
static bool alone(const struct course *c, size_t s)
{
    const char *student = marks_of(c, s, 0)->student;
    for (size_t i = 0; i < c->students; ++i)
        if (i != s && strcmp(marks_of(c, i, 0)->student, student) == 0)
            return false;
    return true;
}

enum { FILE_NAME = 180 };

/* Makes a file name from a student's name and returns its length. Keeps
   letters, digits, space, . - _ and all characters that are not ASCII.
   Replaces any other character with % and two hexadecimal digits. Does the
   same with a dot at the beginning, which would hide the file, and with a
   minus at the beginning, which rm would take for an option. */
static size_t spell(const char *text, char *name)
{
    static const char plain[] =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
        "0123456789 -_.";
    size_t length = 0;
    for (const char *c = text; *c && length < FILE_NAME; ++c)
        if (!(*c & 0x80) &&
            (!strchr(plain, *c) || (c == text && strchr(".-", *c))))
            length += (size_t)sprintf(name + length, "%%%02X", *c);
        else
            name[length++] = *c;
    name[length] = '\0';
    return length;
}

static char *file_name(const struct course *c, size_t s)
{
    char name[FILE_NAME + 4];
    const size_t length = spell(marks_of(c, s, 0)->student, name);
    shorten(name, FILE_NAME - 1);
    return length > 0 && length < FILE_NAME && alone(c, s)
               ? compose("%s.json", name)
               : compose("%s%%_%zu.json", name, s + 1);
}

/* Returns whether a spreadsheet would take a cell for a formula: a student
   may call a folder =HYPERLINK(...). A formula begins with =, +, - or @,
   with the full-width form of such a sign, or with a tab or line end. An
   apostrophe before a formula makes it text. */
static bool is_formula(const char *text)
{
    static const char *const signs[] = {
        "=",  "+",      "-",      "@",      "\t",    "\r",
        "\n", "\uff1d", "\uff0b", "\uff0d", "\uff20"};
    for (size_t i = 0; i < sizeof signs / sizeof signs[0]; ++i)
        if (text_after(text, signs[i]))
            return true;
    return false;
}

static void put_cell(FILE *out, const char *text)
{
    fputs(is_formula(text) ? "\"'" : "\"", out);
    for (; *text; ++text) {
        if (*text == '"')
            putc('"', out);
        putc(*text, out);
    }
    putc('"', out);
}

/* A function that receives one line about a student's exercise. The
   exercise is "-" if the line is about all files of the student. `to` is
   passed through from the caller. */
typedef void take_line(void *to, const char *student, const char *exercise,
                       const char *text);

static void tell_notes(const struct course *c, size_t s, take_line *take,
                       void *to)
{
    const char *student =
        s < c->students ? marks_of(c, s, 0)->student : "-";
    for (const char *line = c->notes[s]; *line;) {
        const size_t length = strcspn(line, "\n");
        char *text = compose("%.*s", (int)length, line);
        take(to, student, "-", text);
        free(text);
        line += length + (line[length] == '\n');
    }
}
static char *first_advice(const struct marks *m)
{
    const char *text = m->advice + strspn(m->advice, " ");
    const char *what = text_after(text, "what ");
    if (what)
        text = what + strspn(what, " ");
    return compose("advice: %.*s", (int)strcspn(text, "\n"), text);
}

/* Passes on what a lecturer should look at: a refused file; a time-out,
   which might not recur on another day; a sanitizer's finding that costs no
   points; and a student who passes all public tests but fails hidden ones.
   Such a student may have learnt the answers by heart, or the hidden test
   may be wrong. */
static void tell_marks(const struct marks *m, take_line *take, void *to)
{
    const int hidden = marks_possible(m, true);
    const char *who = m->student, *what = m->exercise;
    if (*m->note || lost(m))
        take(to, who, what, lost(m) ? m->file : m->note);
    if (marks_late(m))
        take(to, who, what, "timed out");
    if (*m->advice) {
        char *text = first_advice(m);
        take(to, who, what, text);
        free(text);
    }
    if (marks_earned(m, false) == marks_possible(m, false) &&
        marks_earned(m, true) < hidden) {
        char *text =
            compose("passes what is public, but %d of %d hidden points",
                    marks_earned(m, true), hidden);
        take(to, who, what, text);
        free(text);
    }
}

static void tell_all(const struct course *c, take_line *take, void *to)
{
    for (size_t s = 0; s <= c->students; ++s)
        tell_notes(c, s, take, to);
    for (size_t i = 0; i < c->students * c->exercises; ++i)
        tell_marks(&c->marks[i], take, to);
}

static void put_note(void *to, const char *student, const char *exercise,
                     const char *text)
{
    fprintf(to, "%s  %s  %s\n", student, exercise, text);
}

static void count_note(void *to, const char *student, const char *exercise,
                       const char *text)
{
    (void)student, (void)exercise, (void)text;
    ++*(size_t *)to;
}

static void report_notes(const struct course *c, const char *folder)
{
    char below[4096];
    struct draft draft;
    size_t count = 0;
    tell_all(c, count_note, &count);
    snprintf(below, sizeof below, "%s/by-hand", folder);
    if (count == 0) {
        draft_remove(below, "notes.txt");
        return;
    }
    make_folder(folder);
    make_folder(below);
    draft_open(&draft, below, "notes.txt", true);
    tell_all(c, put_note, draft.file);
    draft_close(&draft);
}

static void join_note(void *to, const char *student, const char *exercise,
                      const char *text)
{
    (void)student;
    const char *between = ftell(to) > 0 ? "; " : "";
    if (strcmp(exercise, "-") == 0)
        fprintf(to, "%s%s", between, text);
    else
        fprintf(to, "%s%s: %s", between, exercise, text);
}

static void put_notes(FILE *out, const struct course *c, size_t s)
{
    char *text = NULL;
    FILE *notes = text_stream(&text, NULL);
    tell_notes(c, s, join_note, notes);
    for (size_t e = 0; e < c->exercises; ++e)
        tell_marks(marks_of(c, s, e), join_note, notes);
    if (fclose(notes) != 0)
        text_fail("out of memory");
    putc(',', out);
    put_cell(out, text);
    fputs("\r\n", out);
    free(text);
}

static void put_row(FILE *out, const struct course *c, size_t s)
{
    put_cell(out, marks_of(c, s, 0)->student);
    for (size_t e = 0; e < c->exercises; ++e)
        if (lost(marks_of(c, s, e)))
            fputs(",", out);
        else
            fprintf(out, ",%d", earned(marks_of(c, s, e)));
    if (complete(c, s))
        fprintf(out, ",%d,%d", earned_of_all(c, s), possible_of_all(c));
    else
        fprintf(out, ",,%d", possible_of_all(c));
    put_notes(out, c, s);
}

/* Writes the marks as comma-separated values (RFC 4180), in UTF-8 without a
   byte-order mark: programs that follow the standard would read it as part
   of the first column's name. Numbers have no quotes. The cell of an
   exercise that was not graded is empty. */
static void report_csv(const struct course *c, const char *folder)
{
    struct draft draft;
    make_folder(folder);
    draft_open(&draft, folder, "grades.csv", true);
    put_cell(draft.file, "student");
    for (size_t e = 0; e < c->exercises; ++e) {
        putc(',', draft.file);
        put_cell(draft.file, marks_of(c, 0, e)->exercise);
    }
    fputs(",\"total\",\"possible\",\"note\"\r\n"
          "\"points possible\"",
          draft.file);
    for (size_t e = 0; e < c->exercises; ++e)
        fprintf(draft.file, ",%d", possible(c, e));
    fprintf(draft.file, ",%d,%d,\"\"\r\n", possible_of_all(c),
            possible_of_all(c));
    for (size_t s = 0; s < c->students; ++s)
        put_row(draft.file, c, s);
    draft_close(&draft);
}

/* Adds a member to a JSON object, or exits. jansson fails if memory runs
   out or if a text is not UTF-8. */
static void put(json_t *object, const char *key, json_t *value)
{
    if (json_object_set_new(object, key, value) != 0)
        text_fail("out of memory");
}

static void add(json_t *array, json_t *value)
{
    if (json_array_append_new(array, value) != 0)
        text_fail("out of memory");
}

static json_t *take(char *text)
{
    json_t *value = json_string(text);
    free(text);
    return value;
}

/* Writes JSON to a file. Without JSON_REAL_PRECISION, 0.1 would be written
   with 17 digits. */
static void write_tree(const char *folder, const char *name, json_t *json)
{
    struct draft draft;
    draft_open(&draft, folder, name, false);
    if (json_dumpf(json, draft.file,
                   JSON_INDENT(2) | JSON_REAL_PRECISION(6)) != 0)
        give_up(&draft);
    draft_close(&draft);
    json_decref(json);
}

/* Writes one JSON file for each student whose exercises were all graded.
   Somebody will ask for a missing file, but nobody would notice too few
   points. */
static void write_json(const struct course *c, const char *folder,
                       const char *kind,
                       json_t *build(const struct course *, size_t))
{
    char below[4096];
    make_folder(folder);
    snprintf(below, sizeof below, "%s/%s", folder, kind);
    make_folder(below);
    for (size_t s = 0; s < c->students; ++s) {
        char *name = file_name(c, s);
        if (complete(c, s))
            write_tree(below, name, build(c, s));
        else
            draft_remove(below, name);
        free(name);
    }
}

static json_t *gradescope_test(const struct marks *m, size_t e, int test)
{
    const struct mark *mark = &m->marks[test];
    const bool passed = mark->state == PASSED;
    char room[32];
    json_t *json = json_object(), *tags = json_array();
    put(json, "name",
        take(compose("%s: %s", m->exercise, shown_name(m, test, room))));
    put(json, "number", take(compose("%zu.%d", e + 1, test + 1)));
    put(json, "score", json_integer(passed ? mark->points : 0));
    put(json, "max_score", json_integer(mark->points));
    put(json, "status", json_string(passed ? "passed" : "failed"));
    put(json, "visibility",
        json_string(mark->hidden ? "hidden" : "visible"));
    add(tags, take(compose("%s", m->exercise)));
    put(json, "tags", tags);
    if (!mark->hidden && !passed)
        put(json, "output", take(compose("%s", shown_story(m, test))));
    return json;
}

static void sum_up_one(FILE *out, const struct marks *m)
{
    fprintf(out, "%s %s: %s, %d of %d points\n", m->exercise, m->title,
            state_name(shown_state(m)), marks_earned(m, false),
            marks_possible(m, false));
}

static bool graded(const struct marks *m)
{
    return !lost(m) && strcmp(m->file, "no file") != 0;
}

/* Writes the note, the compiler's messages and the sanitizers' advice.
   Sanitizers run with public tests only, so they reveal nothing hidden. */
static void tell_rest(FILE *out, const struct marks *m)
{
    if (*m->note)
        fprintf(out, "\n%s: %s\n", m->exercise, m->note);
    if (*m->story)
        fprintf(out, "\n%s does not build:\n%s\n", m->exercise, m->story);
    if (*m->advice)
        fprintf(out, "\n%s, advice that changes no points:\n%s\n",
                m->exercise, m->advice);
}

static json_t *sum_up(const struct course *c, size_t s)
{
    char *text = NULL;
    int hidden = 0;
    FILE *out = text_stream(&text, NULL);
    for (size_t e = 0; e < c->exercises; ++e) {
        sum_up_one(out, marks_of(c, s, e));
        hidden += marks_possible(marks_of(c, s, e), true);
    }
    if (hidden > 0)
        fprintf(out, "Hidden checks earn up to %d more points.\n", hidden);
    for (size_t e = 0; e < c->exercises; ++e)
        tell_rest(out, marks_of(c, s, e));
    if (*c->notes[s])
        fprintf(out, "\nAlso handed in:\n%s", c->notes[s]);
    if (fclose(out) != 0)
        text_fail("out of memory");
    json_t *json = take(compose("%s", text));
    free(text);
    return json;
}

/* Returns the field extra_data, which says how the marks were made.
   Gradescope stores it but does not show it. */
static json_t *gradescope_extra(const struct course *c, size_t s)
{
    json_t *json = json_object();
    put(json, "student", take(compose("%s", marks_of(c, s, 0)->student)));
    put(json, "course", take(compose("%s", c->name)));
    put(json, "graded_at", take(compose("%s", c->when)));
    put(json, "isolation", take(compose("%s", c->isolation)));
    put(json, "possible", json_integer(possible_of_all(c)));
    return json;
}

/* Returns a student's results for Gradescope. Output is declared as plain
   text, since Gradescope may otherwise read it as HTML. stdout_visibility
   hides what this program prints. */
static json_t *gradescope(const struct course *c, size_t s)
{
    json_t *json = json_object(), *tests = json_array();
    put(json, "score", json_integer(earned_of_all(c, s)));
    put(json, "execution_time", json_real(seconds_of_all(c, s)));
    put(json, "output", sum_up(c, s));
    put(json, "output_format", json_string("text"));
    put(json, "test_output_format", json_string("text"));
    put(json, "test_name_format", json_string("text"));
    put(json, "visibility", json_string("visible"));
    put(json, "stdout_visibility", json_string("hidden"));
    for (size_t e = 0; e < c->exercises; ++e)
        for (int i = 0; i < marks_of(c, s, e)->count; ++i)
            add(tests, gradescope_test(marks_of(c, s, e), e, i));
    put(json, "tests", tests);
    put(json, "extra_data", gradescope_extra(c, s));
    return json;
}

enum { CLASSROOM_NAME = 100, CLASSROOM_OUTPUT = 4000 };

/* Returns a test for Classroom 50. Its schema requires unique names of at
   most 100 bytes; our names begin with the exercise and the test's number.
   Its collector refuses files above 10 MiB, so reports on tests are cut. */
static json_t *classroom_test(const struct marks *m, int test)
{
    const struct mark *mark = &m->marks[test];
    const bool passed = mark->state == PASSED;
    char room[32];
    json_t *json = json_object();
    char *name = compose("%s.%d %s", m->exercise, test + 1,
                         shown_name(m, test, room));
    put(json, "test-name", take(shorten(name, CLASSROOM_NAME)));
    put(json, "passed", json_boolean(passed));
    put(json, "score", json_integer(passed ? mark->points : 0));
    put(json, "max-score", json_integer(mark->points));
    if (!mark->hidden && !passed)
        put(json, "output",
            take(shorten(compose("%s", shown_story(m, test)),
                         CLASSROOM_OUTPUT)));
    return json;
}

/* Returns the value of an environment variable, or `otherwise` if it is not
   set. Classroom 50 sets these variables, which identify the student and
   the task. If they are missing, its collector refuses the file until
   somebody fills in the values. */
static json_t *known(const struct course *c, const char *variable,
                     const char *otherwise)
{
    const char *value = c->students == 1 ? getenv(variable) : NULL;
    if (!value || !*value)
        value = *otherwise ? otherwise : "unknown";
    return take(compose("%s", value));
}

static json_t *classroom_tag(const struct course *c)
{
    char *tag = compose("submit/%s", c->when);
    for (char *colon = tag; (colon = strchr(colon, ':'));)
        *colon = '-';
    json_t *json = known(c, "SUBMISSION_TAG", tag);
    free(tag);
    return json;
}

static void put_owner(json_t *json, const struct course *c, size_t s)
{
    put(json, "schema", json_string("classroom50/result/v1"));
    put(json, "classroom", known(c, "CLASSROOM", c->name));
    put(json, "assignment", known(c, "ASSIGNMENT", "bonkers"));
    put(json, "assignment_type", known(c, "ASSIGNMENT_TYPE", "individual"));
    put(json, "owner", known(c, "OWNER", marks_of(c, s, 0)->student));
    put(json, "submission", classroom_tag(c));
    put(json, "commit", known(c, "COMMIT_URL", "unknown"));
    put(json, "release", known(c, "RELEASE_URL", "unknown"));
    put(json, "review", known(c, "REVIEW_URL", "unknown"));
    put(json, "datetime", take(compose("%s", c->when)));
    put(json, "graded_at", take(compose("%s", c->when)));
}

/* Returns a student's result for Classroom 50. datetime should be the time
   when the work was handed in, which decides whether it is late. Only the
   time of grading is known here; the collector's own runner corrects it. */
static json_t *classroom(const struct course *c, size_t s)
{
    json_t *json = json_object(), *tests = json_array();
    int most = 0;
    put_owner(json, c, s);
    for (size_t e = 0; e < c->exercises; ++e)
        for (int i = 0; i < marks_of(c, s, e)->count; ++i) {
            add(tests, classroom_test(marks_of(c, s, e), i));
            most += marks_of(c, s, e)->marks[i].points;
        }
    put(json, "score", json_integer(earned_of_all(c, s)));
    put(json, "max-score", json_integer(most));
    put(json, "tests", tests);
    return json;
}

/* Returns a test for GitHub Classroom. A test without a verdict has the
   status error, not fail. */
static json_t *github_test(const struct marks *m, int test)
{
    const struct mark *mark = &m->marks[test];
    const bool passed = mark->state == PASSED;
    const bool answered = passed || mark->state == FAILED;
    char room[32];
    json_t *json = json_object();
    put(json, "name",
        take(compose("%s.%d %s", m->exercise, test + 1,
                     shown_name(m, test, room))));
    put(json, "status",
        json_string(passed     ? "pass"
                    : answered ? "fail"
                               : "error"));
    put(json, "score", json_integer(passed ? mark->points : 0));
    put(json, "message",
        take(compose("%s", passed ? "" : shown_story(m, test))));
    put(json, "test_code", json_string(""));
    put(json, "filename", take(compose("%s", graded(m) ? m->file : "")));
    put(json, "line_no", json_integer(0));
    put(json, "execution_time", take(compose("%.3fs", mark->seconds)));
    return json;
}

/* Returns a student's result for GitHub Classroom. A workflow that has run
   the grader passes the file on in base64: echo "result=$(base64 -w0
   github/ADA.json)" >>"$GITHUB_OUTPUT". */
static json_t *github(const struct course *c, size_t s)
{
    json_t *json = json_object(), *tests = json_array();
    int most = 0;
    for (size_t e = 0; e < c->exercises; ++e)
        for (int i = 0; i < marks_of(c, s, e)->count; ++i) {
            add(tests, github_test(marks_of(c, s, e), i));
            most += marks_of(c, s, e)->marks[i].points;
        }
    put(json, "version", json_integer(1));
    put(json, "status",
        json_string(earned_of_all(c, s) == most ? "pass" : "fail"));
    put(json, "max_score", json_integer(most));
    put(json, "tests", tests);
    return json;
}

/* A report in JUnit's XML format while it is being written. The format has
   no standard; GitLab and Jenkins must be able to read the report. GitLab
   drops the second of two cases with the same class and name, so the name
   of a case contains the student and the test's number. */
struct junit {
    struct draft draft;
    xmlTextWriterPtr xml;
};

static void checked(int result)
{
    if (result < 0)
        text_fail("out of memory");
}

/* Writes bytes for libxml2. Always reports success; otherwise libxml2 would
   print messages of its own. draft_close finds errors with ferror. */
static int write_bytes(void *context, const char *bytes, int length)
{
    struct junit *j = context;
    fwrite(bytes, 1, (size_t)length, j->draft.file);
    return length;
}

static void junit_open(struct junit *j, const char *folder)
{
    make_folder(folder);
    draft_open(&j->draft, folder, "junit.xml", false);
    xmlOutputBufferPtr out =
        xmlOutputBufferCreateIO(write_bytes, NULL, j, NULL);
    j->xml = text_must(out ? xmlNewTextWriter(out) : NULL);
    xmlTextWriterSetIndent(j->xml, 1);
    checked(xmlTextWriterStartDocument(j->xml, NULL, "UTF-8", NULL));
}

static void begin(struct junit *j, const char *element)
{
    checked(xmlTextWriterStartElement(j->xml, BAD_CAST element));
}

static void end(struct junit *j)
{
    checked(xmlTextWriterEndElement(j->xml));
}

static void attribute(struct junit *j, const char *name, char *value)
{
    checked(
        xmlTextWriterWriteAttribute(j->xml, BAD_CAST name, BAD_CAST value));
    free(value);
}

static void content(struct junit *j, char *text)
{
    checked(xmlTextWriterWriteString(j->xml, BAD_CAST text));
    free(text);
}

struct tally {
    int tests, failures, errors, skipped;
    double seconds;
};

/* Returns the JUnit element of a state. A wrong number is a failure. A
   crash, a time-out and a file that does not build are errors, because the
   test came to no verdict. A test that is not begun is skipped. */
static const char *element_of(enum state state)
{
    switch (state) {
    case PASSED: return NULL;
    case NOT_BEGUN: return "skipped";
    case FAILED: return "failure";
    default: return "error";
    }
}

static void count_endings(struct tally *tally, const struct marks *m)
{
    for (int i = 0; i < m->count; ++i) {
        const char *element = element_of(state_of(m, i));
        ++tally->tests;
        tally->failures += element && *element == 'f';
        tally->errors += element && *element == 'e';
        tally->skipped += element && *element == 's';
    }
    tally->tests += lost(m);
    tally->errors += lost(m);
    tally->seconds += m->seconds;
}

static void put_tally(struct junit *j, const struct tally *tally)
{
    attribute(j, "tests", compose("%d", tally->tests));
    attribute(j, "failures", compose("%d", tally->failures));
    attribute(j, "errors", compose("%d", tally->errors));
    attribute(j, "skipped", compose("%d", tally->skipped));
    attribute(j, "time", compose("%.3f", tally->seconds));
}

/* Writes how a test ended. If the file does not build, the first test gets
   the compiler's messages, even if that test is hidden, since the messages
   are only about the student's file. */
static void put_ending(struct junit *j, const char *element,
                       const struct marks *m, int test)
{
    const enum state state = state_of(m, test);
    const bool compiler = state == DOES_NOT_BUILD && test == 0 && *m->story;
    begin(j, element);
    attribute(j, "message", compose("%s", state_name(state)));
    content(j, compose("%s", compiler ? m->story : shown_story(m, test)));
    end(j);
}

static void put_case(struct junit *j, const char *student,
                     const struct marks *m, int test)
{
    char room[32];
    const char *element = element_of(state_of(m, test));
    begin(j, "testcase");
    attribute(j, "classname", compose("%s", m->exercise));
    attribute(j, "name",
              compose("%s, test %d: %s", student, test + 1,
                      shown_name(m, test, room)));
    if (graded(m))
        attribute(j, "file", compose("%s", m->file));
    attribute(j, "time", compose("%.3f", m->marks[test].seconds));
    if (element)
        put_ending(j, element, m, test);
    end(j);
}

/* Writes an exercise that was not graded as one test with an error, because
   a suite without tests would count as passed. */
static void put_lost(struct junit *j, const char *student,
                     const struct marks *m)
{
    begin(j, "testcase");
    attribute(j, "classname", compose("%s", m->exercise));
    attribute(j, "name", compose("%s, not graded", student));
    attribute(j, "time", compose("0"));
    begin(j, "error");
    attribute(j, "message", compose("not graded"));
    content(j, compose("%s", m->file));
    end(j);
    end(j);
}

static void put_suite(struct junit *j, const struct course *c, size_t s,
                      const struct marks *m)
{
    struct tally tally = {0};
    char *student = alone(c, s) ? compose("%s", m->student)
                                : compose("%s (%zu)", m->student, s + 1);
    count_endings(&tally, m);
    begin(j, "testsuite");
    attribute(j, "name",
              compose("%s: %s %s", student, m->exercise, m->title));
    put_tally(j, &tally);
    attribute(j, "timestamp", compose("%s", c->when));
    for (int i = 0; i < m->count; ++i)
        put_case(j, student, m, i);
    if (lost(m))
        put_lost(j, student, m);
    if (*m->advice) {
        begin(j, "system-err");
        content(j, compose("%s", m->advice));
        end(j);
    }
    end(j);
    free(student);
}

static void report_junit(const struct course *c, const char *folder)
{
    struct junit j;
    struct tally all = {0};
    const size_t count = c->students * c->exercises;
    for (size_t i = 0; i < count; ++i)
        count_endings(&all, &c->marks[i]);
    junit_open(&j, folder);
    begin(&j, "testsuites");
    attribute(&j, "name", compose("%s", c->name));
    put_tally(&j, &all);
    for (size_t i = 0; i < count; ++i)
        put_suite(&j, c, i / c->exercises, &c->marks[i]);
    checked(xmlTextWriterEndDocument(j.xml));
    xmlFreeTextWriter(j.xml);
    draft_close(&j.draft);
}

/* Returns how many columns the next character takes: two for a Chinese
   character, none for a combining accent. wcwidth needs a UTF-8 locale for
   this. Returns -1 if a question mark should replace the character: because
   it is unknown, or because it changes the direction of writing, which
   would also affect the numbers after a name. */
static int columns(const char *text, size_t *bytes)
{
    mbstate_t state = {0};
    wchar_t c;
    *bytes = mbrtowc(&c, text, strnlen(text, 6), &state);
    if (*bytes == 0 || *bytes > 6) {
        *bytes = 1;
        return -1;
    }
    const bool turns = (c >= 0x200e && c <= 0x200f) || c == 0x61c ||
                       (c >= 0x202a && c <= 0x202e) ||
                       (c >= 0x2066 && c <= 0x2069);
    return turns ? -1 : wcwidth(c);
}

/* Returns how many of `room` columns a text fills, and sets *length to the
   number of bytes in them. The number of bytes is limited as well: a letter
   with ten thousand accents is one column wide. */
static int fit(const char *text, int room, size_t *length)
{
    int taken = 0;
    *length = 0;
    while (text[*length] && *length < 4 * (size_t)room) {
        size_t bytes;
        const int width = columns(text + *length, &bytes);
        if (taken + abs(width) > room)
            break;
        taken += abs(width);
        *length += bytes;
    }
    return taken;
}

static int show(const char *text, int room)
{
    size_t length, bytes;
    int taken = fit(text, room, &length);
    const bool cut = text[length] != '\0';
    if (cut)
        taken = fit(text, room - 1, &length) + 1;
    for (size_t i = 0; i < length; i += bytes)
        if (columns(text + i, &bytes) < 0)
            putchar('?');
        else
            fwrite(text + i, 1, bytes, stdout);
    if (cut)
        putchar('~');
    return taken;
}

static void show_filled(const char *text, int room)
{
    const int taken = show(text, room);
    printf("%*s", room - taken, "");
}

struct layout {
    int name, cell;
    size_t block;
};

static struct layout lay_out(const struct course *c)
{
    struct layout l = {8, 3, 0};
    size_t length;
    for (size_t s = 0; s < c->students; ++s) {
        const int width = fit(marks_of(c, s, 0)->student, 20, &length);
        l.name = width > l.name ? width : l.name;
    }
    for (size_t e = 0; e < c->exercises; ++e) {
        const int name = (int)strlen(marks_of(c, 0, e)->exercise);
        const int points = snprintf(NULL, 0, " %d", possible(c, e));
        l.cell = name > l.cell ? name : l.cell;
        l.cell = points > l.cell ? points : l.cell;
    }
    const size_t fitting =
        (size_t)((TEXT_WIDTH - l.name - 8) / (l.cell + 1));
    const size_t blocks = (c->exercises + fitting - 1) / fitting;
    l.block = blocks > 0 ? (c->exercises + blocks - 1) / blocks : 1;
    return l;
}

/* Prints a cell of the table: the points or, if they are 0, a letter for
   the state. A column of zeros would be harder to read. */
static void show_earned(const struct marks *m, int width)
{
    static const char letters[] = {
        [NOT_BEGUN] = '-', [DOES_NOT_BUILD] = 'b', [FAILED] = ' ',
        [CRASHED] = 'c',   [TIMED_OUT] = 't',      [PASSED] = ' '};
    const char letter = lost(m) ? '?' : letters[m->state];
    if (earned(m) == 0 && letter != ' ')
        printf("%*c ", width, letter);
    else
        printf("%*d%c", width, earned(m), letter);
}

static void show_head(const struct course *c, const struct layout *l,
                      size_t from, size_t to)
{
    printf("%*s  total ", l->name, "");
    for (size_t e = from; e < to; ++e)
        printf("%*s ", l->cell, marks_of(c, 0, e)->exercise);
    printf("\n%-*s  %5d ", l->name, "possible", possible_of_all(c));
    for (size_t e = from; e < to; ++e)
        printf("%*d ", l->cell, possible(c, e));
    putchar('\n');
}

static void show_block(const struct course *c, const struct layout *l,
                       size_t from)
{
    const size_t to =
        from + l->block < c->exercises ? from + l->block : c->exercises;
    show_head(c, l, from, to);
    for (size_t s = 0; s < c->students; ++s) {
        show_filled(marks_of(c, s, 0)->student, l->name);
        if (complete(c, s))
            printf("  %5d ", earned_of_all(c, s));
        else
            printf("  %5s ", "?");
        for (size_t e = from; e < to; ++e)
            show_earned(marks_of(c, s, e), l->cell);
        putchar('\n');
    }
    putchar('\n');
}

struct screen {
    const struct layout *layout;
    bool any; /* a note was printed */
};

/* Prints a note for the lecturer, on as many lines as needed. */
static void show_line(void *to, const char *student, const char *exercise,
                      const char *text)
{
    struct screen *screen = to;
    const struct layout *l = screen->layout;
    const int indent = l->name + 6 + (int)strlen(exercise);
    const size_t room =
        TEXT_WIDTH - indent < 20 ? 20 : (size_t)(TEXT_WIDTH - indent);
    if (!screen->any)
        puts("For a human eye:");
    screen->any = true;
    fputs("  ", stdout);
    show_filled(student, l->name);
    printf("  %s  ", exercise);
    for (const char *rest = text; *rest;) {
        size_t length = text_fold(rest, room);
        if (length > room)
            for (length = room;
                 length > 1 && (rest[length] & 0xc0) == 0x80;)
                --length;
        char *piece = compose("%.*s", (int)length, rest);
        if (rest > text)
            printf("%*s", indent, "");
        show(piece, (int)room);
        putchar('\n');
        free(piece);
        rest += length;
        rest += strspn(rest, " ");
    }
    if (!*text)
        putchar('\n');
}

/* Prints the whole table, with the kind of isolation in its first line. No
   other function changes the locale. */
static void report_table(const struct course *c, const char *folder)
{
    const locale_t utf8 = newlocale(LC_CTYPE_MASK, "C.UTF-8", (locale_t)0);
    const locale_t before = uselocale(utf8);
    const struct layout l = lay_out(c);
    struct screen screen = {&l, false};
    (void)folder;
    char *head =
        compose("%s, %s, isolation: %s", c->name, c->when, c->isolation);
    show(head, TEXT_WIDTH);
    fputs("\n\n", stdout);
    free(head);
    for (size_t e = 0; e < c->exercises; e += l.block)
        show_block(c, &l, e);
    puts("-: not begun  b: does not build  c: crashed  t: timed out  "
         "?: not graded");
    tell_all(c, show_line, &screen);
    uselocale(before);
    if (utf8)
        freelocale(utf8);
    if (fflush(stdout) != 0 || ferror(stdout))
        text_fail("cannot write the table: %s", strerror(errno));
}

/* The reports. If `write` is not NULL, it writes the report; otherwise
   `build` returns the content of one student's JSON file. */
static const struct {
    const char *name;
    void (*write)(const struct course *course, const char *folder);
    json_t *(*build)(const struct course *course, size_t student);
} reports[] = {
    {"table", report_table, NULL},    {"csv", report_csv, NULL},
    {"notes", report_notes, NULL},    {"gradescope", NULL, gradescope},
    {"classroom50", NULL, classroom}, {"github", NULL, github},
    {"junit", report_junit, NULL}};

const char publish_names[] = "gradescope, classroom50, github, junit";

enum { REPORTS = sizeof reports / sizeof reports[0], ALWAYS = 3 };

static size_t find_report(const char *name)
{
    size_t i = 0;
    while (i < REPORTS && strcmp(reports[i].name, name) != 0)
        ++i;
    return i;
}

bool publish_known(const char *report)
{
    const size_t i = find_report(report);
    return i >= ALWAYS && i < REPORTS;
}

void publish(const char *report, const struct course *course,
             const char *folder)
{
    const size_t i = find_report(report);
    if (i == REPORTS)
        text_fail("there is no report '%s'; there are table, csv, %s",
                  report, publish_names);
    if (reports[i].build)
        write_json(course, folder, report, reports[i].build);
    else
        reports[i].write(course, folder);
}
