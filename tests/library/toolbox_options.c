/* The command line: what is read, what is refused, and with which words.
   Each case runs in a process of its own, since a refusal ends it. */
#include "unit.h"

#include "library/toolbox_child.h"
#include "toolbox/options.h"
#include "toolbox/table.h"
#include "toolbox/version.h"

#include <inttypes.h>

static const struct options_entry entries[] = {
    {"particles", 'n', "N", "how many particles"},
    {"restitution", 0, "E", "ratio of the speeds\nafter and before"},
    {"seed", 0, "S", "seed of the random numbers"},
    {"velocities", 0, "U1,U2", "velocities before"},
    {"form", 0, "NAME", "which formula"},
    {"mass", 0, "M", "a mass"},
    {"quick", 'q', NULL, "do less"},
    {"output", 'o' | OPTIONS_SILENT | OPTIONS_WRITES, "FILE",
     "where to write"},
    {"name", 0, "TEXT", "any text"},
    {"atmost", 0, "X", "open below"},
    {"free", 0, "X", "open on both sides"},
    {"capped", 0, "X", "more than 0"},
    {0}};

static const struct options_entry with_arguments[] = {
    {"quick", 'q', NULL, "do less"}, {"", 0, "FILE", NULL}, {0}};

static const struct table_key keys[] = {
    {"energy", "J", "of all\nparticles"},
    {"", "", "if --mass:"},
    {"mean_energy_of_<particle>", "J", "of one"},
    {0}};

static const struct options_entry with_headings[] = {
    {"study", 0, "NAME", "run, cost or measure (run)"},
    {"ensemble", 'E', "K", "this many"},
    {"box", 0, "L", "its side"},
    {"quick", 'q', NULL, "do less"},
    {"scene", 0, "NAME", "which"},
    {"", 0, NULL, "--study run, cost"},
    {"mass", 'm', "M", "of the piston"},
    {"length", 0, "L", "of the box"},
    {"", 0, NULL, "--study measure; --ensemble"},
    {"window", 0, "T", "in seconds"},
    {"", 0, NULL, "no --box; no --quick"},
    {"packing", 0, "P", "a share"},
    {"", 0, NULL, "no --scene b, c"},
    {"rate", 0, "R", "of all but two"},
    {"", 0, NULL, "--scene a"},
    {"factor", 0, "F", "of a"},
    {"", 0, NULL, NULL},
    {"output", 'o' | OPTIONS_SILENT | OPTIONS_WRITES, "FILE",
     "where to write"},
    {"", 0, "FILE", NULL},
    {0}};

static const struct options_entry *list;

/* Prints what each option gives, and last the command. */
static void read_option(struct options *o, int code)
{
    static const char *const forms[] = {"cm", "difference", "impulse",
                                        NULL};
    double v[2];
    if (list == with_headings)
        return;
    switch (code) {
    case 'n':
        printf("n=%" PRIu64 "\n", options_count(o, 1, 10000000));
        break;
    case OPTIONS_LONG + 1:
        printf("e=%.17g\n", options_real(o, 0, 1));
        break;
    case OPTIONS_LONG + 2:
        printf("seed=%" PRIu64 "\n", options_count(o, 0, UINT64_MAX));
        break;
    case OPTIONS_LONG + 3:
        v[1] = 99;
        printf("values=%zu", options_list(o, v, 2));
        printf(" %g %g\n", v[0], v[1]);
        break;
    case OPTIONS_LONG + 4:
        printf("form=%zu\n", options_choice(o, forms));
        break;
    case OPTIONS_LONG + 5:
        printf("m=%g\n", options_real(o, OPTIONS_POSITIVE, INFINITY));
        break;
    case OPTIONS_LONG + 9:
        printf("x=%g\n", options_real(o, -INFINITY, 3));
        break;
    case OPTIONS_LONG + 10:
        printf("x=%g\n", options_real(o, -INFINITY, INFINITY));
        break;
    case OPTIONS_LONG + 11:
        printf("x=%g\n", options_real(o, OPTIONS_POSITIVE, 3));
        break;
    default:
        printf("%d=%s\n", code, options_text(o) ? options_text(o) : "-");
    }
}

static int program(void *argument)
{
    char *argv[17] = {"build/bin/gas"}, *text = argument;
    int argc = 1;
    struct options o;
    /* One argument a line, since arguments may have spaces or be empty. */
    for (; text; ++argc) {
        argv[argc] = text;
        text = strchr(text, '\n');
        if (text)
            *text++ = '\0';
    }
    options_begin(&o, "gas", "Move particles.", list, argc, argv);
    options_keys(&o, list == with_arguments ? NULL : keys);
    for (int code; (code = options_next(&o)) != -1;)
        read_option(&o, code);
    if (list == with_headings)
        options_refuse(&o, "box", "without a scene");
    printf("%s\n", options_command(&o));
    if (list == with_arguments)
        options_fail(&o, "need %d files", 2);
    return 0;
}

static struct child run(const char *arguments)
{
    static char text[1024];
    snprintf(text, sizeof text, "%s", arguments ? arguments : "");
    return child_run(program, arguments ? text : NULL, NULL);
}

static void accepted(const char *arguments, const char *out)
{
    const struct child c = run(arguments);
    if (strcmp(c.out, out) != 0 || *c.err)
        printf("# '%s' gave:\n# %s# %s# not:\n# %s", arguments, c.out,
               c.err, out);
    UNIT_TRUE(c.status == 0);
    UNIT_SAYS(c.out, out);
    UNIT_TRUE(*c.err == '\0');
}

static void refused(const char *arguments, const char *err)
{
    const struct child c = run(arguments);
    char line[512];
    snprintf(line, sizeof line, "gas: %s\n", err);
    UNIT_TRUE(c.status == OPTIONS_FAILURE);
    UNIT_SAYS(c.err, line);
    UNIT_TRUE(strstr(c.out, "gas") == NULL);
}

TEST(test_count, "whole numbers are read exactly")
{
    list = entries;
    accepted(NULL, "gas\n");
    accepted("--particles\n12", "n=12\ngas --particles 12\n");
    accepted("-n1e6", "n=1000000\ngas --particles 1e6\n");
    accepted("-n\n2.5E+3", "n=2500\ngas --particles 2.5E+3\n");
    accepted("-n300e-2", "n=3\ngas --particles 300e-2\n");
    accepted("-n10000000", "n=10000000\ngas --particles 10000000\n");
    accepted("--seed=18446744073709551615",
             "seed=18446744073709551615\n"
             "gas --seed 18446744073709551615\n");
    accepted("--seed\n0e99", "seed=0\ngas --seed 0e99\n");
}

/* Each text of a list is refused as a value. */
static void each_refused(const char *option, const char *values,
                         const char *why)
{
    char text[80];
    while (unit_item(&values, text)) {
        char arguments[100], message[160];
        snprintf(arguments, sizeof arguments, "--%s\n%s", option, text);
        snprintf(message, sizeof message, "--%s: '%s' is not %s", option,
                 text, why);
        refused(arguments, message);
    }
}

TEST(test_count_refused, "what is no whole number is refused")
{
    list = entries;
    each_refused("particles",
                 "ten|| 3|3 |-3|+3|0x10|1.5|1e-1|1e|1e+|1e1x|5x|.|e3|nan|"
                 "inf|1e8|0|10000001|1,5|1e99999999999999999999|"
                 "1e-99999999999999999999|",
                 "a whole number from 1 to 10000000");
    each_refused("seed", "18446744073709551616|1e20|",
                 "a whole number from 0 to 18446744073709551615");
}

TEST(test_real, "real numbers keep to their range")
{
    list = entries;
    accepted("--restitution\n0.1",
             "e=0.10000000000000001\ngas --restitution 0.1\n");
    accepted("--restitution\n1", "e=1\ngas --restitution 1\n");
    accepted("--restitution=+5e-1", "e=0.5\ngas --restitution +5e-1\n");
    accepted("--mass\n1e-320", "m=9.99989e-321\ngas --mass 1e-320\n");
    each_refused("restitution",
                 "2|-0.1|| 1|1 |x|0x1|nan|inf|-inf|infinity|1e999|1e|0,5|"
                 "1..0|1.0000000000000003|",
                 "a number from 0 to 1");
    refused("--mass\n0", "--mass: '0' is not a number more than 0");
    refused("--mass\n1e999", "--mass: '1e999' is not a number more than 0");
    refused("--free\ninf", "--free: 'inf' is not a number");
    refused("--free\n-1e999", "--free: '-1e999' is not a number");
    refused("--atmost\n4", "--atmost: '4' is not a number of at most 3");
    refused("--free\nabc", "--free: 'abc' is not a number");
    refused("--capped\n0",
            "--capped: '0' is not a number more than 0, at most 3");
}

TEST(test_list, "lists are read number by number")
{
    list = entries;
    accepted("--velocities\n-1,2.5",
             "values=2 -1 2.5\ngas --velocities -1,2.5\n");
    accepted("--velocities\n7", "values=1 7 99\ngas --velocities 7\n");
    refused("--velocities\n1,2,3",
            "--velocities: '1,2,3' has more than 2 numbers");
    refused("--velocities\n1,two",
            "--velocities: 'two' in '1,two' is not a number");
    /* Cut at 63 characters these would be numbers. */
    refused(
        "--velocities\n1,"
        "0000000000000000000000000000000000000000000000000000000000000011",
        "--velocities: "
        "'000000000000000000000000000000000000000000000000000000000000001' "
        "in '1,"
        "0000000000000000000000000000000000000000000000000000000000000011'"
        " is not a number");
    accepted(
        "--velocities\n"
        "000000000000000000000000000000000000000000000000000000000000001",
        "values=1 1 99\ngas --velocities "
        "000000000000000000000000000000000000000000000000000000000000001"
        "\n");
    refused("--velocities\n1,", "--velocities: '' in '1,' is not a number");
    refused("--velocities\n", "--velocities: '' in '' is not a number");
}

TEST(test_choice, "one of several names is chosen")
{
    list = entries;
    accepted("--form\ncm", "form=0\ngas --form cm\n");
    accepted("--form\nimpulse", "form=2\ngas --form impulse\n");
    refused("--form\nc", "--form: 'c' is not cm, difference or impulse");
    refused("--form\n", "--form: '' is not cm, difference or impulse");
}

TEST(test_unknown, "unknown options and stray arguments exit 2")
{
    list = entries;
    refused("--speed", "unknown option '--speed'; see gas --help");
    refused("--speed=3", "unknown option '--speed=3'; see gas --help");
    refused("-z", "unknown option '-z'; see gas --help");
    refused("-qz", "unknown option '-z'; see gas --help");
    refused("--particles",
            "--particles: needs a value, N: how many particles");
    refused("-n", "--particles: needs a value, N: how many particles");
    refused("--restitution", "--restitution: needs a value, E: ratio of "
                             "the speeds after and before");
    refused("--quick=3", "'--quick=3': this option takes no value");
    refused("--help=3", "'--help=3': this option takes no value");
    refused("foo", "'foo' is not an option; see gas --help");
    refused("-", "'-' is not an option; see gas --help");
    refused("--\n-q", "'-q' is not an option; see gas --help");
}

TEST(test_abbreviated, "names may be cut short while clear")
{
    list = entries;
    accepted("--part\n3", "n=3\ngas --particles 3\n");
    accepted("--se=3", "seed=3\ngas --seed 3\n");
    refused("--f=3", "'--f=3' may mean --form or --free");
    refused("--part\nx", "--particles: 'x' is not a whole number from 1 to "
                         "10000000");
}

TEST(test_command, "the command is recorded in full names")
{
    list = entries;
    accepted("-qn3\n-o\nfile", "113=-\nn=3\n111=file\n"
                               "gas --quick --particles 3\n");
    accepted("--out=file\n-ofile", "111=file\n111=file\ngas\n");
    accepted("--name\nit's $5", "264=it's $5\n"
                                "gas --name 'it'\\''s $5'\n");
    accepted("--name\n", "264=\ngas --name ''\n");
}

TEST(test_arguments, "arguments are taken where they are allowed")
{
    struct child c;
    list = with_arguments;
    c = run("one\n-q\n--\n-two");
    UNIT_TRUE(c.status == OPTIONS_FAILURE);
    UNIT_SAYS(c.out, "1=one\n113=-\n1=-two\n"
                     "gas one --quick -two\n");
    UNIT_SAYS(c.err, "gas: need 2 files\n");
}

TEST(test_headings, "an option that means nothing is refused")
{
    list = with_headings;
    accepted("--mass\n3\n-oX", "gas --mass 3\n");
    accepted("--length\n3\n--study\ncost", "gas --length 3 --study cost\n");
    accepted("--window\n1\n-E3\n--study\nmeasure",
             "gas --window 1 --ensemble 3 --study measure\n");
    accepted("--packing\n1\nfile", "gas --packing 1 file\n");
    accepted("--factor\n1\n--scene\na", "gas --factor 1 --scene a\n");
    accepted("--study\nmeasure\n--mass\n3\n--study\nrun",
             "gas --study measure --mass 3 --study run\n");
    refused("--mass\n3\n--study\nmeasure",
            "--mass: means nothing with --study measure (only with run, "
            "cost)");
    refused("--mass\n3\n--study\nrunt",
            "--mass: means nothing with --study runt (only with run, "
            "cost)");
    refused("--window\n3\n-E2",
            "--window: means nothing without --study measure");
    refused("--window\n3\n-E2\n--study\nrun",
            "--window: means nothing with --study run (only with measure)");
    refused("--window\n3\n--study\nmeasure",
            "--window: means nothing without --ensemble");
    refused("--packing\n3\n--box\n1",
            "--packing: means nothing with --box");
    refused("-q\n--packing\n3", "--packing: means nothing with --quick");
    refused("--factor\n3", "--factor: means nothing without --scene a");
    accepted("--rate\n1", "gas --rate 1\n");
    accepted("--rate\n1\n--scene\na", "gas --rate 1 --scene a\n");
    refused("--rate\n3\n--scene\nc",
            "--rate: means nothing with --scene c");
    refused("--box\n3", "--box: means nothing without a scene");
}

TEST(test_help_headings, "the help says where options mean anything")
{
    list = with_headings;
    const struct child c = run("--help");
    UNIT_TRUE(c.status == 0 && *c.err == '\0');
    UNIT_TRUE(strstr(c.out, "Usage: gas [OPTION]... FILE\n"));
    UNIT_TRUE(strstr(c.out, "\nwith --study run, cost:\n  -m, --mass"));
    UNIT_TRUE(strstr(c.out, "side\n"));
    UNIT_TRUE(strstr(c.out, "\nwith no --box; no --quick:\n"));
    UNIT_TRUE(strstr(c.out, "\nalways:\n  -o, --output FILE"));
    UNIT_TRUE(strstr(c.out, "where to write\n      --help"));
}

TEST(test_help, "help and version succeed or say why not")
{
    static char help[] = "--help", version[] = "--version";
    struct child c;
    list = entries;
    accepted("--version", "gas (Bonkers) " TOOLBOX_VERSION "\n");
    c = run("-q\n--help");
    UNIT_TRUE(c.status == 0 && *c.err == '\0');
    UNIT_TRUE(strstr(c.out, "Usage: gas [OPTION]...\nMove particles.\n"));
    UNIT_TRUE(strstr(c.out, "\n  -n, --particles N         how many"));
    UNIT_TRUE(strstr(c.out, "\n      --restitution E       ratio of the "
                            "speeds\n"
                            "                            after and"));
    UNIT_TRUE(strstr(c.out,
                     "\n      --version             name the version "
                     "and exit\n"
                     "\nThe summary says:\n"
                     "  energy [J]                of all\n"
                     "                            particles\n"
                     "if --mass:\n"
                     "  mean_energy_of_<particle> [J]\n"
                     "                            of one\n"));
    for (const char *line = c.out, *end; *line; line = end + 1) {
        end = strchr(line, '\n');
        UNIT_TRUE(end && end - line <= 78);
    }
    child_says(child_run(program, help, ""), 1,
               "gas: cannot write standard output: Bad file descriptor\n");
    if (access("/dev/full", W_OK) != 0)
        return;
    child_says(child_run(program, version, "/dev/full"), 1,
               "gas: cannot write standard output: No space "
               "left on device\n");
}
