/* The main() and the options that all programs of studies share. */
/* A program of studies makes the measurements for figures. It lists its
   studies, and its main() only calls study_main. */
#ifndef TOOLBOX_STUDY_H
#define TOOLBOX_STUDY_H

#include "toolbox/options.h"
#include "toolbox/program.h"
#include "toolbox/progress.h"
#include "toolbox/random.h"
#include "toolbox/table.h"

#include <stdbool.h>
#include <stdint.h>

/* The data that a study works with. A study that knows its total amount of
   work may call progress_begin again with this total. */
struct study {
    struct table *out, *summary; /* open; out has its first lines */
    uint64_t seed;
    struct random random;     /* seeded with `seed` */
    struct progress progress; /* begun, without a total */
    bool broken;              /* set by a study that has failed */
};

/* One study. A list of studies ends with {0}. */
struct study_entry {
    const char *name; /* the value of --study */
    void (*run)(struct study *s);
    /* A phrase for --help. name and about have at most STUDY_WIDTH letters
       in total. */
    const char *about;
    const struct table_key *keys; /* the keys of its summary, or NULL */
};

/* Makes a list of keys that ends with {0}. (Versions 14 and 19 of
   clang-format disagree about its braces.) */
/* clang-format off */
#define STUDY_KEYS(...) (const struct table_key[]){__VA_ARGS__, {0}}
/* clang-format on */

/* A program of fewer than STUDY_MOST studies. Its options are --study,
   --output, --summary, --seed if it draws random numbers, and its own
   options. --help lists the summary keys only of the study that is named
   before --help, because the keys of forty studies would be too many to
   read. */
struct study_program {
    const char *name, *purpose; /* for options_begin */
    const char *events;         /* for progress_begin */
    const struct study_entry *studies;
    /* The study that runs without --study. If NULL, --study is required,
       because nobody should start a run of minutes by mistake. */
    const char *usual;
    uint64_t seeds;      /* largest value of --seed; 0: no such option */
    const char *drawing; /* heading of --seed; NULL: all studies use it */
    /* The program's own options, or NULL. `take' stores the value of an
       option in a static variable, where the studies read it. `take' may
       call options_fail. */
    const struct options_entry *options;
    void (*take)(struct options *o, int letter);
    /* Called after the last option to complete the values. May call
       options_fail. NULL: nothing to do. */
    void (*check)(struct options *o, const char *study);
};

enum { STUDY_MOST = 32, STUDY_WIDTH = 48 };

/* Reads the command line, opens table and summary, runs the chosen study,
   and closes both. If a signal ends the run, keeps the table and discards
   the summary. Returns the exit status of the program: EXIT_FAILURE if a
   file could not be written, a signal came or the study set `broken`. A
   wrong command ends the process. */
int study_main(const struct study_program *p, int argc, char *argv[]);

/* Defines main() from the fields of a struct study_program. */
#define STUDY_MAIN(...)                                                    \
    int main(int argc, char *argv[])                                       \
    {                                                                      \
        const struct study_program program = {__VA_ARGS__};                \
        return study_main(&program, argc, argv);                           \
    }

#endif
