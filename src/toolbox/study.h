/* The common main() and options of the programs of studies. */
/* Such a program measures what figures show: it lists its studies, and its
   main is one call. */
#ifndef TOOLBOX_STUDY_H
#define TOOLBOX_STUDY_H

#include "toolbox/options.h"
#include "toolbox/program.h"
#include "toolbox/progress.h"
#include "toolbox/table.h"

#include <stdbool.h>
#include <stdint.h>

/* What a study gets to work with. One that knows how much there is to do
   may begin `progress` again with that total. */
struct study {
    struct table *out, *summary; /* open; out has its first lines */
    uint64_t seed;
    struct progress progress; /* begun, with no total */
    bool broken;              /* set by a study that cannot go on: its */
                              /* table is kept, the run has failed */
};

/* One study; a list of them ends with {0}. */
struct study_entry {
    const char *name; /* what --study calls it */
    void (*run)(struct study *s);
    /* A phrase for --help; with the name at most STUDY_WIDTH letters. */
    const char *about;
    const struct table_key *keys; /* of its summary; NULL: it is empty */
};

/* A program of fewer than STUDY_MOST studies. Its options are --study,
   --output, --summary, --seed if it draws numbers, and its own. --help
   lists the keys of the summary of the study named before it only, since
   those of forty studies would help nobody. */
struct study_program {
    const char *name, *purpose; /* for options_begin */
    const char *events;         /* for progress_begin */
    const struct study_entry *studies;
    /* Runs without --study. NULL: one must be named, since a run by mistake
       may take minutes, and a message takes none. */
    const char *usual;
    uint64_t seeds;      /* the highest --seed; 0: no such option */
    const char *drawing; /* its heading; NULL: all studies draw numbers */
    /* Options of its own, or NULL; take keeps the value of each, and may
       end in options_fail. A program has one command line, so its studies
       find the values in variables of its file. */
    const struct options_entry *options;
    void (*take)(struct options *o, int letter);
    /* Completes the values when all options are taken; may end in
       options_fail. NULL: there is nothing to do. */
    void (*check)(struct options *o, const char *study);
};

enum { STUDY_MOST = 32, STUDY_WIDTH = 48 };

/* Reads the command line, opens table and summary, runs the study asked
   for, and closes both. A table cut short by a signal is kept, its summary
   is not. Returns the status to exit with: EXIT_FAILURE if a file could
   not be written, a signal came or the study broke. A wrong command ends
   the process. */
int study_main(const struct study_program *p, int argc, char *argv[]);

#endif
