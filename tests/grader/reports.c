/* Publishes a course that is made up here, so that the reports can be
   tested without grading anybody.

       reports COURSE REPORT FOLDER   publishes it
       reports COURSE --names FOLDER  writes FOLDER/names, its students'
   names as text, each ended by a NUL

   COURSE: plain, a few students and exercises; strange, with all that a
   name, a story and a compiler's message may hold; many, 40 students and 30
   exercises; one, a single student; lost, the plain one, but Bjoern's
   second exercise was not graded. What is hidden has the word SECRET in it,
   what may be shown the word PUBLIC. */
#include "examiner/publish.h"
#include "examiner/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PUBLIC = 4, HIDDEN = 2, LONG = 1 << 20, SHORT = 6000 };

/* How an exercise went. */
enum kind {
    ALL_PASS,
    HIDDEN_FAIL,
    SECOND_FAILS,
    UNBUILT,
    THIRD_CRASHES,
    FOURTH_LATE,
    UNTOUCHED,
    REFUSED,
    ADVISED,
    KINDS
};

struct name {
    const char *bytes;
    size_t length; /* 0: up to the first NUL */
};

static const struct name plain[] = {
    {"Ada", 0}, {"Bj\xc3\xb6rn", 0}, {"Grace", 0}, {"Zoe", 0}};

/* As long as a file's name may be, where its letters are spelled alike. */
#define FORTY "a long name, with ten words; to be spelt"
#define LONG_NAME FORTY FORTY FORTY FORTY "and some more, before "

/* The names of a folder may be any bytes but NUL and the slash; marks_text
   has been there before us, but a slash costs nothing. */
static const struct name strange[] = {
    {"", 0},
    {"\tbegins with a tab", 0},
    {"\nbegins with a line break", 0},
    {"+1+1", 0},
    {"-rf *", 0},
    {"..", 0},
    {"=HYPERLINK(\"http://example.org\",\"Ada\")", 0},
    {"@SUM(A1)", 0},
    {"]]><evil attribute='1'/>", 0},
    {"a,b;c\"d\"\"e", 0},
    {"a/../../b", 0},
    {"accents e\xcc\x81\xcc\x81\xcc\x81\xcc\x81\xcc\x81\xcc\x81\xcc\x81",
     0},
    {"ampersand & <tag> 'quotes' \"double\" &amp; %41", 0},
    {"backslash \\x41 \\", 0},
    {"\xce\x94\xce\xb5\xce\xbb\xcf\x84\xce\xb1", 0},
    {"\xe2\x80\xae"
     "turned round",
     0},
    {"\xe6\x97\xa5\xe6\x9c\xac\xe8\xaa\x9e\xe3\x81\xae\xe5\x90\x8d\xe5\x89"
     "\x8d\xe3\x81\xaf\xe9\x95\xb7\xe3\x81\x84",
     0},
    {"\xef\xbc\x9d"
     "1+1",
     0},
    {"bell \x07 escape \x1b[31m delete \x7f c1 \xc2\x9b"
     "31m",
     0},
    {"bytes \xff\xfe overlong \xc0\xaf surrogate \xed\xa0\x80 end \xf0\x9f",
     0},
    {"emoji \xf0\x9f\x8e\xb1", 0},
    {"line\nbreak", 0},
    {LONG_NAME "one", 0},
    {LONG_NAME "two", 0},
    {"nul \0 byte", 10},
    {"twin", 0},
    {"twin", 0},
    {"not a character \xef\xbf\xbe\xef\xbf\xbf", 0},
    {"\xd7\xa2\xd7\x93\xd7\x94 right to left", 0},
};

static char *copy(const char *text)
{
    char *made = strdup(text);
    if (!made)
        text_fail("out of memory");
    return made;
}

static char *text_of(struct name name)
{
    const size_t length = name.length ? name.length : strlen(name.bytes);
    return marks_text(name.bytes, length, 200);
}

/* A story as a student's program could make it, of any bytes. */
static char *strange_story(size_t length)
{
    static const char bytes[] =
        "PUBLIC ]]> \x1b[1m & < > \" ' \r\n\xff\xfe \xc3\xa4 ]]&gt; \\";
    char *raw = malloc(length);
    if (!raw)
        text_fail("out of memory");
    for (size_t i = 0; i < length; ++i)
        raw[i] = i < 256 ? (char)i : bytes[i % (sizeof bytes - 1)];
    memcpy(raw + length - 6, "PUBEND", 6);
    char *text = marks_text(raw, length, length);
    free(raw);
    return text;
}

static enum state state_of(enum kind kind, int test)
{
    switch (kind) {
    case HIDDEN_FAIL: return test == 5 ? FAILED : PASSED;
    case SECOND_FAILS: return test == 1 ? FAILED : PASSED;
    case THIRD_CRASHES: return test == 2 ? CRASHED : PASSED;
    case FOURTH_LATE: return test == 3 ? TIMED_OUT : PASSED;
    case UNBUILT:
    case UNTOUCHED:
    case REFUSED: return NOT_BEGUN;
    default: return PASSED;
    }
}

/* Test names: one twice, one longer than any report takes, with a character
   of two bytes across each even place or each odd one. */
static char *test_name(int test, bool odd)
{
    char name[300] = "PUBLIC ]]> & \"momentum\" is conserved";
    if (test == 2)
        for (size_t i = odd; i + 3 < sizeof name; i += 2)
            memcpy(name + i, "\xc3\xa4", 3);
    if (test == 3)
        name[0] = '\0';
    return copy(name);
}

static void fill_tests(struct marks *m, enum kind kind, size_t wild)
{
    m->count = PUBLIC + HIDDEN;
    for (int i = 0; i < m->count; ++i) {
        const bool hidden = i >= PUBLIC;
        const enum state state = state_of(kind, i);
        const bool told = state != PASSED && state != NOT_BEGUN;
        m->marks[i] = (struct mark){
            .name = hidden ? copy("SECRET wall at 7.25")
                           : test_name(i, m->exercise[2] == 'b'),
            .hidden = hidden,
            .points = i + 1,
            .seconds = 0.01 * (i + 1),
            .state = state,
            .story = hidden ? copy("SECRET u1 = 7.25, seed 271828")
                     : told ? (wild ? strange_story(wild)
                                    : copy("PUBLIC u1 = 1 m/s"))
                            : copy("")};
        if (state != PASSED && m->state == PASSED)
            m->state = state;
    }
}

static struct marks exercise_of(const char *student, size_t e,
                                enum kind kind, size_t wild)
{
    static const char *const files[KINDS] = {
        [UNTOUCHED] = "no file", [REFUSED] = "no file"};
    char exercise[8], file[32];
    struct marks m = {.state = PASSED, .seconds = 0.125 + (double)e};
    snprintf(exercise, sizeof exercise, "%02u%c",
             (unsigned)(e / 4 % 90 + 1), (int)('a' + e % 4));
    snprintf(file, sizeof file, "%s-file.c", exercise);
    m.student = copy(student);
    m.exercise = copy(exercise);
    m.title = copy(wild ? "Titles & <such> ]]> \"x\"" : "A title");
    m.file = copy(files[kind] ? files[kind] : file);
    m.note = copy(
        kind == REFUSED ? "refused, since it is no regular file: x.c" : "");
    m.tries = kind == FOURTH_LATE ? 2 : 1;
    m.prints = copy("SECRET u1 = 7.25");
    m.story = kind != UNBUILT ? copy("")
              : wild          ? strange_story(wild)
                              : copy("PUBLIC error: expected ';'");
    m.advice =
        kind != ADVISED ? copy("")
        : wild          ? strange_story(wild)
               : copy("  what       PUBLIC heap-buffer-overflow\nline 3");
    fill_tests(&m, kind, wild);
    if (kind == UNBUILT)
        m.state = DOES_NOT_BUILD;
    return m;
}

/* Names for a class of 40: of all lengths, and some alike for long. */
static char *made_name(size_t s)
{
    char name[80];
    snprintf(name, sizeof name, "student-%.*s%02zu", (int)(s % 30),
             "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", s);
    return copy(name);
}

static char *student_of(const char *course, size_t s)
{
    if (strcmp(course, "strange") == 0)
        return text_of(strange[s]);
    return strcmp(course, "many") == 0 ? made_name(s) : text_of(plain[s]);
}

/* What the grader leaves of an exercise when it has failed itself. */
static void lose(struct marks *m)
{
    struct marks rest = {.student = copy(m->student),
                         .exercise = copy(m->exercise),
                         .title = copy(m->title),
                         .file = copy("NOT GRADED: the grader failed"),
                         .note = copy(""),
                         .story = copy(""),
                         .prints = copy(""),
                         .advice = copy("")};
    marks_free(m);
    *m = rest;
}

static void fill(struct course *c, const char *course)
{
    const bool wild = strcmp(course, "strange") == 0;
    struct marks *marks = calloc(c->students * c->exercises, sizeof *marks);
    if (!marks)
        text_fail("out of memory");
    for (size_t s = 0; s < c->students; ++s) {
        char *name = student_of(course, s);
        for (size_t e = 0; e < c->exercises; ++e) {
            const enum kind kind = (enum kind)((s + e) % KINDS);
            const bool most =
                s == 3 && (kind == SECOND_FAILS || kind == UNBUILT);
            const size_t story = most ? LONG : SHORT;
            marks[s * c->exercises + e] =
                exercise_of(name, e, kind, wild ? story : 0);
        }
        free(name);
    }
    if (strcmp(course, "lost") == 0)
        lose(&marks[c->exercises + 1]);
    c->marks = marks;
    const char **notes = calloc(c->students + 1, sizeof *notes);
    if (!notes)
        text_fail("out of memory");
    for (size_t s = 0; s <= c->students; ++s)
        notes[s] = s == 1 ? "an archive that is not unpacked: work.zip\n"
                   : s == c->students ? "of no student: x.pdf\n"
                                      : "";
    c->notes = notes;
}

static void write_names(const struct course *c, const char *folder)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/names", folder);
    FILE *out = fopen(path, "w");
    if (!out)
        text_fail("cannot write '%s'", path);
    for (size_t s = 0; s < c->students; ++s) {
        const char *name = c->marks[s * c->exercises].student;
        fwrite(name, 1, strlen(name) + 1, out);
    }
    fclose(out);
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        size_t students, exercises;
    } courses[] = {
        {"plain", sizeof plain / sizeof plain[0], KINDS},
        {"strange", sizeof strange / sizeof strange[0], KINDS},
        {"many", 40, 30},
        {"one", 1, KINDS},
        {"lost", sizeof plain / sizeof plain[0], KINDS},
    };
    struct course c = {.isolation = "none & <loud>",
                       .when = "2026-10-05T09:30:00Z"};
    text_program = "reports";
    for (size_t i = 0; argc == 4 && i < sizeof courses / sizeof courses[0];
         ++i)
        if (strcmp(courses[i].name, argv[1]) == 0) {
            c.students = courses[i].students;
            c.exercises = courses[i].exercises;
        }
    if (c.students == 0)
        text_fail(
            "usage: reports plain|strange|many|one|lost REPORT FOLDER");
    c.name = strcmp(argv[1], "strange") == 0 ? "au\xfftumn ]]>\n\x1b[2J \"&"
                                             : "autumn";
    fill(&c, argv[1]);
    if (strcmp(argv[2], "--names") == 0)
        write_names(&c, argv[3]);
    else
        publish(argv[2], &c, argv[3]);
    for (size_t i = 0; i < c.students * c.exercises; ++i)
        marks_free((struct marks *)&c.marks[i]);
    free((void *)c.marks);
    free((void *)c.notes);
    return EXIT_SUCCESS;
}
