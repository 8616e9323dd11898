/* Fuzzing the command lines of all programs: short runs that are right
   (commands.txt) are made wrong with options out of each program's --help,
   numbers at the edges, and files that were changed. Whatever is asked of
   it, a program ends in time, by itself or told to, with status 0, 1 or 2
   and a word about why, and leaves nothing but what was asked for.

     commands BIN FOLDER COMMANDS.TXT SEED FIRST COUNT JOBS

   BIN is absolute: programs under sanitizers. Command number n of a seed is
   always the same. FOLDER/failed keeps the files of those that failed. */
enum { MOST = 1 << 16 };
#include "mutate.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum {
    WORDS = 60,   /* of a command */
    OPTIONS = 40, /* of a program */
    LINES = 200,  /* of commands.txt */
    FILES = 60,   /* in a folder */
    NAME = 64,
    LINE = 1000,
    ROOM = 1 << 16,    /* for the words of a command */
    DISK = 8 << 20,    /* bytes to a file */
    TOLD = 3,          /* s of processor time until it is told to stop */
    DEAF = 16,         /* s: it should have stopped by now */
    IDLE = 60,         /* s on the wall without work: it waits for ever */
    SAID = 8,          /* lines about a failure, at most */
    STATUS_CRASH = 99, /* of a sanitizer */
};

struct option {
    char name[NAME], argument[NAME], help[LINE];
};

struct program {
    char name[NAME];
    struct option option[OPTIONS];
    size_t options;
};

struct command {
    char *word[WORDS + 1]; /* the program's name first */
    size_t words, used;
    char room[ROOM];
    const char *program;
    bool patient; /* it may well be long */
    long early;   /* it is told to stop at this look at it; 0: in time */
    bool told;    /* it has been told to stop */
    double spent; /* s of processor time */
    int status;   /* as waitpid has it */
    const char *why;
};

/* A file: its name and its bytes in one number. */
struct file {
    char name[NAME];
    uint64_t sum;
    size_t size;
    char last; /* byte */
};

struct folder {
    struct file file[FILES];
    size_t files;
};

/* What became of the commands. */
struct tally {
    size_t done, unable, refused, told, failed;
    double longest; /* s of processor time, of those that end themselves */
};

static const char *bin, *folder;
static char line[LINES][LINE];
static size_t usual[LINES], usuals, lines;

_Noreturn static void fail(const char *what, const char *which)
{
    fprintf(stderr, "commands: %s: %s\n", what, which);
    exit(2);
}

/* One of the words, between which stand bars, until the next call. */
static const char *one_of(struct random *r, const char *words)
{
    static char word[LINE];
    size_t n = 1;
    for (const char *p = words; *p; ++p)
        n += *p == '|';
    for (n = random_below(r, n); n > 0; --n)
        words = strchr(words, '|') + 1;
    snprintf(word, sizeof word, "%.*s", (int)strcspn(words, "|"), words);
    return word;
}

static bool chance(struct random *r, uint64_t percent)
{
    return random_below(r, 100) < percent;
}

/* ---- a command ------------------------------------------------------- */

static void add_word(struct command *c, const char *text)
{
    const size_t size = strlen(text) + 1;
    if (c->words == WORDS || c->used + size > ROOM)
        return;
    c->word[c->words++] = memcpy(c->room + c->used, text, size);
    c->used += size;
    c->word[c->words] = NULL;
}

static void add_words(struct command *c, const char *text)
{
    char copy[LINE];
    snprintf(copy, sizeof copy, "%s", text);
    for (char *rest = copy, *word; (word = strtok_r(rest, " ", &rest));)
        add_word(c, word);
    c->program = c->word[0];
}

static void print_command(FILE *out, const struct command *c)
{
    for (size_t i = 0; i < c->words; ++i) {
        const size_t length = strlen(c->word[i]);
        fprintf(out, i ? " '" : "'");
        for (const char *p = c->word[i]; *p && p < c->word[i] + 200; ++p)
            fprintf(out, *p == '\'' ? "'\\''" : "%c", *p);
        fprintf(out, "'%s", length > 200 ? "..." : "");
    }
    fputc('\n', out);
}

/* ---- running it ------------------------------------------------------ */

/* Only in a process that will become a program. */
static void become(const struct command *c, rlim_t disk)
{
    char path[LINE];
    const struct rlimit core = {0, 0}, file = {disk, disk},
                        time = {DEAF + 2, DEAF + 2};
    setrlimit(RLIMIT_CORE, &core);
    setrlimit(RLIMIT_FSIZE, &file);
    setrlimit(RLIMIT_CPU, &time);
    signal(SIGXFSZ, SIG_IGN); /* a full disk is an error of write */
    snprintf(path, sizeof path, "%s/%s", bin, c->program);
    const int in = open("/dev/null", O_RDONLY);
    const int out = open("../out", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    const int err = open("../err", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (in < 0 || out < 0 || err < 0 || dup2(in, 0) < 0 ||
        dup2(out, 1) < 0 || dup2(err, 2) < 0)
        _exit(98);
    close(in);
    close(out);
    close(err);
    execv(path, c->word);
    _exit(98);
}

static double clock_of(clockid_t id)
{
    struct timespec t = {0};
    clock_gettime(id, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Waits for its end; tells it to stop when it is time to. */
static void attend(struct command *c, pid_t child)
{
    clockid_t id = CLOCK_MONOTONIC;
    if (clock_getcpuclockid(child, &id) != 0)
        id = CLOCK_MONOTONIC;
    double worked = clock_of(CLOCK_MONOTONIC); /* when it last did */
    for (long wait = 1; waitpid(child, &c->status, WNOHANG) == 0;
         wait = wait < 20 ? wait + 1 : 20) {
        nanosleep(&(struct timespec){0, 1000000 * wait}, NULL);
        const double now = clock_of(CLOCK_MONOTONIC), last = c->spent;
        c->spent = clock_of(id);
        if (c->spent > last + 0.001)
            worked = now;
        if (!c->told && (c->spent > TOLD || wait == c->early)) {
            c->told = true;
            if (c->spent > TOLD && !c->patient)
                c->why = "it takes for ever";
            kill(child, SIGTERM);
        }
        if (c->spent > DEAF || now - worked > IDLE) {
            c->why = c->told ? "deaf to SIGTERM" : "it waits for ever";
            kill(child, SIGKILL);
            waitpid(child, &c->status, 0);
            return;
        }
    }
}

static void run(struct command *c, rlim_t disk)
{
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0)
        become(c, disk);
    if (child < 0)
        fail("fork", strerror(errno));
    attend(c, child);
}

/* ---- what a program can be asked ------------------------------------- */

static void read_option(struct program *p, const char *text)
{
    struct option *o = &p->option[p->options];
    if (p->options == OPTIONS)
        fail("too many options", p->name);
    *o = (struct option){.name = ""};
    const char *name = strstr(text, "--") + 2;
    const size_t length = strcspn(name, " \n");
    snprintf(o->name, sizeof o->name, "%.*s", (int)length, name);
    const char *rest = name + length;
    if (rest[0] == ' ' && rest[1] != ' ' && rest[1])
        sscanf(rest, " %63s", o->argument);
    snprintf(o->help, sizeof o->help, "%.900s",
             rest + 1 + strlen(o->argument));
    ++p->options;
}

static void read_help(struct program *p, const char *text)
{
    struct option *o = &p->option[p->options - (p->options > 0)];
    const size_t in = strspn(text, " ");
    const char *begin = text + in;
    const size_t used = strlen(o->help);
    if (in <= 6 && (strncmp(begin, "--", 2) == 0 ||
                    (begin[0] == '-' && strstr(begin, ", --"))))
        read_option(p, text);
    else if (p->options > 0 && in > 6)
        snprintf(o->help + used, sizeof o->help - used, " %s", begin);
}

/* The options of the program, of one scene if that is its word 1. */
static const struct program *program_of(const struct command *usual)
{
    static struct program all[LINES];
    static size_t known;
    char text[LINE], name[NAME];
    const bool scene = strcmp(usual->word[0], "scene") == 0;
    snprintf(name, sizeof name, "%s %s", usual->word[0],
             scene ? usual->word[1] : "");
    for (size_t i = 0; i < known; ++i)
        if (strcmp(all[i].name, name) == 0)
            return &all[i];
    struct program *p = &all[known++];
    memcpy(p->name, name, sizeof name);
    snprintf(text, sizeof text, "%s/%s --help 2>/dev/null", bin, name);
    FILE *help = popen(text, "r");
    while (help && fgets(text, sizeof text, help)) {
        text[strcspn(text, "\n")] = '\0';
        read_help(p, text);
    }
    if (help)
        pclose(help);
    return p;
}

/* ---- values ---------------------------------------------------------- */

static const char *small_number(struct random *r, bool whole)
{
    static const char wholes[] = "1|2|3|4|5|7|10|16|0|20";
    static const char reals[] =
        ".1|.2|.25|.3|.5|.15|.05|.01|1|2|3|0|-.5|1.5|.4|.75|0.999|.7";
    return whole ? one_of(r, wholes) : one_of(r, reals);
}

static const char *edge_number(struct random *r, struct command *c)
{
    static const char edges[] =
        "0|-0|-1|1e-320|5e-324|2.3e-308|1e308|1e309|nan|inf|-inf|0x1p3|"
        "1e|1e-9999|.|1 2|+1|-1e308|1e-17|1e-9|1e6|1e9|1e16|1e19|1e100|"
        "1e-100|1e30|1000000|1e154|1e-160|4294967296|9007199254740993|"
        "18446744073709551615|18446744073709551616";
    const char *edge = one_of(r, edges);
    const double value = fabs(strtod(edge, NULL));
    if (value >= 1e5 || (value > 1e-300 && value < 1e-5))
        c->patient = true;
    return edge;
}

/* A number, or as many as the argument has commas, or some more. */
static void draw_numbers(struct random *r, const char *argument, bool wild,
                         struct command *c, char value[])
{
    size_t n = 1;
    for (const char *p = argument; *p; ++p)
        n += *p == ',';
    if (strstr(argument, "..") || (wild && chance(r, 10)))
        n += random_below(r, 4);
    const bool whole = strspn(argument, "NKCBSID") > 0;
    const size_t bad = random_below(r, n);
    *value = '\0';
    for (size_t i = 0; i < n; ++i) {
        const size_t used = strlen(value);
        snprintf(value + used, LINE - used, "%s%s", i ? "," : "",
                 wild && i == bad ? edge_number(r, c)
                                  : small_number(r, whole));
    }
}

/* One of the words of the help. */
static void draw_name(struct random *r, const char *help, char value[])
{
    static const char *const letters = "abcdefghijklmnopqrstuvwxyz"
                                       "0123456789-";
    size_t n = 0;
    *value = '\0';
    for (const char *p = help; *(p += strcspn(p, letters));) {
        const size_t length = strspn(p, letters);
        if (random_below(r, ++n) == 0)
            snprintf(value, LINE, "%.*s", (int)length, p);
        p += length;
    }
}

static void draw_nonsense(struct random *r, char value[])
{
    static const char texts[] =
        "| |,|1,,2|%s%n%d|'|a\nb|\xff\xfe|-|--|-o|$(x)|all|NULL|:|1:2|"
        "mean:|x:0|x:99|speed:1,energy|distance:0:0|mean:energy|pefrl:0|"
        "pefrl:99999999999999999999|normal:0,0|beta:1,2,3,4,5|"
        "microcanonical:0|maxwell:-1|kepler";
    if (chance(r, 5)) {
        const size_t n = LINE - 2;
        memset(value, "9a,."[random_below(r, 4)], n);
        value[n] = '\0';
        return;
    }
    snprintf(value, LINE, "%s", one_of(r, texts));
}

static void draw_file(struct random *r, bool output, bool wild,
                      const struct folder *f, char value[])
{
    static const char good[] = "new.dat|new.dat|old.dat";
    static const char bad[] =
        "no/such/file|/dev/full|/dev/null|-||inside|old.dat/file|loop|"
        "new.dat.rows|new.dat";
    const char *file = f->file[random_below(r, f->files)].name;
    snprintf(value, LINE, "%s",
             wild     ? one_of(r, bad)
             : output ? one_of(r, good)
                      : file);
}

static bool is_output(const char *name)
{
    char barred[NAME + 2];
    snprintf(barred, sizeof barred, "|%s|", name);
    return strstr("|output|summary|save|chart|", barred) != NULL;
}

static void draw_option(struct random *r, const struct program *p,
                        const struct folder *f, bool wild,
                        struct command *c)
{
    const struct option *o = &p->option[random_below(r, p->options)];
    char name[NAME + 4], value[LINE] = "";
    if (!wild &&
        (strcmp(o->name, "help") == 0 || strcmp(o->name, "version") == 0))
        return;
    snprintf(name, sizeof name, "--%s", o->name);
    add_word(c, name);
    if (!*o->argument && !(wild && chance(r, 10)))
        return;
    if (wild && chance(r, 15))
        draw_nonsense(r, value);
    else if (strcmp(o->argument, "FILE") == 0)
        draw_file(r, is_output(o->name), wild, f, value);
    else if (strstr(o->argument, "NAME") || chance(r, 10) ||
             strlen(o->argument) > 3 * (1 + !!strchr(o->argument, ',')))
        draw_name(r, o->help, value);
    else
        draw_numbers(r, o->argument, wild, c, value);
    add_word(c, value);
}

/* ---- files ----------------------------------------------------------- */

static void write_text(const char *path, const struct text *t)
{
    FILE *f = fopen(path, "w");
    if (!f || fwrite(t->byte, 1, t->size, f) != t->size || fclose(f) != 0)
        fail(path, strerror(errno));
}

/* Puts a number at the edge in the place of a word. */
static void change_word(struct text *t, struct random *r, struct command *c)
{
    size_t at = random_below(r, t->size + 1), end;
    while (at > 0 && t->byte[at - 1] > ' ')
        --at;
    for (end = at; end < t->size && t->byte[end] > ' ';)
        ++end;
    const char *edge = edge_number(r, c);
    splice(t, at, end - at, edge, strlen(edge));
}

static void change_file(const struct file *f, struct random *r,
                        const struct folder *all, struct command *c)
{
    static struct text text, other;
    if (!read_text(f->name, &text) ||
        !read_text(all->file[random_below(r, all->files)].name, &other))
        return;
    c->patient = true;
    for (uint64_t k = 1 + random_below(r, 3); k > 0; --k)
        if (chance(r, 50))
            change_word(&text, r, c);
        else
            mutate(&text, &other, r);
    write_text(f->name, &text);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const struct file *)a)->name,
                  ((const struct file *)b)->name);
}

/* The files of the working folder. */
static void look(struct folder *f)
{
    struct stat is;
    DIR *d = opendir(".");
    f->files = 0;
    for (struct dirent *e; d && (e = readdir(d));) {
        struct file *to = &f->file[f->files];
        FILE *in = lstat(e->d_name, &is) == 0 && S_ISREG(is.st_mode)
                       ? fopen(e->d_name, "r")
                       : NULL;
        if (!in || f->files == FILES)
            continue;
        *to = (struct file){.sum = 14695981039346656037u};
        snprintf(to->name, NAME, "%.60s", e->d_name);
        for (int byte; (byte = getc(in)) != EOF; ++to->size) {
            to->sum = (to->sum ^ (uint64_t)byte) * 1099511628211u;
            to->last = (char)byte;
        }
        fclose(in);
        ++f->files;
    }
    if (d)
        closedir(d);
    qsort(f->file, f->files, sizeof f->file[0], by_name);
}

static void empty_folder(void)
{
    DIR *d = opendir(".");
    for (struct dirent *e; d && (e = readdir(d));)
        if (strcmp(e->d_name, "inside") != 0)
            unlink(e->d_name);
    if (d)
        closedir(d);
}

static void copy_here(const char *from)
{
    static struct text text;
    char path[LINE + NAME * 4];
    DIR *d = opendir(from);
    for (struct dirent *e; d && (e = readdir(d));) {
        snprintf(path, sizeof path, "%s/%s", from, e->d_name);
        if (e->d_name[0] != '.' && read_text(path, &text) && text.size > 0)
            write_text(e->d_name, &text);
    }
    if (d)
        closedir(d);
}

/* ---- what may not happen --------------------------------------------- */

static const struct file *find(const struct folder *f, const char *name)
{
    for (size_t i = 0; i < f->files; ++i)
        if (strcmp(f->file[i].name, name) == 0)
            return &f->file[i];
    return NULL;
}

/* Was this file asked for, itself or as a table's companion? */
static bool asked(const struct command *c, const char *name)
{
    for (size_t i = 1; i < c->words; ++i) {
        const char *word = c->word[i];
        const size_t n = strlen(word);
        if (n > 0 && strncmp(name, word, n) == 0 &&
            (!name[n] || strcmp(name + n, ".rows") == 0 ||
             strcmp(name + n, ".checkpoint") == 0))
            return true;
    }
    return false;
}

static const char *judge_file(const struct command *c,
                              const struct file *before,
                              const struct file *now)
{
    const int status = WIFEXITED(c->status) ? WEXITSTATUS(c->status) : 2;
    if (before && now->sum == before->sum)
        return NULL;
    if (strncmp(now->name, "bonkers.", 8) == 0)
        return "it leaves a temporary file";
    if (!asked(c, now->name))
        return "it writes to a file that was not asked for";
    if (status == 2)
        return "refused, and it wrote a file";
    if (now->size > 0 && now->last != '\n' &&
        !strstr(now->name, ".checkpoint") && !strstr(now->name, ".rows"))
        return "it leaves half a line";
    return NULL;
}

static const char *judge_files(const struct command *c,
                               const struct folder *before)
{
    static struct folder now;
    look(&now);
    for (size_t i = 0; i < now.files; ++i) {
        const char *name = now.file[i].name;
        const char *why = judge_file(c, find(before, name), &now.file[i]);
        if (why)
            return why;
    }
    for (size_t i = 0; i < before->files; ++i) {
        const char *name = before->file[i].name;
        if (!find(&now, name) && !strstr(name, ".rows") &&
            !strstr(name, ".checkpoint"))
            return "it takes a file away";
    }
    return NULL;
}

static const char *judge_words(const struct command *c)
{
    static struct text err;
    char begin[NAME];
    size_t count = 0;
    bool named = false, explains = false;
    read_text("../err", &err);
    err.byte[err.size < MOST ? err.size : MOST - 1] = '\0';
    snprintf(begin, sizeof begin, "%.60s: ", c->program);
    for (size_t i = 1; i < c->words; ++i)
        explains = explains || strncmp(c->word[i], "--exp", 5) == 0;
    for (char *p = (char *)err.byte; *p; p += strcspn(p, "\n"), p += !!*p) {
        named = named || strncmp(p, begin, strlen(begin)) == 0;
        ++count;
    }
    const char *text = (const char *)err.byte;
    if (strstr(text, "runtime error:") || strstr(text, "Sanitizer"))
        return "a sanitizer complains";
    if (WIFSIGNALED(c->status))
        return NULL;
    if (WEXITSTATUS(c->status) != 0 && !named)
        return "it does not say why";
    if (WEXITSTATUS(c->status) != 0 && count > SAID && !explains)
        return "it says too much";
    return NULL;
}

static const char *judge(const struct command *c,
                         const struct folder *before)
{
    const char *why = judge_words(c);
    if (why)
        return why;
    if (c->why)
        return c->why;
    if (WIFSIGNALED(c->status)
            ? !(c->told && WTERMSIG(c->status) == SIGTERM)
            : WEXITSTATUS(c->status) > 2)
        return "it crashes";
    return judge_files(c, before);
}

/* ---- all together ---------------------------------------------------- */

/* Makes the command number n of a seed, and the files that it reads. */
static void draw(struct command *c, struct folder *before, uint64_t seed,
                 uint64_t number)
{
    struct random r;
    random_seed(&r, seed * 1000003 + number);
    *c = (struct command){.words = 0};
    add_words(c, line[usual[random_below(&r, usuals)]]);
    const struct program *p = program_of(c);
    look(before);
    c->patient = strstr(c->program, "-s") || strstr(c->program, "bonk") ||
                 strcmp(c->program, "orbit") == 0;
    c->patient = c->patient && strcmp(c->program, "bonkers") != 0;
    if (chance(&r, 10))
        add_word(c, "-o"), add_word(c, "new.dat");
    for (uint64_t k = random_below(&r, 3); k > 0 && p->options > 0; --k)
        draw_option(&r, p, before, false, c);
    for (uint64_t k = chance(&r, 70) + chance(&r, 20);
         k > 0 && p->options > 0; --k)
        draw_option(&r, p, before, true, c);
    for (size_t i = 1; i < c->words; ++i) {
        char kept[NAME + 12];
        const struct file *f = find(before, c->word[i]);
        if (f && chance(&r, 25))
            change_file(f, &r, before, c);
        snprintf(kept, sizeof kept, "%.60s.%s", c->word[i],
                 chance(&r, 50) ? "rows" : "checkpoint");
        if ((f = find(before, kept)) && chance(&r, 50))
            change_file(f, &r, before, c);
    }
    if (p->options == 0 && c->words < 2)
        add_word(c, "nothing");
    if (chance(&r, 3)) {
        char value[LINE];
        draw_nonsense(&r, value);
        add_word(c, value);
    }
    c->early = chance(&r, 10) ? 1 + (long)random_below(&r, 15) : 0;
    look(before);
}

/* Keeps what is needed to see a failure again. */
static void report(const struct command *c, uint64_t seed, uint64_t number,
                   const char *why)
{
    char path[LINE];
    static struct text err;
    read_text("../err", &err);
    snprintf(path, sizeof path, "%s/failed/%llu-%llu", folder,
             (unsigned long long)seed, (unsigned long long)number);
    char here[LINE];
    if (getcwd(here, sizeof here) && rename(here, path) == 0 &&
        mkdir(here, 0777) == 0 && chdir(here) == 0)
        mkdir("inside", 0777);
    printf("%llu: %s (%s %d): ", (unsigned long long)number, why,
           WIFSIGNALED(c->status) ? "signal" : "status",
           WIFSIGNALED(c->status) ? WTERMSIG(c->status)
                                  : WEXITSTATUS(c->status));
    print_command(stdout, c);
    printf("    %.*s\n",
           (int)strcspn(err.size ? (char *)err.byte : "", "\n"),
           (char *)err.byte);
    fflush(stdout);
}

static void count_up(struct tally *t, const struct command *c)
{
    const int status = WIFEXITED(c->status) ? WEXITSTATUS(c->status) : 2;
    ++*(c->told       ? &t->told
        : status == 0 ? &t->done
        : status == 1 ? &t->unable
                      : &t->refused);
    if (!c->told)
        t->longest = fmax(t->longest, c->spent);
}

static struct tally run_some(uint64_t seed, uint64_t first, uint64_t count,
                             uint64_t jobs)
{
    static struct command c;
    static struct folder before;
    char seeds[LINE];
    struct tally t = {0};
    snprintf(seeds, sizeof seeds, "%s/seeds/now", folder);
    for (uint64_t n = first; n < first + count; n += jobs) {
        empty_folder();
        copy_here(seeds);
        draw(&c, &before, seed, n);
        run(&c, DISK);
        const char *why = judge(&c, &before);
        count_up(&t, &c);
        t.failed += why != NULL;
        if (why)
            report(&c, seed, n, why);
    }
    return t;
}

static void read_lines(const char *path)
{
    FILE *in = fopen(path, "r");
    while (in && lines < LINES && fgets(line[lines], LINE, in)) {
        line[lines][strcspn(line[lines], "\n")] = '\0';
        if (line[lines][0] && !strchr("#+!", line[lines][0]))
            usual[usuals++] = lines;
        ++lines;
    }
    if (!in || usuals == 0)
        fail("no commands in", path);
    fclose(in);
}

/* Makes FOLDER/name/now and goes there. */
static void enter(const char *name)
{
    char path[LINE];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    mkdir(path, 0777);
    snprintf(path, sizeof path, "%s/%s/now", folder, name);
    mkdir(path, 0777);
    if (chdir(path) != 0)
        fail(path, strerror(errno));
    mkdir("inside", 0777);
}

static void make_seeds(void)
{
    static struct command c;
    static const struct text old = {5, "old\n#"},
                             species = {24, "3 1 .1\n2 10 .2\n1 .5 .3\n"};
    enter("seeds");
    empty_folder();
    write_text("old.dat", &old);
    write_text("species", &species);
    for (size_t i = 0; i < lines; ++i) {
        const char sort = line[i][0];
        if (sort != '+' && sort != '!')
            continue;
        c = (struct command){.patient = true};
        add_words(&c, line[i] + 1);
        run(&c, sort == '!' ? 4000 : DISK);
        if (!WIFEXITED(c.status) || WEXITSTATUS(c.status) != (sort == '!'))
            fail("this made no seed", line[i]);
    }
}

int main(int argc, char *argv[])
{
    char name[NAME];
    if (argc != 8)
        fail("expected", "BIN FOLDER COMMANDS.TXT SEED FIRST COUNT JOBS");
    bin = argv[1];
    folder = argv[2];
    const uint64_t seed = strtoull(argv[4], NULL, 10);
    const uint64_t first = strtoull(argv[5], NULL, 10);
    const uint64_t count = (uint64_t)strtod(argv[6], NULL);
    const uint64_t jobs = strtoull(argv[7], NULL, 10);
    setenv("ASAN_OPTIONS",
           "exitcode=99:detect_leaks=0:allocator_may_return_null=1:"
           "max_allocation_size_mb=256:soft_rss_limit_mb=600",
           1);
    setenv("UBSAN_OPTIONS", "exitcode=99:print_stacktrace=1", 1);
    read_lines(argv[3]);
    make_seeds();
    snprintf(name, sizeof name, "%s/failed", folder);
    mkdir(name, 0777);
    int ends[2];
    if (pipe(ends) != 0)
        fail("pipe", strerror(errno));
    for (uint64_t k = 0; k < jobs; ++k)
        if (fork() == 0) {
            snprintf(name, sizeof name, "job%llu", (unsigned long long)k);
            enter(name);
            const struct tally t =
                run_some(seed, first + k, count - k, jobs);
            _exit(write(ends[1], &t, sizeof t) != sizeof t);
        }
    close(ends[1]);
    struct tally all = {0}, one;
    while (read(ends[0], &one, sizeof one) == sizeof one) {
        all.done += one.done;
        all.unable += one.unable;
        all.refused += one.refused;
        all.told += one.told;
        all.failed += one.failed;
        all.longest = fmax(all.longest, one.longest);
    }
    bool good = all.failed == 0;
    for (int status; wait(&status) > 0;)
        good = good && status == 0;
    printf("Fuzzed: %llu commands, %zu done (%.1f s at most), %zu refused, "
           "%zu unable, %zu told to stop: %zu failed\n",
           (unsigned long long)count, all.done, all.longest, all.refused,
           all.unable, all.told, all.failed);
    return good ? 0 : 1;
}
