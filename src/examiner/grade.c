/* The program behind make grade: grades many submissions in parallel. */
#define _XOPEN_SOURCE 700 /* realpath */
#include "examiner/folder.h"
#include "examiner/grading.h"
#include "examiner/process.h"
#include "examiner/publish.h"
#include "examiner/submissions.h"
#include "examiner/sum.h"
#include "examiner/text.h"
#include "toolbox/options.h"
#include "toolbox/replace.h"

#include <ctype.h>
#include <errno.h>
#include <glob.h>
#include <inttypes.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

struct settings {
    const char *folder, *reports, *output, *exercises;
    const char *job; /* the only job to grade: "anna/01a/KEY" */
    long jobs;
    int seconds;
    uint64_t seed;
    bool seeded, unsafe, list;
};

enum round { TRIED, RETRIED, COPIED };

/* A file that was handed in, and the first student who handed it in. */
struct alike {
    uint64_t sum;
    size_t student, length;
    char *bytes;
};

struct batch {
    struct settings settings;
    struct kit *kits;
    struct submissions handed;
    struct submission *submissions; /* handed.list or one entry of it */
    size_t kit_count, count;        /* numbers of exercises and students */
    struct grading grading;
    char root[4096], work[4200];
    uint64_t compiler;   /* checksum of the compiler's version */
    struct alike *alike; /* the distinct files for an exercise */
    size_t alikes;
    size_t begun, done, failed;
};

static const struct options_entry entries[] = {
    {"", 0, "FOLDER", NULL},
    {"exercises", 'e', "LIST",
     "only these, 01a,02b or 01 for a chapter (all)"},
    {"hidden", 'H', "SEED",
     "of the inputs that students never see, a whole\n"
     "number (drawn once and kept in the output folder)"},
    {"job", 'J', "JOB", "only this one, of the list; without reports"},
    {"jobs", 'j', "N", "gradings at a time (one more than processors)"},
    {"list", 'l', NULL, "print what is to be graded, a command a line"},
    {"output", 'o', "FOLDER",
     "for results and reports (build/grade/results)"},
    {"report", 'r', "LIST",
     "gradescope,classroom50,github,junit: these, too"},
    {"seconds", 's', "N", "processor time that a test may take (5)"},
    {"unsafe", 'u', NULL,
     "go on where programs cannot be put into a sandbox"},
    {0}};

static const char purpose[] =
    "Grade a folder that has a folder for each student, or files whose\n"
    "names begin with theirs, as Moodle and Canvas make them. What was\n"
    "graded before and has not changed is not graded again.\n"
    "Exit status: 0 all is graded, 1 something could not be, 2 trouble.";

static void take_option(struct settings *s, struct options *o, int letter)
{
    switch (letter) {
    case OPTIONS_ARGUMENT:
        if (s->folder)
            options_fail(o, "which folder of submissions, '%s' or '%s'?",
                         s->folder, options_text(o));
        s->folder = options_text(o);
        break;
    case 'e': s->exercises = options_text(o); break;
    case 'H':
        s->seed = options_count(o, 0, UINT64_MAX);
        s->seeded = true;
        break;
    case 'J': s->job = options_text(o); break;
    case 'j': s->jobs = (long)options_count(o, 1, 1024); break;
    case 'l': s->list = true; break;
    case 'o': s->output = options_text(o); break;
    case 'r': s->reports = options_text(o); break;
    case 's': s->seconds = (int)options_count(o, 1, 3600); break;
    case 'u': s->unsafe = true; break;
    }
}

static bool next_word(const char **list, char word[64])
{
    *list += strspn(*list, ", ");
    const size_t length = strcspn(*list, ", ");
    snprintf(word, 64, "%.*s", (int)(length < 63 ? length : 63), *list);
    *list += length;
    return length > 0;
}

/* Refuses unknown report formats now instead of after hours of grading. */
static void check_reports(const char *list)
{
    char word[64];
    while (next_word(&list, word))
        if (!publish_known(word))
            text_fail("--report: '%s' is none of %s; table and csv are "
                      "always written",
                      word, publish_names);
}

static void check_name(const struct batch *b, const char *word)
{
    for (size_t i = 0; i < b->kit_count; ++i)
        if (text_after(b->kits[i].exercise, word))
            return;
    text_fail("--exercises: there is no exercise '%s'", word);
}

/* Keeps only the exercises that --exercises names, in the order of the
   book. "01" means all exercises of chapter 1. A word that matches no
   exercise is refused, because its table would be empty. */
static void choose_kits(struct batch *b)
{
    const char *list = b->settings.exercises;
    char word[64];
    size_t kept = 0;
    if (!list)
        return;
    for (const char *rest = list; next_word(&rest, word);)
        check_name(b, word);
    for (size_t i = 0; i < b->kit_count; ++i) {
        bool wanted = false;
        for (const char *rest = list; next_word(&rest, word);)
            wanted |= text_after(b->kits[i].exercise, word) != NULL;
        if (wanted)
            b->kits[kept++] = b->kits[i];
    }
    if (kept == 0)
        text_fail("--exercises: '%s' names none", list);
    b->kit_count = kept;
}

static const char *exercise_of(const char *job)
{
    static char exercise[4];
    int end = 0;
    sscanf(job, "%*[^/]/%3[0-9A-Za-z]/%*16[0-9a-f]%n", exercise, &end);
    if (end == 0 || job[end])
        text_fail("--job: '%s' is not of a list", job);
    return exercise;
}

static struct settings read_settings(int argc, char **argv)
{
    struct options o;
    struct settings s = {.reports = "",
                         .output = "build/grade/results",
                         .jobs = sysconf(_SC_NPROCESSORS_ONLN) + 1,
                         .seconds = 5};
    options_begin(&o, "grade", purpose, entries, argc, argv);
    for (int letter; (letter = options_next(&o)) != -1;)
        take_option(&s, &o, letter);
    if (!s.folder)
        options_fail(&o, "which folder of submissions? See grade --help");
    check_reports(s.reports);
    if (s.job)
        s.exercises = exercise_of(s.job);
    return s;
}

static char *work_folder;

static void remove_work(void)
{
    if (!folder_remove(work_folder))
        fprintf(stderr, "grade: cannot remove '%s': %s\n", work_folder,
                strerror(errno));
}

static void make_folder(const char *path)
{
    if (mkdir(path, 0700) != 0 && errno != EEXIST)
        text_fail("cannot make '%s': %s", path, strerror(errno));
}

/* Returns the prefix for the names of work folders. It is the same for all
   graders on this system, and differs between boots of the kernel and
   between PID namespaces: if several machines share the folder, a process
   ID alone is ambiguous. */
static const char *name_machine(void)
{
    static char name[32];
    char room[64] = "";
    if (readlink("/proc/self/ns/pid", room, sizeof room - 1) < 0)
        *room = '\0';
    const uint64_t sum = sum_file(0, "/proc/sys/kernel/random/boot_id");
    snprintf(name, sizeof name, "work.%016" PRIx64 ".",
             sum_bytes(sum, room, strlen(room)));
    return name;
}

/* Removes the work folders of graders that were killed. A work folder's
   name contains the process ID of its grader. */
static void remove_abandoned(void)
{
    glob_t found = {0};
    char pattern[64];
    const int at = snprintf(pattern, sizeof pattern, "build/grade/%s*",
                            name_machine());
    glob(pattern, 0, NULL, &found);
    for (size_t i = 0; i < found.gl_pathc; ++i) {
        work_folder = found.gl_pathv[i];
        const long pid = strtol(work_folder + at - 1, NULL, 10);
        if (kill((pid_t)pid, 0) != 0 && errno == ESRCH)
            remove_work();
    }
    globfree(&found);
}

/* Returns whether `inner` is inside `outer`, or would be if it existed. The
   part of its path that exists is resolved, including links. */
static bool is_within(const char *inner, const char *outer)
{
    char path[4200], *real, *around = realpath(outer, NULL);
    bool within = false;
    snprintf(path, sizeof path, "%s", inner);
    while (!(real = realpath(path, NULL)) && strrchr(path, '/'))
        *strrchr(path, '/') = '\0';
    if (!real)
        real = realpath(".", NULL);
    if (real && around) {
        const size_t length = strlen(around);
        within = strncmp(real, around, length) == 0 &&
                 (!real[length] || real[length] == '/');
    }
    free(real);
    free(around);
    return within;
}

/* Refuses an output folder inside the folder of submissions, because the
   next run would mistake the results for submissions. */
static void refuse_results_within(const struct batch *b)
{
    if (is_within(b->settings.output, b->settings.folder))
        text_fail("--output: '%s' is in the folder of submissions, '%s'; "
                  "results belong somewhere else",
                  b->settings.output, b->settings.folder);
}

static void prepare_folders(struct batch *b)
{
    if (!getcwd(b->root, sizeof b->root - 64))
        text_fail("cannot name the working folder: %s", strerror(errno));
    char marks[4200];
    snprintf(marks, sizeof marks, "%s/marks", b->settings.output);
    refuse_results_within(b);
    make_folder(b->settings.output);
    make_folder(marks);
    remove_abandoned();
    snprintf(b->work, sizeof b->work, "%s/build/grade/%s%ld.XXXXXX",
             b->root, name_machine(), (long)getpid());
    if (!mkdtemp(b->work))
        text_fail("cannot make a folder '%s': %s", b->work,
                  strerror(errno));
    work_folder = b->work;
    b->grading = (struct grading){
        .root = b->root, .work = b->work, .seconds = b->settings.seconds};
}

static uint64_t draw_seed(void)
{
    uint64_t seed = 0;
    FILE *random = fopen("/dev/urandom", "r");
    if (!random || fread(&seed, sizeof seed, 1, random) != 1)
        text_fail("cannot read /dev/urandom: %s", strerror(errno));
    fclose(random);
    return seed;
}

/* Writes the seed to path in one step, because other graders may read the
   file. If `anew` is false and the file exists, keeps the old seed. Returns
   whether the new seed was written. */
static bool write_seed(const char *path, uint64_t seed, bool anew)
{
    char text[32];
    const int length = snprintf(text, sizeof text, "%" PRIu64 "\n", seed);
    const bool ours = replace_file(path, text, (size_t)length, 0600, !anew);
    if (!ours && (anew || errno != EEXIST))
        text_fail("cannot write '%s': %s", path, strerror(errno));
    return ours;
}

/* Sets the seed of the hidden tests. Without --hidden, the seed is drawn
   once and stored with the results, because all students must get the same
   inputs. */
static void choose_seed(struct batch *b)
{
    char path[4300];
    uint64_t seed = b->settings.seed;
    snprintf(path, sizeof path, "%s/hidden.seed", b->settings.output);
    if (b->settings.seeded) {
        write_seed(path, seed, true);
        b->grading.seed = seed;
        return;
    }
    FILE *file = fopen(path, "r");
    if (!file && errno == ENOENT) {
        seed = draw_seed();
        if (write_seed(path, seed, false)) {
            b->grading.seed = seed;
            return;
        }
        file = fopen(path, "r"); /* another grader has written it */
    }
    if (!file)
        text_fail("cannot read '%s': %s", path, strerror(errno));
    if (fscanf(file, "%" SCNu64, &seed) != 1)
        text_fail("there is no number in %s; remove it", path);
    fclose(file);
    chmod(path, 0600);
    b->grading.seed = seed;
}

static uint64_t sum_compiler(const char *flags)
{
    char command[128], said[1024] = "";
    snprintf(command, sizeof command,
             "PATH=/usr/bin:/bin; '%.*s' --version 2>/dev/null",
             (int)strcspn(flags, " '"), flags);
    FILE *version = popen(command, "r");
    const size_t length =
        version ? fread(said, 1, sizeof said, version) : 0;
    if (version)
        pclose(version);
    return sum_bytes(0, said, length);
}

static void choose_box(struct batch *b)
{
    char *flags = text_read("build/grade/flags"), *rest = flags;
    char *compiler = text_line(&rest);
    b->grading.kind = sandbox_probe(compiler);
    b->compiler = sum_compiler(compiler);
    free(flags);
    if (b->grading.kind != SANDBOX_NONE)
        return;
    fprintf(stderr,
            "grade: THE PROGRAMS OF STUDENTS CANNOT BE ISOLATED HERE. "
            "bubblewrap is missing\n"
            "(apt-get install --no-install-recommends bubblewrap), or this "
            "machine does not\n"
            "allow namespaces. They would see all files that you see, and "
            "the network.\n");
    if (!b->settings.unsafe) {
        remove_work();
        text_fail("nothing was run; to go on all the same: --unsafe (make "
                  "grade UNSAFE=1)");
    }
}

/* Returns a file name for the results of student s, different for each
   student. If the name is too long for a file system, it is cut and ends
   with a checksum of the whole name. */
static const char *encode(const struct batch *b, size_t s)
{
    static char name[1100];
    char *end = name;
    const char *entry = b->submissions[s].entry;
    for (; *entry && end < name + sizeof name - 8; ++entry)
        if (isalnum((unsigned char)*entry) || strchr("-_", *entry))
            *end++ = *entry;
        else
            end += sprintf(end, "%%%02X", (unsigned char)*entry);
    *end = '\0';
    if (end - name > 200)
        snprintf(name + 180, 20, "+%016" PRIx64,
                 sum_bytes(0, b->submissions[s].entry,
                           strlen(b->submissions[s].entry)));
    return name;
}

static void result_path(const struct batch *b, size_t s, size_t e,
                        char path[4400])
{
    snprintf(path, 4400, "%s/marks/%s", b->settings.output, encode(b, s));
    make_folder(path);
    snprintf(path + strlen(path), 32, "/%s.json", b->kits[e].exercise);
}

static void choose_student(struct batch *b)
{
    const char *job = b->settings.job;
    const size_t length = job ? strcspn(job, "/") : 0;
    for (size_t s = 0; job && s < b->count; ++s) {
        const char *name = encode(b, s);
        if (strlen(name) == length && strncmp(name, job, length) == 0) {
            b->submissions += s;
            b->count = 1;
            return;
        }
    }
    if (job)
        text_fail("--job: there is no student '%.*s'", (int)length, job);
}

static uint64_t sum_kit(const struct batch *b, const char *exercise)
{
    char path[64];
    snprintf(path, sizeof path, "build/grade/%s.judge", exercise);
    uint64_t sum = sum_file(0, path);
    snprintf(path, sizeof path, "build/grade/%s.inside.o", exercise);
    sum = sum_file(sum, path);
    sum = sum_file(sum, "build/grade/flags");
    sum = sum_number(sum, b->compiler);
    sum = sum_number(sum, b->grading.seed);
    sum = sum_number(sum, (uint64_t)b->grading.seconds);
    return sum_number(sum, (uint64_t)b->grading.kind);
}

/* Computes the key of a result, a checksum of everything that the result
   depends on. `kit` covers the judge, the objects linked with the student's
   file, the compiler and its flags, the seed, the time limit, the kind of
   sandbox and the script of the student's figure. The compiler is included
   because jobs may run on machines with different compilers, whose code
   rounds differently. If a new file happened to have the checksum of the
   old file, the student would keep the old marks. */
static void result_key(uint64_t kit, const char *bytes, size_t length,
                       const char *remark, const char *note, char key[24])
{
    uint64_t sum = bytes ? sum_bytes(kit, bytes, length) : kit;
    sum = sum_bytes(sum, remark, strlen(remark));
    sum = sum_bytes(sum, note, strlen(note));
    snprintf(key, 24, "%016" PRIx64, sum);
}

struct job {
    size_t student, exercise;
    char *bytes, *remark, *note;
    size_t length;
    char key[24], path[4400];
    int tries;
    const struct marks *before; /* marks of the first try, or NULL */
    struct grading_page page;   /* the figure of a project */
};

static struct marks blank_marks(const struct batch *b,
                                const struct job *job)
{
    return (struct marks){.student = b->submissions[job->student].name,
                          .exercise = b->kits[job->exercise].exercise,
                          .title = b->kits[job->exercise].title,
                          .file = job->remark,
                          .note = job->note,
                          .story = strdup(""),
                          .prints = strdup(""),
                          .advice = strdup(""),
                          .tries = job->tries};
}

static void write_by_hand(const struct batch *b, const char *place,
                          const char *bytes, size_t length)
{
    char path[4400];
    snprintf(path, sizeof path, "%s/%s", b->settings.output, place);
    if (!bytes) {
        unlink(path);
        return;
    }
    for (char *slash = path + strlen(b->settings.output) + 1;
         (slash = strchr(slash, '/')); ++slash) {
        *slash = '\0';
        make_folder(path);
        *slash = '/';
    }
    if (!replace_file(path, bytes, length, 0600, false))
        text_fail("cannot write '%s': %s", path, strerror(errno));
}

static char *copy_page(const struct batch *b, const struct job *job,
                       const char *ending, char place[1400], size_t *length,
                       char **refusal)
{
    char name[16];
    snprintf(name, sizeof name, "%s.%s", b->kits[job->exercise].exercise,
             ending);
    snprintf(place, 1400, "by-hand/%s/%s", encode(b, job->student), name);
    char *bytes =
        submissions_page(b->settings.folder, &b->submissions[job->student],
                         name, length, refusal);
    write_by_hand(b, place, bytes, *length);
    return bytes;
}

static void take_pages(const struct batch *b, struct job *job)
{
    static char place[1400];
    char *refusal;
    size_t length;
    free(copy_page(b, job, "txt", place, &length, &refusal));
    free(refusal);
    job->page.script = copy_page(b, job, "gp", place, &job->page.length,
                                 &job->page.refusal);
    strcpy(strrchr(place, '.'), ".png");
    job->page.place = place;
}

/* Grades a job in this child process, which then ends with _exit to skip
   the parent's clean-up. If the parent is killed, PR_SET_PDEATHSIG ends
   this process and with it the sandbox. If interrupted, writes nothing,
   because partial marks must not count. */
static _Noreturn void work(const struct batch *b, const struct job *job)
{
    struct marks marks = blank_marks(b, job);
    struct grading grading = b->grading;
    const double start = process_clock();
    struct grading_page page = job->page;
    grading.before = job->before;
    grading.page = page.place ? &page : NULL;
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
    grading_run(&grading, &b->kits[job->exercise], job->bytes, job->length,
                &marks);
    marks.seconds = process_clock() - start;
    if (process_signal() || chdir(b->root) != 0)
        _exit(EXIT_FAILURE);
    if (page.place)
        write_by_hand(b, page.place, page.figure, page.drawn);
    marks_write(&marks, job->key, job->path);
    _exit(EXIT_SUCCESS);
}

enum { MOST_JOBS = 1024 };

static pid_t workers[MOST_JOBS];
static struct pollfd ends[MOST_JOBS]; /* readable when a worker has ended */
static int running;

static void stop_workers(void)
{
    static double since;
    if (since == 0.0)
        since = process_clock();
    const bool polite = process_clock() - since < 5.0;
    for (int i = 0; i < running; ++i)
        kill(workers[i], polite ? SIGTERM : SIGKILL);
}

static void show_progress(const struct batch *b)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\rgrade: %zu of %zu", b->done,
                b->count * b->kit_count);
}

/* Waits until a worker has ended. Polls, because a signal that comes just
   before an unlimited wait would not end that wait. After a signal, stops
   the workers and, five seconds later, kills those still running. A worker
   that failed has written no result and is counted in b->failed. If the
   command is repeated, it grades that job again. */
static void wait_for_one(struct batch *b)
{
    int status, i = 0;
    pid_t pid;
    int nap = 50;
    for (int k = 0; k < running; ++k)
        nap = ends[k].fd < 0 ? 2 : nap;
    while ((pid = waitpid(-1, &status, WNOHANG)) <= 0) {
        if (process_signal())
            stop_workers();
        poll(ends, (nfds_t)running, nap);
    }
    while (i < running && workers[i] != pid)
        ++i;
    if (i == running)
        return;
    if (ends[i].fd >= 0)
        close(ends[i].fd);
    workers[i] = workers[--running];
    ends[i] = ends[running];
    if (status == 0)
        ++b->done;
    else if (!process_signal())
        ++b->failed;
    show_progress(b);
}

/* Prints a word, quoted for the shell. Refuses a line break, which would
   split the command. Students' names are encoded and have none. */
static void put_word(const char *word)
{
    if (strchr(word, '\n'))
        text_fail("a line break in '%s' cannot be listed", word);
    putchar('\'');
    for (; *word; ++word)
        if (*word == '\'')
            fputs("'\\''", stdout);
        else
            putchar(*word);
    putchar('\'');
}

/* Prints the command that grades one exercise of one student. A batch
   system can distribute these commands to machines. */
static void list_job(const struct batch *b, const struct job *job)
{
    printf("build/grade/grade --job %s/%s/%s --seconds %d%s --output ",
           encode(b, job->student), b->kits[job->exercise].exercise,
           job->key, b->settings.seconds,
           b->settings.unsafe ? " --unsafe" : "");
    put_word(b->settings.output);
    putchar(' ');
    put_word(b->settings.folder);
    putchar('\n');
}

/* Refuses a job whose key differs from the key in the list, because the
   file, the kit or the machine has changed since. */
static void check_job(const struct batch *b, const struct job *job)
{
    const char *asked = b->settings.job;
    if (!asked || strcmp(strrchr(asked, '/') + 1, job->key) == 0)
        return;
    remove_work();
    text_fail(
        "--job %s: the file, the kit, the seed, the compiler or the "
        "sandbox (%s) is not what it was when this was listed; list anew",
        asked, sandbox_name(b->grading.kind));
}

/* Starts a job as soon as fewer than --jobs jobs are running. With --list,
   only prints the command of the job. By default, --jobs is one more than
   the number of processors: with one job for each processor, a quarter of
   the time was idle, because jobs wait for disks and for programs that
   sleep, and judge and sandbox take turns. */
static void start_job(struct batch *b, const struct job *job)
{
    if (b->settings.list && job->bytes) {
        list_job(b, job);
        return;
    }
    check_job(b, job);
    ++b->begun;
    while (running >= b->settings.jobs)
        wait_for_one(b);
    if (process_signal())
        return;
    unlink(job->path);
    fflush(NULL);
    const pid_t pid = fork();
    if (pid < 0)
        text_fail("cannot start a process: %s", strerror(errno));
    if (pid == 0)
        work(b, job);
    workers[running] = pid;
    ends[running++] = (struct pollfd){process_watch(pid), POLLIN, 0};
}

/* Returns the index of the first student who handed in the same bytes as
   this job. Compares the bytes of files with equal checksums. */
static size_t first_alike(struct batch *b, uint64_t sum,
                          const struct job *job)
{
    size_t i = 0;
    while (i < b->alikes &&
           !(b->alike[i].sum == sum && b->alike[i].length == job->length &&
             memcmp(b->alike[i].bytes, job->bytes, job->length) == 0))
        ++i;
    if (i == b->alikes) {
        struct alike *a = &b->alike[b->alikes++];
        *a = (struct alike){sum, job->student, job->length,
                            text_must(malloc(job->length + 1))};
        memcpy(a->bytes, job->bytes, job->length);
    }
    return b->alike[i].student;
}

/* Copies the marks of the student `first`, who handed in the same file:
   equal files are graded only once. Returns false if that student has no
   marks. Projects are graded for each student, because of their figures. */
static bool copy_marks(struct batch *b, const struct job *job, size_t first)
{
    char path[4400];
    struct marks found;
    result_path(b, first, job->exercise, path);
    if (!marks_read(&found, NULL, path))
        return false;
    struct marks own = found;
    own.student = b->submissions[job->student].name;
    own.file = job->remark;
    own.note = job->note;
    marks_write(&own, job->key, job->path);
    marks_free(&found);
    ++b->done;
    show_progress(b);
    return true;
}

static void consider(struct batch *b, uint64_t kit, size_t s, size_t e,
                     enum round round)
{
    struct job job = {
        .student = s, .exercise = e, .tries = 1 + (round == RETRIED)};
    struct marks marks;
    size_t first = s;
    job.bytes = submissions_read(b->settings.folder, &b->submissions[s],
                                 b->kits[e].file, &job.length, &job.remark,
                                 &job.note);
    if (*b->kits[e].exercise == 'P')
        take_pages(b, &job);
    if (job.page.script)
        kit = sum_bytes(kit, job.page.script, job.page.length);
    else if (job.page.refusal)
        kit = sum_bytes(kit, job.page.refusal, strlen(job.page.refusal));
    result_key(kit, job.bytes, job.length, job.remark, job.note, job.key);
    result_path(b, s, e, job.path);
    const bool known = marks_read(&marks, job.key, job.path);
    const bool late = known && marks.tries == 1 && marks.late;
    if (job.bytes && !job.page.place && !b->settings.list)
        first = first_alike(b, sum_bytes(kit, job.bytes, job.length), &job);
    if (round == TRIED && known)
        ++b->done;
    if (round == RETRIED && late)
        job.before = &marks;
    if ((round == TRIED && !known && first == s) ||
        (round == RETRIED && late) ||
        (round == COPIED && !known && first != s &&
         !copy_marks(b, &job, first)))
        start_job(b, &job);
    while (round == RETRIED && running > 0)
        wait_for_one(b);
    marks_free(&marks);
    free(job.page.script);
    free(job.page.refusal);
    free(job.bytes);
    free(job.remark);
    free(job.note);
}

static void grade_round(struct batch *b, enum round round)
{
    for (size_t e = 0; e < b->kit_count; ++e) {
        const uint64_t kit = sum_kit(b, b->kits[e].exercise);
        while (b->alikes > 0)
            free(b->alike[--b->alikes].bytes);
        for (size_t s = 0; s < b->count && !process_signal(); ++s)
            consider(b, kit, s, e, round);
    }
    while (running > 0)
        wait_for_one(b);
}

/* Grades in three rounds. The first round grades all files, but equal files
   only once. The second round repeats, one at a time, the jobs that reached
   the wall-clock limit: on a busy machine a program may time out without
   being slow. A test that times out again earns nothing. The third round
   copies the marks of equal files. */
static void grade_all(struct batch *b)
{
    b->alike = text_must(calloc(b->count + 1, sizeof *b->alike));
    grade_round(b, TRIED);
    if (!b->settings.job || !b->begun)
        grade_round(b, RETRIED);
    grade_round(b, COPIED);
    while (b->alikes > 0)
        free(b->alike[--b->alikes].bytes);
    free(b->alike);
}

/* Reads the marks of all students. An exercise that could not be graded has
   no result and is reported as "not graded", never as zero points. */
static struct marks *read_results(const struct batch *b)
{
    char path[4400];
    struct marks *marks =
        text_must(calloc(b->count * b->kit_count, sizeof *marks));
    for (size_t i = 0; i < b->count * b->kit_count; ++i) {
        struct job job = {.student = i / b->kit_count,
                          .exercise = i % b->kit_count};
        result_path(b, job.student, job.exercise, path);
        if (marks_read(&marks[i], NULL, path))
            continue;
        job.remark = strdup("NOT GRADED: the grader failed");
        job.note = strdup("");
        marks[i] = blank_marks(b, &job);
    }
    return marks;
}

/* Writes the reports. Prints their folder, the seed and the kind of
   sandbox, which are needed to repeat the grading of the course. */
static void publish_all(struct batch *b)
{
    const char *list = b->settings.reports;
    char word[64], when[32];
    const time_t now = time(NULL);
    strftime(when, sizeof when, "%Y-%m-%dT%H:%M:%SZ", gmtime(&now));
    const char **notes = text_must(calloc(b->count + 1, sizeof *notes));
    for (size_t s = 0; s < b->count; ++s)
        notes[s] = b->submissions[s].notes;
    notes[b->count] = b->handed.nobody.notes;
    const struct course course = {
        b->count, b->kit_count,       read_results(b),
        notes,    b->settings.folder, sandbox_name(b->grading.kind),
        when};
    if (isatty(STDERR_FILENO))
        fputc('\n', stderr);
    publish("table", &course, b->settings.output);
    publish("csv", &course, b->settings.output);
    publish("notes", &course, b->settings.output);
    while (next_word(&list, word))
        publish(word, &course, b->settings.output);
    printf("Results and reports: %s/ (hidden seed %" PRIu64
           "; programs in: %s)\n",
           b->settings.output, b->grading.seed,
           sandbox_name(b->grading.kind));
    char hand[4300];
    snprintf(hand, sizeof hand, "%s/by-hand/notes.txt", b->settings.output);
    if (access(hand, F_OK) == 0)
        printf("What is for a human eye, line by line: %s\n", hand);
    *strrchr(hand, '/') = '\0';
    bool projects = false;
    for (size_t e = 0; e < b->kit_count; ++e)
        projects |= *b->kits[e].exercise == 'P';
    if (projects && access(hand, F_OK) == 0)
        printf("Figures and texts of projects, to be marked by you: %s/\n",
               hand);
    if (b->failed)
        fprintf(stderr,
                "grade: %zu could not be graded, see above; the "
                "same command tries them again\n",
                b->failed);
}

/* Finds all submissions. Exercises are chosen later; otherwise answers to
   other exercises of the course would be reported as stray files. With
   --job, reads only names with the same beginning as the student's, because
   there may be ten thousand students. */
static void find_submissions(struct batch *b)
{
    const char **usual = text_must(calloc(b->kit_count + 1, sizeof *usual));
    for (size_t i = 0; i < b->kit_count; ++i)
        usual[i] = b->kits[i].file;
    const char *job = b->settings.job ? b->settings.job : "";
    char *start = strndup(job, strcspn(job, "_%+/"));
    b->handed = submissions_find(b->settings.folder, usual, start);
    b->submissions = b->handed.list;
    b->count = b->handed.count;
    free(start);
    free(usual);
}

int main(int argc, char **argv)
{
    text_program = "grade";
    struct batch b = {.settings = read_settings(argc, argv)};
    b.kit_count = grading_kits(&b.kits);
    find_submissions(&b);
    choose_kits(&b);
    choose_student(&b);
    prepare_folders(&b);
    choose_seed(&b);
    choose_box(&b);
    process_catch_signals();
    signal(SIGPIPE, SIG_IGN);
    grade_all(&b);
    remove_work();
    if (process_signal())
        text_fail("interrupted with %zu of %zu graded; the same command "
                  "goes on from there",
                  b.done, b.count * b.kit_count);
    if (!b.settings.list && !b.settings.job)
        publish_all(&b);
    return b.failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
