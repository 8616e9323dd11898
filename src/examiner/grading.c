/* Grades a student's answer: runs its tests in a sandbox. */
#include "examiner/grading.h"
#include "examiner/build.h"
#include "examiner/process.h"
#include "examiner/text.h"

#include <errno.h>
#include <fcntl.h>
#include <glob.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void add_test(struct kit *kit, const char *name, int points,
                     int hidden, bool idle)
{
    struct kit_test *test = kit->tests + kit->count;
    const int number =
        kit->count == 0 ? 1 : kit->tests[kit->count - 1].number + 1;
    if (kit->count + 2 > MARKS_MOST)
        text_fail("exercise %s has more than %d tests", kit->exercise,
                  MARKS_MOST);
    if (points > 0)
        *test++ =
            (struct kit_test){strdup(name), number, points, false, idle};
    if (hidden > 0)
        *test++ =
            (struct kit_test){strdup(name), number, hidden, true, idle};
    kit->count = (int)(test - kit->tests);
}

static void read_line(struct kit *kit, char *line)
{
    const char *text;
    char *end;
    if ((text = text_after(line, "file "))) {
        kit->file = strdup(text);
    } else if ((text = text_after(line, "title "))) {
        kit->title = strdup(text);
    } else if ((text = text_after(line, "test "))) {
        const int points = (int)strtol(text, &end, 10);
        const int hidden = (int)strtol(end, &end, 10);
        const bool idle = strtol(end, &end, 10) != 0;
        add_test(kit, end + 1, points, hidden, idle);
    } else if ((text = text_after(line, "hidden "))) {
        const int points = (int)strtol(text, &end, 10);
        add_test(kit, end + 1, 0, points, true);
    }
}

/* Moves the public tests to the front, so that a report that is cut short
   loses hidden tests first. */
static void public_first(struct kit *kit)
{
    struct kit_test sorted[MARKS_MOST];
    int count = 0;
    for (int hidden = 0; hidden < 2; ++hidden)
        for (int i = 0; i < kit->count; ++i)
            if (kit->tests[i].hidden == hidden)
                sorted[count++] = kit->tests[i];
    memcpy(kit->tests, sorted, (size_t)count * sizeof *sorted);
}

/* Reads the list of tests of each exercise. Exits if a list has no title or
   no test, perhaps because the disk was full: with such a list nobody would
   get a point. Skips an exercise without a list: it has no remote.c and is
   not graded, as make has reported. */
size_t grading_kits(struct kit **kits)
{
    glob_t found = {0};
    size_t count = 0;
    glob("tests/exercises/[0-9][0-9][a-z]", 0, NULL, &found);
    glob("tests/exercises/P[0-9]", GLOB_APPEND, NULL, &found);
    *kits = calloc(found.gl_pathc + 1, sizeof **kits);
    for (size_t i = 0; *kits && i < found.gl_pathc; ++i) {
        struct kit *kit = *kits + count;
        char path[64];
        memcpy(kit->exercise, strrchr(found.gl_pathv[i], '/') + 1, 3);
        snprintf(path, sizeof path, "build/grade/%s.list", kit->exercise);
        char *text = text_read(path), *rest = text;
        if (!text && access(path, F_OK) != 0)
            continue;
        for (char *line; (line = text_line(&rest));)
            read_line(kit, line);
        free(text);
        if (!kit->file || !kit->title || kit->count == 0)
            text_fail("%s is not complete; remove it and make grade again",
                      path);
        public_first(kit);
        ++count;
    }
    globfree(&found);
    if (!*kits || count == 0)
        text_fail("no lists in build/grade; start me with make grade");
    return count;
}

enum {
    MOST_LATE = 3,
    LATER_SECONDS = 1, /* time limit of a test after a time-out */
    SLOW_MS = 200,     /* a test this slow rules out LATER_SECONDS */
    MOST_BUILDING = 60,
    PRINTS_KEPT = 4096,
    STORY_KEPT = 8192
};

/* One exercise of one student while it is graded. The student's file is
   copied to its usual path, such as exercises/01a-collide.c, so that the
   compiler's messages name this path. */
struct job {
    const struct grading *grading;
    const struct kit *kit;
    struct marks *marks;
    struct sandbox_order order;
    struct sandbox sandbox;
    bool open;
    int prints;
    int late, waited;   /* numbers of time-outs and wall-clock time-outs */
    bool slow;          /* a test took SLOW_MS or longer */
    int crashed, named; /* numbers of crashes and of known mistakes */
    int left;           /* number of tests that wrote outside an output */
    char mistake[64];   /* name of the first known mistake */
    char types[8192], judge[4096], name[256], header[64];
};

static int open_or_fail(const char *path, int flags)
{
    const int file = open(path, flags | O_CLOEXEC, 0600);
    if (file < 0)
        text_fail("cannot open '%s': %s", path, strerror(errno));
    return file;
}

static void write_file(const char *name, const char *bytes, size_t length)
{
    const int file = open_or_fail(name, O_WRONLY | O_CREAT | O_EXCL);
    if (write(file, bytes, length) != (ssize_t)length || close(file) != 0)
        text_fail("cannot write '%s': %s", name, strerror(errno));
}

static void enter_new_folder(const struct grading *g, const char *exercise)
{
    char path[8192], tests[8192];
    snprintf(path, sizeof path, "%s/%s.XXXXXX", g->work, exercise);
    snprintf(tests, sizeof tests, "%s/tests", g->root);
    if (!mkdtemp(path) || chdir(path) != 0 ||
        mkdir("exercises", 0700) != 0 || symlink(tests, "tests") != 0)
        text_fail("cannot make a folder in '%s': %s", g->work,
                  strerror(errno));
}

/* Returns the header that the stub includes, or "kit/exercise.h" if none is
   found. */
static const char *find_header(struct job *job)
{
    char path[8192], name[48] = "exercise.h";
    snprintf(path, sizeof path, "%s/tests/exercises/%s/stub.c",
             job->grading->root, job->kit->exercise);
    char *text = text_read(path);
    const char *line = text ? strstr(text, "\n#include \"") : NULL;
    if (line)
        sscanf(line, "\n#include \"%47[a-z.]", name);
    free(text);
    snprintf(job->header, sizeof job->header, "kit/%s", name);
    return job->header;
}

static void prepare(struct job *job, const char *bytes, size_t length)
{
    const struct grading *g = job->grading;
    char path[8192];
    snprintf(job->name, sizeof job->name, "exercises/%s", job->kit->file);
    enter_new_folder(g, job->kit->exercise);
    write_file(job->name, bytes, length);
    job->order.kind = g->kind;
    job->order.name = job->name;
    job->order.seconds = g->seconds;
    job->order.source = open_or_fail(job->name, O_RDONLY);
    snprintf(path, sizeof path, "%s/src/examiner/%s", g->root,
             find_header(job) + strlen("kit/"));
    job->order.included = job->header;
    job->order.header = open_or_fail(path, O_RDONLY);
    snprintf(path, sizeof path, "%s/build/grade/%s.inside.o", g->root,
             job->kit->exercise);
    job->order.inside = open_or_fail(path, O_RDONLY);
    snprintf(path, sizeof path, "%s/src/examiner/sandbox.sh", g->root);
    if (!(job->order.script = text_read(path)))
        text_fail("cannot read '%s': %s", path, strerror(errno));
    snprintf(job->judge, sizeof job->judge, "%s/build/grade/%s.judge",
             g->root, job->kit->exercise);
    job->prints = open_or_fail("prints", O_RDWR | O_CREAT | O_APPEND);
}
static char *read_kit(const struct job *job, const char *name, int line)
{
    char path[8192];
    snprintf(path, sizeof path, "%s/build/grade/%s", job->grading->root,
             name);
    char *text = text_read(path), *rest = text, *found = NULL;
    while (line-- > 0)
        found = text_line(&rest);
    if (!found || !*found)
        text_fail("%s is not complete; remove it and make grade again",
                  path);
    found = strdup(found);
    free(text);
    return found;
}

/* Returns the time limit (in s) for the tests after a time-out; 0 means the
   usual limit. One second is enough, since these tests usually run into the
   same endless loop. Projects and slow programs keep the usual limit;
   otherwise tests that are merely slow would fail, too. */
static int later_seconds(const struct job *job)
{
    return *job->kit->exercise == 'P' || job->slow ? 0 : LATER_SECONDS;
}

/* Counts a time-out. marks->late asks the grader for a second try. This
   helps only if the wall-clock limit was reached, since wall-clock time
   also passes while other programs run. For a project any time-out counts,
   because run.c reports both limits as SIGXCPU. */
static void note_late(struct job *job, bool by_the_wall)
{
    const int later = later_seconds(job);
    const bool waits = by_the_wall || *job->kit->exercise == 'P';
    ++job->late;
    job->waited += waits;
    job->marks->late |= waits && !job->order.sanitized;
    if (later > 0 && later < job->order.seconds)
        job->order.seconds = later;
}

/* Opens a sandbox. Returns PASSED if it is ready; otherwise returns the
   state of the exercise. Inside, the driver is called sandbox.suite.o,
   because build.c searches the linker's errors for ".suite.o". */
static enum state open_box(struct job *job, FILE *story)
{
    if (ftruncate(job->prints, 0) != 0)
        text_fail("cannot empty a file: %s", strerror(errno));
    const enum sandbox_stage stage =
        sandbox_open(&job->sandbox, &job->order, job->prints);
    job->marks->build_seconds += job->sandbox.build_seconds;
    job->open = stage == SANDBOX_READY;
    job->marks->late |= stage == SANDBOX_TOO_LONG;
    if (stage == SANDBOX_STUCK)
        note_late(job, true);
    if (job->open)
        return PASSED;
    sandbox_close(&job->sandbox);
    chmod("prints", 0600);
    char *said = text_read("prints");
    if (stage == SANDBOX_NOT_BUILT)
        build_tell(said ? said : "", job->name, job->types, story);
    else if (stage == SANDBOX_TOO_LONG)
        fputs("  The compiler was stopped: it took too long.\n", story);
    else if (stage == SANDBOX_NO_MAIN)
        fputs("  The program ended before its first test.\n", story);
    else if (stage == SANDBOX_STUCK)
        fputs("  The program did not come to its first test.\n", story);
    if (stage != SANDBOX_NOT_BUILT)
        text_quote(story, said ? said : "", 12);
    free(said);
    return stage == SANDBOX_NO_MAIN ? CRASHED
           : stage == SANDBOX_STUCK ? TIMED_OUT
                                    : DOES_NOT_BUILD;
}

static void close_box(struct job *job)
{
    trial_close();
    if (job->open)
        sandbox_close(&job->sandbox);
    job->open = false;
}

/* Runs a test as the examiner does, with the judge as its runner. After a
   time-out, or if the test's process cannot be ended, closes the sandbox.
   The next test then opens a new one, so that no test affects a later
   one. */
static enum state run_test(struct job *job, const struct kit_test *test,
                           FILE *story)
{
    char seed[24];
    snprintf(seed, sizeof seed, "%" PRIu64, job->grading->seed);
    const struct trial trial = {
        .folder = ".",
        .source = job->name,
        .sanitized = job->order.sanitized,
        .seconds = job->grading->seconds,
        .runner = job->judge,
        .seed = test->hidden ? seed : NULL,
        .user = sandbox_judge(),
        .sandbox = {job->sandbox.answers, job->sandbox.requests},
        .later = later_seconds(job),
        .prints = "prints"};
    if (ftruncate(job->prints, 0) != 0)
        text_fail("cannot empty a file: %s", strerror(errno));
    trial_open(&trial);
    const enum state state = trial_run(&trial, test->number, story);
    if (state == TIMED_OUT)
        note_late(job, trial_waited());
    const bool settled =
        state != TIMED_OUT && sandbox_settle(&job->sandbox);
    job->slow |= settled && job->sandbox.test_ms >= SLOW_MS;
    if (!settled)
        close_box(job);
    return state;
}

/* Runs test i, unless its result is known or too many tests have timed out.
   In a second try (`before` is not NULL), a test that finished in the first
   try keeps its mark. The others run again until one of them times out
   again, which shows that the load on the machine was not the cause. A test
   that an empty function passes (`idle`) always runs again, because its
   points depend on the other tests. */
static enum state try_test(struct job *job, int i, FILE *story)
{
    const struct marks *before = job->grading->before;
    enum state state = before ? before->marks[i].state : NOT_BEGUN;
    if ((before && state != TIMED_OUT && state != NOT_BEGUN &&
         !job->kit->tests[i].idle) ||
        job->late >= MOST_LATE || (before && job->waited > 0) ||
        job->marks->build_seconds > MOST_BUILDING) {
        if (before)
            fputs(before->marks[i].story, story);
        return state;
    }
    state = job->open ? PASSED : open_box(job, story);
    return state == PASSED ? run_test(job, &job->kit->tests[i], story)
                           : state;
}

/* Replaces the hint if it names a different mistake from the first hint of
   this exercise: because of the first mistake, a later test may return a
   value that looks like another mistake. The student is asked to correct
   the first mistake first. */
static void name_once(char *mistake, size_t room, char **text, size_t *size)
{
    char *hint = strstr(*text, "\n  hint "), *end, *name;
    if (!hint)
        return;
    for (end = ++hint; (end = strchr(end, '\n')); ++end)
        if (strncmp(end + 1, "   ", 3) != 0)
            break;
    const char kept = end ? *end : '\0';
    if (end)
        *end = '\0';
    name = strrchr(hint, '[');
    const bool other = name && *mistake && strcmp(name, mistake) != 0;
    if (name && !*mistake)
        snprintf(mistake, room, "%s", name);
    if (end)
        *end = kept;
    if (!other)
        return;
    char *fresh = NULL;
    FILE *story = text_stream(&fresh, size);
    fprintf(story, "%.*s", (int)(hint - *text), *text);
    text_field(story, "question",
               "An earlier test has named a mistake. Is it the cause here, "
               "too? Mend it first, and then look at this test again.");
    fputs(end ? end + 1 : "", story);
    fclose(story);
    free(*text);
    *text = fresh;
}

static void keep_mark(struct marks *marks, const struct kit_test *test,
                      enum state state, const char *text, size_t size)
{
    marks->marks[marks->count++] =
        (struct mark){.name = strdup(test->name),
                      .hidden = test->hidden,
                      .points = test->points,
                      .state = state,
                      .story = marks_text(text, size, STORY_KEPT)};
    if (marks->state == PASSED ||
        (!state_wrong(marks->state) && state_wrong(state)))
        marks->state = state;
}

/* Keeps the output of the first test that printed anything; other tests
   would print the same lines again. Never called for hidden tests, because
   a program can print its inputs. */
static void keep_prints(struct marks *marks)
{
    struct stat about;
    chmod("prints", 0600);
    FILE *file = *marks->prints ? NULL : fopen("prints", "r");
    if (!file)
        return;
    char *bytes = malloc(PRINTS_KEPT);
    const size_t got = bytes ? fread(bytes, 1, PRINTS_KEPT, file) : 0;
    if (got > 0 && fstat(fileno(file), &about) == 0) {
        free(marks->prints);
        marks->prints = marks_text(bytes, got, PRINTS_KEPT);
        if (about.st_size > PRINTS_KEPT) {
            const size_t length = strlen(marks->prints);
            char *longer = text_must(realloc(marks->prints, length + 64));
            snprintf(longer + length, 64, "\n... (%lld bytes in all)",
                     (long long)about.st_size);
            marks->prints = longer;
        }
    }
    free(bytes);
    fclose(file);
}

/* If the only tests passed are idle ones, which an empty function passes,
   marks them as failed and adds the reason. If they still counted as passed
   but earned nothing, the tests passed would not agree with the points. */
static void settle_idle(const struct kit *kit, struct marks *marks)
{
    static const char why[] = "  A function that does nothing passes this "
                              "test too: it earns its\n  points once "
                              "another one has passed.\n";
    for (int i = 0; i < marks->count; ++i)
        if (!kit->tests[i].idle && marks->marks[i].state == PASSED)
            return;
    for (int i = 0; i < marks->count; ++i)
        if (marks->marks[i].state == PASSED) {
            marks->marks[i].state = FAILED;
            free(marks->marks[i].story);
            marks->marks[i].story =
                marks_text(why, strlen(why), STORY_KEPT);
        }
}

static void run_tests(struct job *job)
{
    for (int i = 0; i < job->kit->count && !process_signal(); ++i) {
        char *text = NULL;
        size_t size;
        FILE *story = text_stream(&text, &size);
        const double start = process_clock() - job->marks->build_seconds;
        const enum state state = try_test(job, i, story);
        fclose(story);
        if (state == FAILED)
            name_once(job->mistake, sizeof job->mistake, &text, &size);
        keep_mark(job->marks, &job->kit->tests[i], state, text, size);
        job->crashed += state == CRASHED;
        job->left += state == FAILED && strstr(text, "changed by your");
        job->named += state == FAILED && !job->kit->tests[i].hidden &&
                      strstr(text, "\n  hint ");
        const struct marks *before = job->grading->before;
        job->marks->marks[i].seconds =
            process_clock() - job->marks->build_seconds - start +
            (before ? before->marks[i].seconds : 0.0);
        if (!job->kit->tests[i].hidden)
            keep_prints(job->marks);
        free(text);
    }
    settle_idle(job->kit, job->marks);
}

static void replace_mark(struct mark *mark, const char *text, size_t size)
{
    free(mark->story);
    mark->state = CRASHED;
    mark->story = marks_text(text, size, STORY_KEPT);
}

static void ask_about(struct job *job, int i)
{
    char *text = NULL;
    size_t size;
    FILE *story = text_stream(&text, &size);
    const enum state state = run_test(job, &job->kit->tests[i], story);
    chmod("prints", 0600);
    const bool leaks = state == PASSED && !*job->marks->advice &&
                       trial_leak("prints", job->name, story);
    fclose(story);
    if (state == CRASHED && trial_mistake()) {
        replace_mark(&job->marks->marks[i], text, size);
    } else if (leaks) {
        free(job->marks->advice);
        job->marks->advice = marks_text(text, size, STORY_KEPT);
    }
    free(text);
}

/* Sets the state of the exercise to that of the first wrong test or, if no
   test is wrong, of the first test that did not pass. */
static void sum_up(struct marks *marks)
{
    marks->state = PASSED;
    for (int i = 0; i < marks->count; ++i)
        if (marks->state == PASSED || (!state_wrong(marks->state) &&
                                       state_wrong(marks->marks[i].state)))
            marks->state = marks->marks[i].state;
}

/* Runs the public tests once more, with sanitizers. A test in which they
   find a mistake does not pass: `make check` uses sanitizers as well, and
   both must give the same verdict. This run takes half the time of grading.
   grading_run skips it if a known mistake explains a failure and no test
   crashed or wrote outside an output. */
static void ask_sanitizers(struct job *job)
{
    char *text = NULL;
    size_t size;
    FILE *story = open_memstream(&text, &size);
    job->order.sanitized = true;
    job->order.compiler = read_kit(job, "flags", 2);
    job->order.lean = read_kit(job, "flags", 5);
    job->order.linker = read_kit(job, "flags", 6);
    free(job->marks->advice);
    job->marks->advice = strdup("");
    if (story && open_box(job, story) == PASSED)
        for (int i = 0;
             i < job->kit->count && job->open && !job->kit->tests[i].hidden;
             ++i)
            ask_about(job, i);
    if (story)
        fclose(story);
    free(text);
    close_box(job);
    settle_idle(job->kit, job->marks);
    sum_up(job->marks);
}

/* Returns whether the file is the unchanged stub. Then no test is run, and
   the exercise counts as not begun. */
static bool is_stub(const struct grading *grading, const struct kit *kit,
                    const char *bytes, size_t length)
{
    char path[8192];
    snprintf(path, sizeof path, "%s/tests/exercises/%s/stub.c",
             grading->root, kit->exercise);
    FILE *stub = fopen(path, "r");
    size_t at = 0;
    int c = EOF;
    while (stub && (c = getc(stub)) != EOF && at < length &&
           c == (unsigned char)bytes[at])
        ++at;
    if (stub)
        fclose(stub);
    return stub && c == EOF && at == length;
}

/* Adds all tests as not begun, for a file that could not be run. The points
   that can be earned must be the same for every student. */
static void enter_unrun(const struct kit *kit, struct marks *marks,
                        enum state state)
{
    for (int i = 0; i < kit->count; ++i)
        keep_mark(marks, &kit->tests[i], NOT_BEGUN, "", 0);
    marks->state = state;
}

enum { FIGURE_MOST = 1 << 22, FIGURE_WIDEST = 4000 };

/* Returns why these bytes are not an acceptable PNG file, or NULL. Only PNG
   is accepted, because SVG and PDF files can contain programs, and the
   lecturer will open the figure. */
static const char *see_png(const unsigned char *png, size_t length)
{
    static const char head[] = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR";
    static const char tail[] = "\0\0\0\0IEND\xae\x42\x60\x82";
    unsigned side[2] = {0, 0};
    if (length == 0)
        return "its script has left none";
    if (length > FIGURE_MOST)
        return "it has more than 4 MB";
    if (length < 45 || memcmp(png, head, 16) != 0 ||
        memcmp(png + length - 12, tail, 12) != 0)
        return "what its script has left is no whole PNG";
    for (int i = 0; i < 8; ++i)
        side[i / 4] = side[i / 4] << 8 | png[16 + i];
    return side[0] > FIGURE_WIDEST || side[1] > FIGURE_WIDEST
               ? "it has more than 4000 points a side"
               : NULL;
}
static void note_figure(struct job *job, const char *place, const char *why)
{
    char text[2048], *said = text_read("prints"), *rest = said, last[160];
    *last = '\0';
    for (char *line; why && place && (line = text_line(&rest));)
        if (line[strspn(line, " ^\t")])
            snprintf(last, sizeof last, "; at last it said: %.130s", line);
    snprintf(text, sizeof text, "%.1200s%s%s%s%s", job->marks->note,
             *job->marks->note ? "; " : "",
             why ? "no figure: " : "figure: ", why ? why : place, last);
    job->marks->note = marks_text(text, strlen(text), sizeof text);
    free(said);
}
static void draw(struct job *job, struct grading_page *page)
{
    static const char *const reasons[] = {
        [SANDBOX_NO_PROGRAM] = "its program could not be built",
        [SANDBOX_NO_GNUPLOT] = "gnuplot is missing in the sandbox",
        [SANDBOX_DRAWS_LATE] = "its script did not end in half a minute"};
    write_file("script", page->script, page->length);
    const int script = open_or_fail("script", O_RDONLY);
    unsigned char *figure = malloc(FIGURE_MOST + 1);
    if (!figure || ftruncate(job->prints, 0) != 0)
        text_fail("cannot make room for a figure: %s", strerror(errno));
    const enum sandbox_drawing drawing =
        sandbox_draw(&job->order, script, job->prints, (char *)figure,
                     FIGURE_MOST + 1, &page->drawn);
    close(script);
    chmod("prints", 0600);
    const char *why = drawing != SANDBOX_DRAWN
                          ? reasons[drawing]
                          : see_png(figure, page->drawn);
    page->figure = why ? NULL : (char *)figure;
    note_figure(job, page->place, why);
}

static void draw_figure(struct job *job, struct grading_page *page)
{
    if (!page->script)
        note_figure(job, NULL,
                    page->refusal ? page->refusal
                                  : "no script was handed in");
    else if (job->grading->kind == SANDBOX_NONE)
        note_figure(job, NULL, "its script is not run without a sandbox");
    else
        draw(job, page);
}

void grading_run(const struct grading *grading, const struct kit *kit,
                 const char *bytes, size_t length, struct marks *marks)
{
    struct job job = {.grading = grading, .kit = kit, .marks = marks};
    marks->state = NOT_BEGUN;
    if (!bytes || is_stub(grading, kit, bytes, length)) {
        enter_unrun(kit, marks, NOT_BEGUN);
        return;
    }
    prepare(&job, bytes, length);
    job.order.compiler = read_kit(&job, "flags", 1);
    job.order.terse = read_kit(&job, "flags", 3);
    job.order.lean = *kit->exercise == 'P' ? "" : "-g0";
    job.order.linker = read_kit(&job, "flags", 4);
    char names[16];
    snprintf(names, sizeof names, "%s.names", kit->exercise);
    job.order.keep = read_kit(&job, names, 1);
    snprintf(job.types, sizeof job.types, "%s/build/grade/%s.types.h",
             grading->root, kit->exercise);
    char *types = *kit->exercise == 'P' ? strdup("") : text_read(job.types);
    if (!types)
        text_fail("%s is missing; make grade again", job.types);
    job.order.types = types;
    char *text = NULL;
    size_t size;
    FILE *story = text_stream(&text, &size);
    marks->state = open_box(&job, story);
    fclose(story);
    free(marks->story);
    marks->story = marks_text(text, size, STORY_KEPT);
    free(text);
    if (marks->state != PASSED) {
        enter_unrun(kit, marks, marks->state);
        return;
    }
    run_tests(&job);
    close_box(&job);
    if (grading->page)
        draw_figure(&job, grading->page);
    if (marks->state != TIMED_OUT && marks->state != NOT_BEGUN &&
        (job.named == 0 || job.crashed > 0 || job.left > 0))
        ask_sanitizers(&job);
}
