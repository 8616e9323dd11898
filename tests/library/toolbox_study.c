/* The frame of a program of studies: what it reads, what it leaves behind
   when all is well, and what when something is not. Each case runs in a
   process of its own, since a wrong command ends it. */
#define UNIT_OWN_MAIN
#include "unit.h"

#include "library/toolbox_child.h"
#include "toolbox/study.h"

#include <signal.h>

#define TABLE "build/tests/study.dat"
#define SUMMARY "build/tests/study.txt"

static struct {
    double mass;
} own;

static void measure(struct study *s)
{
    table_column(s->out, "m", "kg", "mass");
    table_row(s->out, 1, (double[]){own.mass});
    table_count(s->summary, "seed", s->seed);
}

static void fall(struct study *s)
{
    measure(s);
    program_give_up("no ground");
}

static void interrupt(struct study *s)
{
    measure(s);
    raise(SIGTERM);
}

static void burst(struct study *s)
{
    measure(s);
    s->broken = true;
}

static const struct table_key keys[] = {{"seed", "1", "that was asked for"},
                                        {0}};

static const struct study_entry studies[] = {
    {"measure", measure, "a mass", keys},
    {"fall", fall, "to nowhere", keys},
    {"interrupt", interrupt, "itself", keys},
    {"burst", burst, "on the way", keys},
    {0}};

static const struct options_entry entries[] = {
    {"mass", 'm', "M", "of the body, kg (1)"}, {0}};

static void take(struct options *o, int letter)
{
    if (letter == 'm')
        own.mass = options_real(o, 0, 10);
}

static void check(struct options *o, const char *study)
{
    if (own.mass == 9)
        options_fail(o, "--mass: 9 is too heavy for %s", study);
    own.mass *= 2;
}

static uint64_t seeds;
static const char *drawing, *usual;
static void (*checked)(struct options *o, const char *study);
static const struct options_entry *own_entries;

static int program(void *argument)
{
    char *argv[17] = {"build/bin/drop"}, *text = argument;
    own.mass = 1;
    int argc = 1;
    for (; text && argc < 16; text = strchr(text, '\n')) {
        if (argc > 1)
            *text++ = '\0';
        argv[argc++] = text;
    }
    return study_main(&(struct study_program){.name = "drop",
                                              .purpose = "Drop things.",
                                              .events = "falls",
                                              .studies = studies,
                                              .usual = usual,
                                              .seeds = seeds,
                                              .drawing = drawing,
                                              .options = own_entries,
                                              .take = take,
                                              .check = checked},
                      argc, argv);
}

/* Runs the program with these arguments, one a line, after the files of
   the case before are gone. */
static struct child run(const char *arguments)
{
    char text[400];
    snprintf(text, sizeof text, "%s", arguments);
    remove(TABLE);
    remove(SUMMARY);
    return child_run(program, *text ? text : NULL, NULL);
}

/* What the file has, or "" if there is none. */
static const char *content(const char *path)
{
    static char text[2][2048];
    static int which;
    char *const t = text[which = 1 - which];
    FILE *file = fopen(path, "r");
    t[0] = '\0';
    if (file) {
        t[fread(t, 1, sizeof text[0] - 1, file)] = '\0';
        fclose(file);
    }
    return t;
}

#define FILES "\n--output\n" TABLE "\n--summary\n" SUMMARY

/* Does the line have the part; at its start, if that is the program's name,
   and at its end, if that is the end of the line? */
static bool says(const char *line, const char *part)
{
    const char *const at = strstr(line, part);
    const size_t length = strlen(part);
    return at && (at == line || strncmp(part, "drop: ", 6) != 0) &&
           (!length || part[length - 1] != '\n' || at[length] == '\0');
}

/* Runs the program; passes when it ends with this status, says this on
   standard error (NULL: nothing), and leaves a table and a summary in which
   these are (NULL: none). */
static void leaves(const char *arguments, int status, const char *said,
                   const char *table, const char *summary)
{
    const struct child c = run(arguments);
    const char *const got[] = {content(TABLE), content(SUMMARY)};
    const char *const parts[] = {table, summary};
    UNIT_EQUAL(c.status, status);
    UNIT_SAYS(c.out, "");
    UNIT_TRUE(said ? says(c.err, said) : !*c.err);
    for (int k = 0; k < 2; ++k)
        UNIT_TRUE(parts[k] ? strstr(got[k], parts[k]) != NULL : !*got[k]);
}

TEST(test_whole, "table and summary are whole")
{
    leaves(
        "--study\nmeasure\n--mass\n2.5\n--seed\n7" FILES, 0, NULL,
        "# command: drop --study measure --mass 2.5 --seed 7\n# seed: 7\n",
        "seed 7\n");
    UNIT_TRUE(strstr(content(TABLE), "# 1 m [kg] mass\n2.5\n"));
    UNIT_SAYS(content(SUMMARY), "seed 7\n");
}

TEST(test_usual, "nothing said: seed 1, standard output, no summary")
{
    const struct child c = run("-y\nmeasure");
    UNIT_TRUE(c.status == 0);
    UNIT_TRUE(strstr(c.out, "# seed: 1\n"));
    UNIT_TRUE(strstr(c.out, "\n1\n"));
    UNIT_TRUE(content(SUMMARY)[0] == '\0');
}

TEST(test_command, "a wrong command is refused before a file is opened")
{
    child_says(run(""), 2,
               "drop: --study is needed; drop --help lists them\n");
    leaves("--study\nfly" FILES, 2,
           "'fly' is not measure, fall, interrupt or burst", NULL, NULL);
    leaves("--study\nmeasure\n--mass\n11" FILES, 2, "drop: --mass: '11'",
           NULL, NULL);
    leaves("--study\nmeasure\n--seed\n101" FILES, 2, "drop: --seed: '101'",
           NULL, NULL);
}

TEST(test_same_place, "table and summary may not share a file")
{
    leaves("--study\nmeasure\n--summary\n-", 2, "both go to '-'", NULL,
           NULL);
    leaves("--study\nmeasure\n-o\n" TABLE "\n-S\n" TABLE, 2, "", NULL,
           NULL);
    leaves("--study\nmeasure\n-o\n/dev/null", 0, "", NULL, NULL);
}

TEST(test_no_file, "a file that cannot be written leaves none behind")
{
    leaves("--study\nmeasure\n-o\n" TABLE "\n-S\nbuild/nowhere/s", 1,
           "drop: ", NULL, NULL);
    leaves("--study\nmeasure\n-o\nbuild/nowhere/t\n-S\n" SUMMARY, 1, "",
           NULL, NULL);
    leaves("--study\nmeasure\n-o\n/dev/full\n-S\n" SUMMARY, 1, "", NULL,
           NULL);
}

TEST(test_ends, "what a study leaves that fails, is stopped or breaks off")
{
    leaves("--study\nfall" FILES, 1, "drop: no ground\n", NULL, NULL);
    leaves("--study\ninterrupt" FILES, 1, "drop: interrupted", "\n1\n",
           NULL);
    leaves("--study\nburst" FILES, 1, "", "\n1\n", NULL);
}

TEST(test_unnamed, "the usual study needs no name")
{
    usual = "burst";
    leaves("--output\n" TABLE, 1, "", "# command: drop\n", NULL);
    leaves("--study\nmeasure" FILES, 0, NULL, "", "");
    const struct child c = run("--help");
    UNIT_TRUE(strstr(c.out, "burst: on the way\n"));
    UNIT_TRUE(strstr(c.out, " (burst)\n"));
    UNIT_TRUE(strstr(c.out, "The summary says:\n"));
    drawing = "--study fall";
    child_says(run("--seed\n1" FILES), 2,
               "drop: --seed: means nothing without --study fall\n");
    drawing = usual = NULL;
}

TEST(test_check, "settings are looked at together")
{
    checked = check;
    leaves("--study\nmeasure\n--mass\n2" FILES, 0, NULL, "\n4\n", "");
    leaves("--mass\n9\n--study\nburst" FILES, 2,
           "drop: --mass: 9 is too heavy for burst\n", NULL, NULL);
    checked = NULL;
}

TEST(test_help, "--help lists the studies and the options")
{
    const struct child c = run("--help");
    UNIT_TRUE(c.status == 0);
    UNIT_TRUE(strstr(c.out, "Drop things."));
    UNIT_TRUE(strstr(c.out, "measure: a mass\n"));
    UNIT_TRUE(strstr(c.out, "interrupt: itself\n"));
    const char *mass = strstr(c.out, "--mass M"),
               *seed = strstr(c.out, "--seed S");
    UNIT_TRUE(mass && seed && mass < seed);
    UNIT_TRUE(!strstr(c.out, "The summary says"));
    UNIT_TRUE(strstr(run("--study\nmeasure\n--help").out,
                     "\n\nThe summary says:\n"
                     "  seed [1]                  that was asked for\n"));
}

TEST(test_no_seed, "no seeds: no option, and 0 in the head")
{
    own_entries = NULL;
    seeds = 0;
    leaves("--study\nmeasure\n--seed\n1" FILES, 2, "unknown option", NULL,
           NULL);
    leaves("--study\nmeasure" FILES, 0, NULL, "# seed: 0\n", "");
    own_entries = entries;
    seeds = 100;
}

TEST(test_drawing, "a seed for the studies that draw")
{
    drawing = "--study fall";
    child_says(
        run("--study\nmeasure\n--seed\n1" FILES), 2,
        "drop: --seed: means nothing with --study measure (only with "
        "fall)\n");
    leaves("--study\nfall\n--seed\n1" FILES, 1, "no ground", NULL, NULL);
    drawing = NULL;
}

int main(void)
{
    own_entries = entries;
    seeds = 100;
    const int status = unit_run("study");
    remove(TABLE);
    remove(SUMMARY);
    return status;
}
