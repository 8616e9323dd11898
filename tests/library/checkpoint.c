/* Checkpoints: what was written comes back to the last bit, what is not
   whole or not ours is refused and stays, and at no moment do rows without
   a checkpoint, or a checkpoint without rows, pass for a run. */
#define _GNU_SOURCE /* syscall */
#include "unit.h"

#include "library/heap.h"
#include "library/scene_same.h"
#include "library/toolbox_child.h"
#include "forces/adaptive.h"
#include "forces/checkpoint.h"

#include <fcntl.h>
#include <stdarg.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#define OUTPUT "build/tests/checkpoint-unit"
#define ROWS OUTPUT ".rows"
#define SAVED OUTPUT ".checkpoint"
static const char command[] = "step scene --until 3";

/* The files that the library removes, in order; and what happens, if
   anything does, between opening a file and locking it. */
static char removed[16][64];
static size_t removals;
static void (*before_lock)(void);

int unlink(const char *path)
{
    if (removals < sizeof removed / sizeof removed[0])
        snprintf(removed[removals++], sizeof removed[0], "%s", path);
    return (int)syscall(SYS_unlinkat, AT_FDCWD, path, 0);
}

int fcntl(int file, int what, ...)
{
    va_list rest;
    va_start(rest, what);
    void *argument = va_arg(rest, void *);
    va_end(rest);
    if (what == F_SETLK && before_lock)
        before_lock();
    return (int)syscall(SYS_fcntl, file, what, argument);
}

static bool there(const char *path)
{
    return access(path, F_OK) == 0;
}

static void put(const char *path, const char *text, size_t length)
{
    FILE *f = fopen(path, "w");
    UNIT_MUST(f && fwrite(text, 1, length, f) == length && fclose(f) == 0);
}

static size_t get(const char *path, char text[], size_t room)
{
    FILE *f = fopen(path, "r");
    const size_t length = f ? fread(text, 1, room - 1, f) : 0;
    if (f)
        fclose(f);
    text[length] = '\0';
    return length;
}

static void clear(void)
{
    syscall(SYS_unlinkat, AT_FDCWD, ROWS, 0);
    syscall(SYS_unlinkat, AT_FDCWD, SAVED, 0);
    removals = 0;
    before_lock = NULL;
}

/* Standard error goes nowhere; and where it went before. */
static int hush(void)
{
    const int saved = dup(STDERR_FILENO);
    UNIT_MUST(freopen("/dev/null", "w", stderr) != NULL);
    return saved;
}
static void speak(int saved)
{
    fflush(stderr);
    dup2(saved, STDERR_FILENO);
    close(saved);
}

/* A light body round a heavy one, by a method whose steps are its own. */
static void orbit(struct scene *s, struct motion *m, const char *method)
{
    UNIT_MUST(scene_create(s, 2));
    s->mass[1] = 1e-3;
    s->k2 = 1;
    s->position[1] = 1;
    s->velocity[3] = 0.7;
    s->dt = 0.01;
    UNIT_MUST(motion_begin(m, "checkpoint", s, method, 0));
    if (m->stepping.method->adaptive)
        m->stepping.tolerance = 1e-6;
}

static const struct checkpoint_numbers numbers = {.start = -1.5,
                                                  .steps = 7,
                                                  .collisions = 0x1p53 - 1,
                                                  .evaluations = 123456789,
                                                  .rows = 2,
                                                  .energy = -0.1,
                                                  .depth = 1e-300,
                                                  .worst = 3,
                                                  .last = -1e300,
                                                  .scene = 5};

static const double rows[2][3] = {{0.1, -1e-300, 3}, {NAN, 1, 1e22}};
/* Two rows and a checkpoint, after some steps of the motion. */
static void save(struct checkpoint *c, struct motion *m)
{
    UNIT_MUST(checkpoint_begin(c, "checkpoint", command, OUTPUT));
    UNIT_TRUE(checkpoint_row(c, 3, rows[0]));
    UNIT_TRUE(checkpoint_row(c, 3, rows[1]));
    UNIT_TRUE(checkpoint_write(c, m, numbers));
}

/* With a method that has steps of its own and with one that has none: a run
   that is taken up has the same numbers, rows and bits to come. */
TEST(test_comes_back, "a run comes back to the last bit")
{
    static const char *const methods[] = {"leapfrog", "radau15", "dopri5"};
    for (size_t k = 0; k < 3; ++k) {
        FREED(scene) s, t;
        ENDED(motion) m, n;
        struct checkpoint c, d;
        struct checkpoint_numbers known = {0};
        clear();
        orbit(&s, &m, methods[k]);
        motion_run(&m, 7);
        save(&c, &m);
        checkpoint_row(&c, 3, rows[0]); /* too late to be in it */
        checkpoint_end(&c, true);
        UNIT_TRUE(checkpoint_exists(OUTPUT) && there(ROWS));
        UNIT_TRUE(checkpoint_resume(&d, "checkpoint", command, OUTPUT, &t,
                                    &known));
        UNIT_TRUE(memcmp(&known, &numbers, sizeof known) == 0);
        UNIT_TRUE(scene_same(&s, &t));
        UNIT_MUST(motion_begin(&n, "checkpoint", &t, methods[k], 0));
        n.stepping.tolerance = m.stepping.tolerance;
        motion_resume(&n, s.time - 7 * 0.01, 7);
        UNIT_TRUE(checkpoint_recall(&d, &n));
        motion_run(&m, 50);
        motion_run(&n, 50);
        for (size_t i = 0; i < 6; ++i) {
            UNIT_EQUAL(s.position[i], t.position[i]);
            UNIT_EQUAL(s.velocity[i], t.velocity[i]);
        }
        checkpoint_row(&d, 3, rows[1]);
        checkpoint_end(&d, true);
    }
    char text[256];
    get(ROWS, text, sizeof text);
    const double printed = strtod(strchr(text + 15, ' '), NULL);
    UNIT_TRUE(strncmp(text, "# rows of step\n0.10000000000000001 ", 35) ==
              0);
    UNIT_EQUAL(printed, -1e-300);
    UNIT_TRUE(strstr(text, " 3\nnan 1 1e+22\nnan 1 1e+22\n") != NULL);
    clear();
}

TEST(test_other_method, "not for another method")
{
    FREED(scene) s, t;
    ENDED(motion) m;
    struct checkpoint c;
    struct checkpoint_numbers known;
    clear();
    orbit(&s, &m, "radau15");
    motion_run(&m, 7);
    save(&c, &m);
    checkpoint_end(&c, true);
    UNIT_TRUE(
        checkpoint_resume(&c, "checkpoint", command, OUTPUT, &t, &known));
    for (int other = 0; other < 2; ++other) {
        FREED(scene) u;
        ENDED(motion) n;
        orbit(&u, &n, other ? "dopri5" : "leapfrog");
        UNIT_TRUE(!checkpoint_recall(&c, &n));
    }
    UNIT_TRUE(checkpoint_recall(&c, &m));
    checkpoint_end(&c, false);
    clear();
}

TEST(test_mode, "the umask says who may read the rows")
{
    struct checkpoint c;
    struct stat is;
    clear();
    const mode_t mask = umask(0);
    UNIT_TRUE(checkpoint_begin(&c, "checkpoint", command, OUTPUT));
    umask(mask);
    UNIT_TRUE(stat(ROWS, &is) == 0 && (is.st_mode & 0777) == 0666);
    checkpoint_end(&c, false);
    clear();
}

/* Without a checkpoint rows are nothing, but with a checkpoint and without
   its rows a run could not be resumed: the checkpoint goes first. */
TEST(test_end, "a checkpoint goes before its rows")
{
    FREED(scene) s;
    ENDED(motion) m;
    struct checkpoint c;
    clear();
    orbit(&s, &m, "leapfrog");
    save(&c, &m);
    removals = 0;
    checkpoint_end(&c, false);
    UNIT_TRUE(removals == 2 && strcmp(removed[0], SAVED) == 0 &&
              strcmp(removed[1], ROWS) == 0);
    UNIT_TRUE(!there(SAVED) && !there(ROWS));
    checkpoint_end(&c, false); /* nothing is left to do */
    UNIT_EQUAL(removals, 2);
    UNIT_MUST(checkpoint_begin(&c, "checkpoint", command, OUTPUT));
    checkpoint_end(&c, true); /* no checkpoint: the rows go */
    UNIT_TRUE(!there(SAVED) && !there(ROWS));
    save(&c, &m);
    checkpoint_end(&c, true);
    UNIT_TRUE(there(SAVED) && there(ROWS));
    /* Who begins anew leaves no checkpoint of other rows behind. */
    UNIT_MUST(checkpoint_begin(&c, "checkpoint", command, OUTPUT));
    UNIT_TRUE(!there(SAVED) && !checkpoint_exists(OUTPUT));
    char text[64];
    fflush(c.rows);
    UNIT_TRUE(get(ROWS, text, sizeof text) == 15 &&
              strcmp(text, "# rows of step\n") == 0);
    checkpoint_end(&c, false);
    clear();
}

/* What a child says, and how it ends, which begins or resumes. */
enum { BEGUN = 0, REFUSED = 1, TAKEN = 2 };
static int begins(UNUSED void *unused)
{
    struct checkpoint c;
    const bool good = checkpoint_begin(&c, "step", command, OUTPUT);
    const bool locked = c.locked;
    if (good)
        checkpoint_end(&c, true);
    return good ? BEGUN : locked ? TAKEN : REFUSED;
}
static int resumes(void *words)
{
    struct checkpoint c;
    struct checkpoint_numbers known;
    struct scene s;
    const bool good = checkpoint_resume(&c, "step", words ? words : command,
                                        OUTPUT, &s, &known);
    const bool locked = c.locked;
    if (good) {
        checkpoint_end(&c, true);
        scene_free(&s);
    }
    return good ? BEGUN : locked ? TAKEN : REFUSED;
}

static void says(int (*does)(void *), void *with, int status,
                 const char *what)
{
    const struct child c = child_run(does, with, NULL);
    const char *end = strchr(c.err, '\n');
    UNIT_EQUAL(c.status, status);
    UNIT_TRUE(status == BEGUN ? !c.err[0] : end && !end[1]);
    UNIT_TRUE(!what || strstr(c.err, what) != NULL);
}

TEST(test_lock, "one run at a time")
{
    FREED(scene) s;
    ENDED(motion) m;
    struct checkpoint c;
    clear();
    orbit(&s, &m, "leapfrog");
    save(&c, &m);
    says(begins, NULL, TAKEN, ROWS ": another run is writing it");
    says(resumes, NULL, TAKEN, ROWS ": another run is writing it");
    UNIT_TRUE(there(SAVED) && there(ROWS));
    checkpoint_end(&c, true);
    says(resumes, NULL, BEGUN, NULL);
    says(begins, NULL, BEGUN, NULL);
    clear();
}

/* Another run ends between our opening its rows and our lock: what we hold
   then is a file that has lost its name. */
static void rows_go(void)
{
    syscall(SYS_unlinkat, AT_FDCWD, ROWS, 0);
}
static void rows_change(void)
{
    put(OUTPUT ".new", "# rows of step\n", 15);
    UNIT_MUST(rename(OUTPUT ".new", ROWS) == 0);
}
TEST(test_between, "a file that lost its name is not locked")
{
    clear();
    before_lock = rows_go;
    says(begins, NULL, TAKEN, "another run");
    before_lock = rows_change;
    says(begins, NULL, TAKEN, "another run");
    UNIT_TRUE(there(ROWS));
    before_lock = NULL;
    says(begins, NULL, BEGUN, NULL);
    clear();
}

TEST(test_foreign, "what is not ours stays")
{
    char text[64];
    clear();
    put(ROWS, "my diary\n", 9);
    says(begins, NULL, TAKEN, ROWS ": is not step's and stays");
    UNIT_TRUE(get(ROWS, text, 64) == 9 && strcmp(text, "my diary\n") == 0);
    clear();
    put(SAVED, "# rows of step\n", 15);
    says(begins, NULL, TAKEN, SAVED ": is not step's and stays");
    UNIT_EQUAL(get(SAVED, text, 64), 15);
    clear();
    put(ROWS, "", 0);
    put(SAVED, "", 0);
    says(begins, NULL, BEGUN, NULL); /* an empty one is nobody's */
    clear();
    says(resumes, NULL, REFUSED, ROWS ": No such file");
    put(ROWS, "# rows of step\n", 15);
    says(resumes, NULL, REFUSED, SAVED ": No such file");
    clear();
}

TEST(test_damage, "no bit may be changed")
{
    FREED(scene) s;
    ENDED(motion) m;
    struct checkpoint c;
    static char text[8192], bad[8192], line[256];
    clear();
    orbit(&s, &m, "radau15");
    motion_run(&m, 3);
    save(&c, &m);
    checkpoint_end(&c, true);
    const size_t length = get(SAVED, text, sizeof text);
    const char *head_end = strstr(text, "#= end ");
    UNIT_MUST(length > 500 && head_end);
    const size_t head = (size_t)(head_end - text);
    const int saved = hush();
    for (size_t at = 0; at < length; at += at < head ? 1 : 3) {
        memcpy(bad, text, length);
        bad[at] ^= 1;
        put(SAVED, bad, length);
        struct scene t;
        struct checkpoint_numbers known;
        if (bad[at] == '\0')
            continue;
        UNIT_TRUE(
            !checkpoint_resume(&c, "step", command, OUTPUT, &t, &known));
        if (at % 7 == 0) {
            put(SAVED, text, at); /* cut */
            UNIT_TRUE(!checkpoint_resume(&c, "step", command, OUTPUT, &t,
                                         &known));
        }
    }
    speak(saved);
    put(SAVED, text, length);
    says(resumes, "step scene --until 4", REFUSED,
         SAVED ": is of another command");
    const size_t most = get(ROWS, line, sizeof line);
    put(ROWS, line, most - 1);
    says(resumes, NULL, REFUSED, ROWS ": has fewer rows than");
    line[most - 2] ^= 1;
    put(ROWS, line, most);
    says(resumes, NULL, REFUSED, ROWS ": has other rows than");
    line[most - 2] ^= 1;
    put(ROWS, line, most);
    says(resumes, NULL, BEGUN, NULL);
    clear();
}

/* Rows are in their file, and not in a buffer, once the checkpoint is that
   counts on them: the run may be killed at once. */
TEST(test_flushed, "rows are written before what counts on them")
{
    FREED(scene) s;
    ENDED(motion) m;
    struct checkpoint c;
    static char text[8192], line[256];
    clear();
    orbit(&s, &m, "leapfrog");
    save(&c, &m);
    get(SAVED, text, sizeof text);
    const char *at = strstr(text, "#= length ");
    const double length = at ? strtod(at + 10, NULL) : NAN;
    UNIT_EQUAL(get(ROWS, line, sizeof line), length);
    UNIT_TRUE(length > 50);
    checkpoint_end(&c, false);
    clear();
}

/* Writes the text, in which the number of one line is another, as a
   checkpoint whose sum is right. */
static void forge(const char *text, const char *key, const char *number)
{
    static char forged[8192];
    char start[64];
    snprintf(start, sizeof start, "#= %s ", key);
    const char *at = strstr(text, start), *end = strstr(text, "#= end ");
    UNIT_MUST(at && end);
    at += strlen(start);
    const char *rest = strchr(at, '\n');
    int n = snprintf(forged, sizeof forged, "%.*s%s%.*s", (int)(at - text),
                     text, number, (int)(end - rest), rest);
    const uint64_t sum = table_sum(TABLE_NOTHING, forged, (size_t)n);
    n += snprintf(forged + n, sizeof forged - (size_t)n, "#= end %llu\n",
                  (unsigned long long)sum);
    put(SAVED, forged, (size_t)n);
}

TEST(test_forged, "what no run has written")
{
    static const struct {
        const char *key, *good, *bad; /* numbers */
    } lines[] = {{"steps", "7|0|9007199254740991|",
                  "9007199254740992|-1|1.5|nan|7x||"},
                 {"energy", "-1.5|1e300|", "nan|-inf|1 2|x|"},
                 {"start", "-3|", ""},
                 {"collisions", "", "-1|"},
                 {"evaluations", "", "0.5|"},
                 {"rows", "", "-2|"},
                 {"scene", "", "1e-3|"},
                 {"depth", "", "inf|"},
                 {"worst", "", "|"},
                 {"last", "", "nan|"},
                 {"own", "1|", "nan||"},
                 {"length", "", "-80|x||1e1|"},
                 {"sum", "", "0||"}};
    FREED(scene) s;
    ENDED(motion) m;
    struct scene t;
    struct checkpoint c;
    struct checkpoint_numbers known;
    static char text[8192];
    clear();
    orbit(&s, &m, "radau15");
    motion_run(&m, 3);
    save(&c, &m);
    checkpoint_end(&c, true);
    get(SAVED, text, sizeof text);
    const int saved = hush();
    for (size_t k = 0; k < 2 * (sizeof lines / sizeof lines[0]); ++k) {
        const bool good = k % 2;
        const char *list = good ? lines[k / 2].good : lines[k / 2].bad;
        char number[80];
        while (unit_item(&list, number)) {
            forge(text, lines[k / 2].key, number);
            const bool taken =
                checkpoint_resume(&c, "step", command, OUTPUT, &t, &known);
            if (taken != good)
                printf("# %s %s\n", lines[k / 2].key, number);
            UNIT_TRUE(taken == good);
            if (taken) {
                scene_free(&t);
                checkpoint_end(&c, true);
            }
        }
    }
    speak(saved);
    /* 0 is a number as others are: it is the rows that have another sum. */
    forge(text, "sum", "0");
    says(resumes, NULL, REFUSED, ROWS ": has other rows than");
    clear();
}

TEST(test_possible, "which outputs may have one")
{
    const char *no = "-|/dev/null|/dev/no-such|/proc/self/fd/1|build|";
    const char *yes =
        "/dev/shm/none-of-these|build/tests/none of these|--|";
    char output[80];
    UNIT_TRUE(!checkpoint_possible(NULL));
    while (unit_item(&no, output))
        UNIT_TRUE(!checkpoint_possible(output));
    while (unit_item(&yes, output))
        UNIT_TRUE(checkpoint_possible(output));
    put(OUTPUT, "x", 1);
    UNIT_TRUE(checkpoint_possible(OUTPUT));
    syscall(SYS_unlinkat, AT_FDCWD, OUTPUT, 0);
}

/* The sum of a file is Fowler, Noll and Vo's of 64 bits, without its last
   eleven; whatever its length. */
TEST(test_sum, "the sum of a file")
{
    static char text[70000];
    for (size_t i = 0; i < sizeof text; ++i)
        text[i] = (char)('a' + i % 23);
    static const size_t lengths[] = {0, 1, 65535, 65536, 65537, 70000};
    for (size_t k = 0; k < sizeof lengths / sizeof lengths[0]; ++k) {
        uint64_t sum = 14695981039346656037u;
        for (size_t i = 0; i < lengths[k]; ++i)
            sum = (sum ^ (unsigned char)text[i]) * 1099511628211u;
        put(OUTPUT, text, lengths[k]);
        UNIT_EQUAL(checkpoint_sum(OUTPUT), sum >> 11);
    }
    syscall(SYS_unlinkat, AT_FDCWD, OUTPUT, 0);
    UNIT_EQUAL(checkpoint_sum(OUTPUT), 0);
    UNIT_EQUAL(checkpoint_sum("build"), 0);
}

/* All rows come into the table, many of them too; not those of a file that
   somebody has changed meanwhile. */
TEST(test_copy, "all rows are copied")
{
    enum { MANY = 20000 };
    static char text[200000], expected[200000];
    for (int changed = 0; changed < 2; ++changed) {
        struct checkpoint c;
        clear();
        UNIT_MUST(checkpoint_begin(&c, "step", command, OUTPUT));
        char *end = expected;
        for (int i = 0; i < MANY; ++i) {
            UNIT_TRUE(checkpoint_row(&c, 1, (double[]){i}));
            end += sprintf(end, "%d\n", i);
        }
        fflush(c.rows);
        if (changed) {
            FILE *f = fopen(ROWS, "r+");
            UNIT_MUST(f && fseek(f, 100000, SEEK_SET) == 0 &&
                      fputs("7\n7", f) >= 0 && fclose(f) == 0);
        }
        struct table *t = table_open("step", OUTPUT);
        UNIT_MUST(t != NULL);
        const int saved = hush();
        UNIT_TRUE(checkpoint_copy(&c, t) == !changed);
        speak(saved);
        UNIT_TRUE(table_close(t));
        if (!changed)
            UNIT_TRUE(get(OUTPUT, text, sizeof text) ==
                          (size_t)(end - expected) &&
                      strcmp(text, expected) == 0);
        checkpoint_end(&c, false);
    }
    syscall(SYS_unlinkat, AT_FDCWD, OUTPUT, 0);
    clear();
}

TEST(test_lost, "rows that are lost are not copied")
{
    struct checkpoint c;
    clear();
    UNIT_MUST(checkpoint_begin(&c, "step", command, OUTPUT));
    struct table *t = table_open("step", OUTPUT);
    UNIT_MUST(t != NULL);
    const int saved = hush();
    c.lost = true;
    UNIT_TRUE(!checkpoint_copy(&c, t));
    speak(saved);
    table_discard(t);
    checkpoint_end(&c, false);
    clear();
}

/* However often a checkpoint is written, no memory is lost; and where there
   is none, it says so. */
struct run {
    struct checkpoint c;
    struct motion m;
};
static void write_one(void *with)
{
    struct run *r = with;
    UNIT_TRUE(checkpoint_write(&r->c, &r->m, numbers));
}
static void whole(void *with)
{
    struct run *r = with;
    FREED(scene) t;
    struct checkpoint_numbers known;
    save(&r->c, &r->m);
    checkpoint_end(&r->c, true);
    UNIT_TRUE(
        checkpoint_resume(&r->c, "step", command, OUTPUT, &t, &known));
    checkpoint_end(&r->c, false);
}
TEST(test_memory, "no memory is lost")
{
    struct run r;
    struct scene s;
    clear();
    orbit(&s, &r.m, "radau15");
    motion_run(&r.m, 3);
    UNIT_MUST(checkpoint_begin(&r.c, "step", command, OUTPUT));
    heap_stays("write", write_one, &r);
    const int saved = hush();
    /* (Streams do without a buffer.) */
    for (long k = 0, refused = 1; refused; ++k) {
        heap_failing = k;
        const bool well = checkpoint_write(&r.c, &r.m, numbers);
        refused = heap_failing < 0;
        heap_failing = -1;
        UNIT_TRUE(well || refused);
    }
    speak(saved);
    checkpoint_end(&r.c, false);
    heap_stays("a whole run", whole, &r);
    motion_end(&r.m);
    scene_free(&s);
    clear();
}
