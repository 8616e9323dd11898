/* Runs the study that the command line names. */
#include "toolbox/study.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct command {
    size_t study;
    uint64_t seed;
    const char *output, *summary, *line;
};

enum { LINE = 64 }; /* largest length of a study's line in the help */

/* Fills names and the help of --study. Returns the number of studies. The
   usual study is in parentheses at the end of the help, like all
   defaults. */
static size_t list_studies(const struct study_program *p,
                           const char *names[STUDY_MOST + 1],
                           char help[STUDY_MOST * LINE])
{
    size_t n = 0;
    help += sprintf(help, "what to measure:");
    for (const struct study_entry *e = p->studies; e->name; ++e) {
        assert(n + 1 < STUDY_MOST);
        assert(strlen(e->name) + strlen(e->about) <= STUDY_WIDTH);
        names[n++] = e->name;
        help += sprintf(help, "\n%s: %s", e->name, e->about);
    }
    if (p->usual)
        sprintf(help, "\n(%s)", p->usual);
    names[n] = NULL;
    return n;
}

/* Fills the list of options: --study, the program's own options, then the
   other common options. --seed has the heading p->drawing. It is not
   repeated if it is also the last heading of the program's own options. */
static void list_options(const struct study_program *p, const char *help,
                         struct options_entry entries[])
{
    const struct options_entry *own = p->options;
    *entries++ = (struct options_entry){"study", 'y', "NAME", help};
    const char *heading = NULL;
    for (; own && own->name; *entries++ = *own++)
        heading = *own->name ? heading : own->help;
    if (!heading || !p->drawing || strcmp(heading, p->drawing) != 0)
        *entries++ = (struct options_entry){"", 0, NULL, p->drawing};
    if (p->seeds > 0)
        *entries++ = (struct options_entry){"seed", 's', "S",
                                            "of the random numbers (1)"};
    *entries++ = (struct options_entry){"", 0, NULL, NULL};
    *entries++ = (struct options_entry){OPTIONS_OUTPUT("table")};
    *entries = (struct options_entry){
        "summary", 'S' | OPTIONS_SILENT | OPTIONS_WRITES, "FILE",
        "for the results as lines: key value;\n"
        "--study NAME --help lists them"};
}

static void take_option(struct options *o, int letter,
                        const struct study_program *p,
                        const char *const names[], struct command *c)
{
    switch (letter) {
    case 'y':
        c->study = options_choice(o, names);
        options_keys(o, p->studies[c->study].keys);
        break;
    case 'o': c->output = options_text(o); break;
    case 'S': c->summary = options_text(o); break;
    case 's':
        if (p->seeds > 0) {
            c->seed = options_count(o, 0, p->seeds);
            break;
        }
        /* fall through */
    default: p->take(o, letter);
    }
}

static void read_command(const struct study_program *p, struct command *c,
                         int argc, char *argv[])
{
    const char *names[STUDY_MOST + 1];
    char help[STUDY_MOST * LINE];
    struct options_entry entries[OPTIONS_MAXIMUM + 1] = {{0}};
    struct options o;
    int letter;
    const size_t studies = list_studies(p, names, help);
    list_options(p, help, entries);
    options_begin(&o, p->name, p->purpose, entries, argc, argv);
    c->study = 0;
    while (c->study < studies &&
           !(p->usual && strcmp(names[c->study], p->usual) == 0))
        ++c->study;
    if (c->study < studies)
        options_keys(&o, p->studies[c->study].keys);
    while ((letter = options_next(&o)) != -1)
        take_option(&o, letter, p, names, c);
    c->line = options_command(&o);
    if (c->study == studies)
        options_fail(&o, "--study is needed; %s --help lists them",
                     p->name);
    program_apart(&o, c->output, c->summary, "table");
    if (p->check)
        p->check(&o, names[c->study]);
}

/* Checks the command before the study runs, because a study may take
   minutes. */
int study_main(const struct study_program *p, int argc, char *argv[])
{
    struct command c = {.seed = p->seeds > 0, .summary = "/dev/null"};
    struct study s = {0};
    read_command(p, &c, argc, argv);
    program_open(c.output, c.summary, p->studies[c.study].keys, &s.out,
                 &s.summary);
    s.seed = c.seed;
    random_seed(&s.random, c.seed);
    progress_begin(&s.progress, p->name, 0, p->events);
    table_begin(s.out, c.line, c.seed);
    p->studies[c.study].run(&s);
    const bool whole = progress_end(&s.progress) && !s.broken;
    return program_close(s.out, s.summary, whole);
}
