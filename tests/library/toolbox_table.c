/* Tables: what is written, and what is left behind when writing fails.
   The cases that end a process run in one of their own. */
#define UNIT_OWN_MAIN
#include "unit.h"

#include "library/toolbox_child.h"
#include "toolbox/progress.h"
#include "toolbox/replace.h"
#include "toolbox/table.h"
#include "toolbox/version.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

static char folder[64]; /* where the tests work, and are */

static void write_file(const char *path, const char *text)
{
    FILE *f = fopen(path, "w");
    if (f && fputs(text, f) >= 0)
        fclose(f);
}

static bool file_is(const char *path, const char *text)
{
    char got[4096];
    FILE *f = fopen(path, "r");
    if (!f)
        return false;
    child_read(f, got);
    return strcmp(got, text) == 0;
}

/* How many files the folder has, and takes them away. */
static int sweep(void)
{
    int files = 0;
    DIR *d = opendir(".");
    for (struct dirent *e; d && (e = readdir(d));)
        if (strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0) {
            ++files;
            if (unlink(e->d_name) != 0)
                rmdir(e->d_name);
        }
    closedir(d);
    return files;
}

static int write_table(void *path)
{
    struct table *t = table_open("gas", path);
    if (!t)
        return 1;
    table_begin(t, "gas --seed 5", 5);
    table_column(t, "t", "s", "time");
    table_column(t, "n", "", "number");
    table_row(t, 2, (double[]){0.1, 3});
    table_row(t, 2, (double[]){1e-300, -INFINITY});
    return table_close(t) ? 0 : 1;
}

static const char written[] = "# gas (Bonkers) " TOOLBOX_VERSION "\n"
                              "# command: gas --seed 5\n"
                              "# seed: 5\n"
                              "# 1 t [s] time\n"
                              "# 2 n [1] number\n"
                              "0.10000000000000001 3\n"
                              "1e-300 -inf\n";

TEST(test_content, "head, columns and rows are as promised")
{
    struct child c = child_run(write_table, NULL, NULL);
    UNIT_TRUE(c.status == 0 && *c.err == '\0');
    UNIT_SAYS(c.out, written);
    c = child_run(write_table, "-", NULL);
    UNIT_TRUE(c.status == 0 && strcmp(c.out, written) == 0);
    c = child_run(write_table, "a", NULL);
    UNIT_TRUE(c.status == 0 && *c.out == '\0' && *c.err == '\0');
    UNIT_TRUE(file_is("a", written));
    UNIT_TRUE(sweep() == 1);
}

static const struct table_key keys[] = {
    {"energy", "J", "at the end"},
    {"<number>_events_<kind>", "1", "by number"},
    {"form", "word", "of the collision"},
    {"", "", "if there is one:"},
    {"strange", "1", "value"},
    {0}};

TEST(test_summary, "summaries are keys and values")
{
    struct table *t = table_open("gas", "s");
    table_keys(t, keys);
    table_real(t, "energy", 0.1);
    table_real(t, "strange", -NAN);
    table_count(t, "all_events_of_b", UINT64_MAX);
    table_text(t, "form", "cm");
    UNIT_TRUE(table_print(t, "%d free\n", 3));
    UNIT_TRUE(table_close(t));
    UNIT_TRUE(file_is("s", "energy 0.10000000000000001\nstrange nan\n"
                           "all_events_of_b 18446744073709551615\nform cm\n"
                           "3 free\n"));
    UNIT_TRUE(table_close(NULL));
    sweep();
}

/* Writes a summary of the keys named, with a space behind each. */
static int write_keys(void *argument)
{
    struct table *t = table_open("gas", "s");
    table_keys(t, keys);
    for (char *key = strtok(argument, " "); key; key = strtok(NULL, " "))
        table_count(t, key, 1);
    return table_close(t) ? 0 : 1;
}

static int with_keys(const char *text)
{
    char copy[100];
    snprintf(copy, sizeof copy, "%s", text);
    const struct child c = child_run(write_keys, copy, NULL);
    sweep();
    return c.status;
}

TEST(test_keys, "a summary has the keys of its list, and all")
{
    UNIT_TRUE(with_keys("energy 1_events_a form") == 0);
    UNIT_TRUE(with_keys("form 1_events_a 3_events_b energy strange") == 0);
    static const char *const wrong[] = {
        "energy 1_events_a form power",  "energy 1_events_ form",
        "energy _events_a form",         "energy 1_events_a",
        "energy 1_events_a form energy", "energy form"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; ++i)
        UNIT_TRUE(with_keys(wrong[i]) == 128 + SIGABRT);
}

TEST(test_round_trip, "seventeen digits bring every double back")
{
    double values[3] = {1.0 / 3, 0x1.fffffffffffffp+1023, 0x1p-1074};
    double got[3] = {0};
    struct table *t = table_open("gas", "r");
    UNIT_TRUE(table_row(t, 3, values));
    UNIT_TRUE(table_close(t));
    FILE *f = fopen("r", "r");
    UNIT_TRUE(f &&
              fscanf(f, "%lf %lf %lf", &got[0], &got[1], &got[2]) == 3);
    for (int i = 0; i < 3; ++i)
        UNIT_EQUAL(got[i], values[i]);
    if (f)
        fclose(f);
    sweep();
}

TEST(test_whole_or_absent, "the old file stays until the new is whole")
{
    write_file("a", "old\n");
    struct table *t = table_open("gas", "a");
    table_print(t, "key new\n");
    UNIT_TRUE(file_is("a", "old\n"));
    UNIT_TRUE(table_close(t));
    UNIT_TRUE(file_is("a", "key new\n"));
    t = table_open("gas", "a");
    table_print(t, "key newer\n");
    table_discard(t);
    table_discard(NULL);
    UNIT_TRUE(file_is("a", "key new\n"));
    UNIT_TRUE(sweep() == 1);
}

TEST(test_permissions, "permissions are kept, or the usual ones")
{
    struct stat s;
    const mode_t mask = umask(027);
    write_file("a", "old\n");
    chmod("a", 0604);
    UNIT_TRUE(table_close(table_open("gas", "a")));
    UNIT_TRUE(stat("a", &s) == 0 && (s.st_mode & 0777) == 0604);
    UNIT_TRUE(table_close(table_open("gas", "b")));
    UNIT_TRUE(stat("b", &s) == 0 && (s.st_mode & 0777) == 0640);
    umask(mask);
    sweep();
}

TEST(test_links, "a link is followed and stays a link")
{
    struct stat s;
    write_file("real", "old\n");
    UNIT_TRUE(symlink("real", "link") == 0);
    UNIT_TRUE(child_run(write_table, "link", NULL).status == 0);
    UNIT_TRUE(lstat("link", &s) == 0 && S_ISLNK(s.st_mode));
    UNIT_TRUE(file_is("real", written));
    UNIT_TRUE(symlink("nowhere", "loose") == 0);
    child_says(child_run(write_table, "loose", NULL), 1,
               "gas: cannot write 'loose': No such file or directory\n");
    UNIT_TRUE(sweep() == 3);
}

static void fails(const char *path, const char *stdout_file,
                  const char *reason)
{
    char line[256];
    const struct child c =
        child_run(write_table, (void *)path, stdout_file);
    snprintf(line, sizeof line, "gas: cannot write %s\n", reason);
    UNIT_TRUE(c.status == 1);
    UNIT_SAYS(c.err, line);
}

TEST(test_cannot_open, "what cannot be opened is named, with why")
{
    fails("none/a", NULL, "'none/a': No such file or directory");
    fails(".", NULL, "'.': Is a directory");
    write_file("file", "");
    fails("file/a", NULL, "'file/a': Not a directory");
    UNIT_TRUE(sweep() == 1);
    if (geteuid() == 0)
        return; /* nothing is forbidden to root */
    write_file("fixed", "old\n");
    chmod("fixed", 0444);
    fails("fixed", NULL, "'fixed': Permission denied");
    UNIT_TRUE(sweep() == 1);
    chmod(".", 0555);
    fails("a", NULL, "'a': Permission denied");
    chmod(".", 0755);
}

TEST(test_closed_stdout_is_not_the_table,
     "a closed stdout does not hinder a file")
{
    const struct child c = child_run(write_table, "a", "");
    UNIT_TRUE(c.status == 0 && *c.err == '\0');
    UNIT_TRUE(file_is("a", written));
    sweep();
}

/* Which descriptor of the three is closed when the table is opened, and is
   then written to by somebody else. */
static int print_beside(void *number)
{
    const int stray = *(int *)number;
    close(stray);
    struct table *t = table_open("gas", "a");
    table_print(t, "key table\n");
    (void)!write(stray, "screen\n", 7);
    return !table_close(t);
}

TEST(test_stray_output, "stray output never enters a table")
{
    for (int number = 0; number <= STDERR_FILENO; ++number) {
        UNIT_TRUE(child_run(print_beside, &number, NULL).status == 0);
        UNIT_TRUE(file_is("a", "key table\n"));
        sweep();
    }
}

/* A full disk is met through standard output only: a test that named a
   device as its file could replace it, if the library were broken and the
   user root. */
TEST(test_full_disk, "a full disk is an error")
{
    if (access("/dev/full", W_OK) == 0)
        fails(NULL, "/dev/full",
              "standard output: No space left on device");
    else
        UNIT_TRUE(true);
}

/* Lines or rows until one of them says that it could not be written. */
static int write_on(void *row)
{
    static struct table
        *volatile t; /* so that it does not count as leaked */
    int lines = 0;
    t = table_open("gas", NULL);
    while (lines < 100000 && (row ? table_row(t, 1, (double[]){1e-300})
                                  : table_print(t, "key value\n")))
        ++lines;
    return lines < 100000 ? 0 : 3;
}

TEST(test_stops_when_full, "a line that cannot be written says so")
{
    if (access("/dev/full", W_OK) != 0)
        return;
    UNIT_EQUAL(child_run(write_on, NULL, "/dev/full").status, 0);
    UNIT_EQUAL(child_run(write_on, "row", "/dev/full").status, 0);
}

static int open_no_more(void *path)
{
    struct rlimit old, none;
    if (getrlimit(RLIMIT_NOFILE, &old) != 0)
        return 3;
    none = old;
    none.rlim_cur = STDERR_FILENO + 1;
    if (setrlimit(RLIMIT_NOFILE, &none) != 0)
        return 4;
    const bool opened = table_open("gas", path);
    setrlimit(RLIMIT_NOFILE, &old); /* what ends the child may need it */
    return opened ? 0 : 1;
}

TEST(test_no_descriptor, "no descriptor for the temporary is an error")
{
    child_says(child_run(open_no_more, "a", NULL), 1,
               "gas: cannot write 'a': Too many open files\n");
    UNIT_TRUE(sweep() == 0);
}

/* Prints the text in parts, which end with a space, and leaves the table
   open. */
static int print_parts(void *text)
{
    static struct table
        *volatile t; /* so that it does not count as leaked */
    t = table_open("gas", NULL);
    for (const char *part = text; *part; part = strchr(part, ' ') + 1) {
        char own[32];
        snprintf(own, sizeof own, "%.*s", (int)(strchr(part, ' ') - part),
                 part);
        table_print(t, own); /* goes on with the head if it can */
    }
    return 0;
}

static int print_long_head(UNUSED void *unused)
{
    static struct table
        *volatile t; /* so that it does not count as leaked */
    t = table_open("gas", NULL);
    for (int line = 0; line < 2200; ++line) /* of 32 bytes each */
        table_print(t, "# head of a table of %9d\n", line);
    return 0;
}

/* A head waits, with what goes on with its lines; a line that does not, or
   a head of more than 64 KiB, writes it. */
TEST(test_head, "a head waits for a row, with all its lines")
{
    static const char *const waits[] = {"# ", "#a\n ", "#a\n #b\n ",
                                        "#a b\n ", "#a\n \n #b "};
    for (size_t i = 0; i < sizeof waits / sizeof *waits; ++i)
        UNIT_TRUE(child_run(print_parts, (void *)waits[i], NULL).out[0] ==
                  '\0');
    UNIT_SAYS(child_run(print_parts, "#a\n b\n ", NULL).out, "#a\nb\n");
    UNIT_SAYS(child_run(print_parts, "a\n #b\n ", NULL).out, "a\n#b\n");
    UNIT_TRUE(child_run(print_long_head, NULL, NULL).out[0] == '#');
}

/* The sums are those of the hash FNV-1a, whose author gives some. */
TEST(test_sum, "sums are those of FNV-1a")
{
    UNIT_TRUE(table_sum(TABLE_NOTHING, "", 0) ==
              UINT64_C(0xcbf29ce484222325));
    UNIT_TRUE(table_sum(TABLE_NOTHING, "a", 1) ==
              UINT64_C(0xaf63dc4c8601ec8c));
    UNIT_TRUE(table_sum(TABLE_NOTHING, "foobar", 6) ==
              UINT64_C(0x85944171f73967e8));
    UNIT_TRUE(table_sum(table_sum(TABLE_NOTHING, "foo", 3), "bar", 3) ==
              UINT64_C(0x85944171f73967e8));
    /* And of a table: of none of it, less than BUFSIZ and more. */
    struct table *t = table_open("gas", "a");
    char text[9216] = "";
    uint64_t sum = 0;
    for (size_t lines = 0; lines < 1000; ++lines) {
        const size_t length = 9 * lines;
        if (lines == 0 || lines == 10 || lines == 999) {
            UNIT_TRUE(table_sum_so_far(t, &sum));
            UNIT_TRUE(sum == table_sum(TABLE_NOTHING, text, length));
        }
        snprintf(text + length, 10, "line %03zu\n", lines);
        table_print(t, "%s", text + length);
    }
    UNIT_TRUE(9 * 999 > BUFSIZ);
    UNIT_TRUE(table_close(t));
    UNIT_TRUE(sweep() == 1);
}

static int sum_of_pipe(UNUSED void *unused)
{
    int ends[2];
    uint64_t sum;
    if (pipe(ends) != 0 || dup2(ends[1], STDOUT_FILENO) == -1)
        return 3;
    struct table *t = table_open("gas", NULL);
    const bool found = table_sum_so_far(t, &sum);
    table_discard(t);
    return found ? 4 : 0;
}

TEST(test_no_sum, "what cannot be read has no sum")
{
    UNIT_EQUAL(child_run(sum_of_pipe, NULL, NULL).status, 0);
}

TEST(test_cancel, "cancelling a file keeps errno")
{
    for (int removed = 0; removed < 2; ++removed) {
        char *temporary;
        const int file = replace_begin("out", REPLACE_USUAL, &temporary);
        UNIT_TRUE(file > STDERR_FILENO);
        close(file);
        UNIT_TRUE(!removed || unlink(temporary) == 0);
        errno = EDOM; /* nothing in here sets that */
        replace_cancel(temporary);
        UNIT_EQUAL(errno, EDOM);
        UNIT_EQUAL(sweep(), 0);
    }
}

static int replaces_input(void *path)
{
    return freopen("in", "r", stdin) && replace_loses(path, "-") ? 7 : 0;
}

TEST(test_replaces, "a table that would replace its input is known")
{
    write_file("in", "1\n");
    write_file("other", "1\n");
    write_file("-", "1\n");
    UNIT_TRUE(link("in", "hard") == 0 && symlink("in", "soft") == 0);
    UNIT_TRUE(replace_loses("in", "in"));
    UNIT_TRUE(replace_loses("hard", "in"));
    UNIT_TRUE(replace_loses("soft", "./in"));
    UNIT_TRUE(!replace_loses("other", "in"));
    UNIT_TRUE(!replace_loses("none", "in"));
    UNIT_TRUE(!replace_loses("in", "none"));
    UNIT_TRUE(!replace_loses("none", "none"));
    UNIT_TRUE(!replace_loses(NULL, "in"));
    UNIT_TRUE(!replace_loses("-", "./-")); /* standard output */
    UNIT_TRUE(!replace_loses("/dev/null", "/dev/null"));
    UNIT_EQUAL(child_run(replaces_input, "in", NULL).status, 7);
    UNIT_EQUAL(child_run(replaces_input, "other", NULL).status, 0);
    UNIT_EQUAL(child_run(replaces_input, "./-", NULL).status, 0);
    UNIT_TRUE(sweep() == 5);
}

static int open_only(void *path)
{
    return table_open("gas", path) ? 0 : 1;
}

TEST(test_closed_stdout, "a closed stdout is refused at once")
{
    child_says(child_run(open_only, NULL, ""), 1,
               "gas: cannot write standard output: Bad file descriptor\n");
}

static void refused_at_once(const char *path, const char *reason)
{
    char line[512];
    const struct child c = child_run(open_only, (void *)path, NULL);
    snprintf(line, sizeof line, "gas: cannot write '%.300s': %s\n", path,
             reason);
    UNIT_TRUE(c.status == 1);
    UNIT_SAYS(c.err, line);
}

TEST(test_names, "a bad name is refused at once, a long one taken")
{
    char name[257];
    memset(name, 'n', 256);
    name[256] = '\0';
    refused_at_once(name, "File name too long");
    refused_at_once("", "No such file or directory");
    refused_at_once("new/", "No such file or directory");
    refused_at_once("none/../a", "No such file or directory");
    UNIT_TRUE(sweep() == 0);
    name[255] = '\0';
    UNIT_TRUE(child_run(write_table, name, NULL).status == 0);
    UNIT_TRUE(file_is(name, written));
    UNIT_TRUE(child_run(write_table, name, NULL).status == 0);
    UNIT_TRUE(sweep() == 1);
    UNIT_TRUE(mkdir("folder", 0700) == 0);
    UNIT_TRUE(child_run(write_table, "folder/a", NULL).status == 0);
    UNIT_TRUE(file_is("folder/a", written));
    UNIT_TRUE(unlink("folder/a") == 0);
    UNIT_TRUE(sweep() == 1);
}

/* Writes a table to path while descriptor number writes to "log". */
struct given {
    const char *path;
    int number, flags;
};

static int write_given(void *argument)
{
    const struct given *g = argument;
    const int file = open("log", g->flags);
    if (file == -1 || dup2(file, g->number) == -1)
        return 3;
    if (file != g->number)
        close(file);
    const int status = write_table((void *)g->path);
    if (g->flags != O_RDONLY)
        (void)!write(g->number, "after\n", 6);
    return status;
}

/* Devices are named through links and descriptors only, as above. */
TEST(test_given_files, "a file given to write is added to")
{
    const char *paths[] = {"log", "./log", "hard", "soft"};
    char all[4096];
    struct stat old, new;
    snprintf(all, sizeof all, "precious\n%safter\n", written);
    for (size_t i = 0; i < 4 * 5; ++i) {
        const int numbers[] = {0, 1, 2, 5, 9};
        struct given g = {paths[i % 4], numbers[i / 4],
                          O_WRONLY | O_APPEND};
        write_file("log", "precious\n");
        UNIT_TRUE(link("log", "hard") == 0);
        UNIT_TRUE(symlink("log", "soft") == 0);
        UNIT_TRUE(stat("log", &old) == 0);
        UNIT_TRUE(child_run(write_given, &g, NULL).status == 0);
        UNIT_TRUE(stat("log", &new) == 0 && old.st_ino == new.st_ino);
        UNIT_TRUE(file_is("log", all));
        UNIT_TRUE(sweep() == 3);
    }
    /* Without O_APPEND both must share one place to write at. */
    struct given g = {"log", 1, O_WRONLY};
    write_file("log", "");
    UNIT_TRUE(child_run(write_given, &g, NULL).status == 0);
    UNIT_TRUE(file_is("log", all + strlen("precious\n")));
    /* A file that is only read is replaced, and may be read meanwhile. */
    g = (struct given){"log", 0, O_RDONLY};
    write_file("log", "old\n");
    UNIT_TRUE(stat("log", &old) == 0);
    UNIT_TRUE(child_run(write_given, &g, NULL).status == 0);
    UNIT_TRUE(stat("log", &new) == 0 && old.st_ino != new.st_ino);
    UNIT_TRUE(file_is("log", written));
    UNIT_TRUE(sweep() == 1);
    /* A shell cannot hand over a descriptor of two digits. */
    g = (struct given){"log", 10, O_WRONLY | O_APPEND};
    write_file("log", "old\n");
    UNIT_TRUE(child_run(write_given, &g, NULL).status == 0);
    UNIT_TRUE(file_is("log", written));
    UNIT_TRUE(sweep() == 1);
}

/* Nothing can be renamed to a name under /proc, nor made there. */
TEST(test_system_folders, "what lies under /dev or /proc is added to")
{
    char all[4096], path[64];
    struct given g = {"/proc/self/fd/20", 20, O_WRONLY | O_APPEND};
    struct stat s;
    UNIT_TRUE(true);
    if (access("/proc/self/fd", X_OK) == 0) {
        write_file("log", "precious\n");
        snprintf(all, sizeof all, "precious\n%safter\n", written);
        UNIT_TRUE(child_run(write_given, &g, NULL).status == 0);
        UNIT_TRUE(file_is("log", all));
        g.flags = O_RDONLY;
        write_file("log", "precious\n");
        UNIT_TRUE(child_run(write_given, &g, NULL).status == 0);
        UNIT_TRUE(file_is("log", all) == false);
        all[strlen(all) - strlen("after\n")] = '\0';
        UNIT_TRUE(file_is("log", all));
        UNIT_TRUE(sweep() == 1);
    }
    /* Files kept in memory are files. */
    snprintf(path, sizeof path, "/dev/shm/table-test-%ld", (long)getpid());
    if (stat("/dev/shm", &s) == 0 && access("/dev/shm", W_OK) == 0) {
        for (int i = 0; i < 2; ++i)
            UNIT_TRUE(child_run(write_table, path, NULL).status == 0);
        UNIT_TRUE(file_is(path, written));
        unlink(path);
    }
}

/* Opens one table after another; a name of "-" is standard output. */
static int open_two(void *paths)
{
    static struct table
        *volatile t[2]; /* so that neither counts as leaked */
    const char **path = paths;
    for (int i = 0; i < 2; ++i)
        if (!(t[i] = table_open("gas", path[i])))
            return i + 1;
    return 0;
}

static void clash(const char *first, const char *second,
                  const char *stdout_file, const char *named)
{
    const char *paths[] = {first, second};
    char line[256];
    const struct child c = child_run(open_two, paths, stdout_file);
    snprintf(line, sizeof line,
             "gas: cannot write %s: another output goes there already\n",
             named);
    UNIT_TRUE(c.status == 2);
    UNIT_SAYS(c.err, line);
}

static int open_again(void *path)
{
    struct table *t = table_open("gas", path), *u;
    table_discard(t);
    t = table_open("gas", path);
    u = table_open("gas", "other");
    return t && u && table_close(u) && table_close(t) ? 0 : 1;
}

static int open_in_child(void *path)
{
    struct table *t = table_open("gas", path);
    const struct child c = child_run(write_table, path, NULL);
    return table_close(t) ? c.status : 9;
}

/* Nothing exists at first, then both do, then they are one by a link. */
TEST(test_clashes, "two outputs to one file are refused")
{
    const char *devices[] = {NULL, "-"}, *two[] = {"a", "b"};
    UNIT_TRUE(mkdir("folder", 0700) == 0);
    UNIT_TRUE(symlink(".", "here") == 0);
    UNIT_TRUE(symlink("a", "soft") == 0);
    clash("a", "a", NULL, "'a'");
    clash("a", "folder/../a", NULL, "'folder/../a'");
    clash("here/a", "./a", NULL, "'./a'");
    write_file("a", "old\n");
    UNIT_TRUE(link("a", "hard") == 0);
    clash("a", "folder/../a", NULL, "'folder/../a'");
    clash("a", "soft", NULL, "'soft'");
    clash("hard", "a", NULL, "'a'");
    clash("a", "-", "a", "standard output");
    clash(NULL, "a", "a", "'a'");
    clash(NULL, "-", "a", "standard output");
    UNIT_TRUE(child_run(open_two, devices, "/dev/null").status == 0);
    UNIT_TRUE(child_run(open_two, two, NULL).status == 0);
    UNIT_TRUE(child_run(open_again, "a", NULL).status == 0);
    UNIT_TRUE(child_run(open_in_child, "a", NULL).status == 0);
    UNIT_TRUE(rmdir("folder") == 0);
    UNIT_TRUE(sweep() == 5);
}

/* Two outputs into one pipe would come out mixed. */
TEST(test_clash_in_pipe, "two outputs to one pipe are refused")
{
    UNIT_TRUE(mkfifo("pipe", 0600) == 0);
    const int end = open("pipe", O_RDONLY | O_NONBLOCK);
    clash("pipe", "./pipe", NULL, "'./pipe'");
    close(end);
    UNIT_TRUE(sweep() == 1);
}

TEST(test_named_pipe, "a named pipe is written as it is")
{
    char got[4096] = "";
    struct stat s;
    UNIT_TRUE(mkfifo("pipe", 0600) == 0);
    const int end = open("pipe", O_RDONLY | O_NONBLOCK);
    UNIT_TRUE(child_run(write_table, "pipe", NULL).status == 0);
    UNIT_TRUE(stat("pipe", &s) == 0 && S_ISFIFO(s.st_mode));
    UNIT_TRUE(read(end, got, sizeof got - 1) > 0);
    UNIT_SAYS(got, written);
    close(end);
    UNIT_TRUE(sweep() == 1);
}

/* Rows until writing fails, at most a million. */
static int write_much(void *path)
{
    struct table *t = table_open("gas", path);
    int rows = 0;
    if (!t)
        return 3;
    while (rows < 1000000 && table_row(t, 1, (double[]){rows}))
        ++rows;
    if (rows == 1000000)
        return 4;
    return table_close(t) ? 0 : 1;
}

static int write_limited(void *path)
{
    const struct rlimit limit = {20000, 20000};
    setrlimit(RLIMIT_FSIZE, &limit);
    return write_much(path);
}

TEST(test_file_limit, "a file-size limit leaves the old file")
{
    write_file("a", "old\n");
    child_says(child_run(write_limited, "a", NULL), 1,
               "gas: cannot write 'a': File too large\n");
    UNIT_TRUE(file_is("a", "old\n"));
    UNIT_TRUE(sweep() == 1);
}

static int write_closed_pipe(void *path)
{
    int ends[2];
    if (pipe(ends) != 0)
        return 5;
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    return write_much(path);
}

TEST(test_closed_pipe, "a closed pipe is an error")
{
    child_says(child_run(write_closed_pipe, NULL, NULL), 1,
               "gas: cannot write standard output: Broken pipe\n");
}

static int too_many(UNUSED void *argument)
{
    static struct table
        *volatile tables[10]; /* so that none counts as leaked */
    char name[] = "0";
    for (int i = 0; i < 10; ++i, ++name[0])
        if (!(tables[i] = table_open("gas", name)))
            return name[0];
    return 0;
}

TEST(test_too_many, "a ninth file is refused")
{
    child_says(child_run(too_many, NULL, NULL), '8',
               "gas: cannot write '8': Too many open files\n");
    UNIT_TRUE(sweep() == 0);
}

/* Opens a table, then ends as the signal says; 0: by exit. */
static int end_early(void *number)
{
    const int signal_number = *(int *)number;
    static struct table
        *volatile t; /* so that it does not count as leaked */
    t = table_open("gas", "a");
    table_print(t, "key half\n");
    if (signal_number)
        raise(signal_number);
    return 7;
}

TEST(test_early_end, "an early end leaves no temporary")
{
    int numbers[] = {0, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGABRT, SIGXCPU};
    write_file("a", "old\n");
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; ++i) {
        const struct child c = child_run(end_early, &numbers[i], NULL);
        UNIT_TRUE(c.status == (numbers[i] ? 128 + numbers[i] : 7));
        UNIT_TRUE(file_is("a", "old\n"));
    }
    UNIT_TRUE(sweep() == 1);
}

static int hold_and_fork(UNUSED void *argument)
{
    struct table *t = table_open("gas", "a");
    int status;
    table_print(t, "key whole\n");
    fflush(NULL);
    const pid_t pid = fork();
    if (pid == 0)
        exit(0);
    waitpid(pid, &status, 0);
    return !table_close(t);
}

TEST(test_fork, "a child leaves its parent's temporary")
{
    UNIT_TRUE(child_run(hold_and_fork, NULL, NULL).status == 0);
    UNIT_TRUE(file_is("a", "key whole\n"));
    UNIT_TRUE(sweep() == 1);
}

/* A run of ten steps that is asked to stop after four; the argument says
   how often. */
static int interrupted(void *times)
{
    struct progress p;
    struct table *t = table_open("gas", "a");
    progress_catch_signals();
    progress_begin(&p, "gas", 10, "steps");
    for (uint64_t i = 0; i < 10 && !progress_signal(); ++i) {
        table_print(t, "step %d\n", (int)i);
        progress_update(&p, i + 1, i + 1);
        for (int k = 0; i == 3 && k < *(int *)times; ++k)
            raise(SIGTERM);
    }
    const bool whole = progress_end(&p);
    return table_close(t) && whole ? 0 : 1;
}

TEST(test_interrupt, "a signal ends a run with what it has")
{
    int times = 1;
    struct child c = child_run(interrupted, &times, NULL);
    UNIT_TRUE(c.status == 1);
    UNIT_SAYS(c.err, "gas: interrupted; 40 % was done\n");
    UNIT_TRUE(file_is("a", "step 0\nstep 1\nstep 2\nstep 3\n"));
    UNIT_TRUE(sweep() == 1);
    times = 2;
    c = child_run(interrupted, &times, NULL);
    UNIT_TRUE(c.status == 128 + SIGTERM);
    UNIT_TRUE(sweep() == 0);
    times = 0;
    c = child_run(interrupted, &times, NULL);
    UNIT_TRUE(c.status == 0 && *c.err == '\0');
    UNIT_TRUE(sweep() == 1);
}

int main(void)
{
    const char *base = getenv("TMPDIR");
    snprintf(folder, sizeof folder, "%.40s/table-XXXXXX",
             base ? base : "/tmp");
    if (!mkdtemp(folder) || chdir(folder) != 0) {
        printf("not ok table: cannot work in %s\n", folder);
        return 1;
    }
    const int failed = unit_run("table");
    sweep();
    if (chdir("/") == 0)
        rmdir(folder);
    return failed;
}
