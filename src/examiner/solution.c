/* Shows a solution through the reader's pager, once the exercise passes. */
#include "examiner/solution.h"
#include "examiner/process.h"
#include "examiner/round.h"
#include "examiner/text.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Prints a file, through a pager if the output is a terminal. The shell
   gets the file's name from the environment, not as part of the command. */
static void put_on_screen(const char *path)
{
    putchar('\n');
    fflush(stdout);
    setenv("EXAMINE_FILE", path, 1);
    if (isatty(STDOUT_FILENO) &&
        system("${PAGER:-more} \"$EXAMINE_FILE\"") == 0)
        return;
    char *text = text_read(path);
    if (!text)
        text_fail("cannot read '%s'", path);
    fputs(text, stdout);
    free(text);
}

void solution_show(struct exercise *e, const struct verdict_rules *rules)
{
    verdict_reach(e, rules);
    if (process_signal())
        text_fail("interrupted");
    round_line(e);
    if (e->state != PASSED)
        printf("\nThe worked solution can be read once %s passes. Until "
               "then:\nmake hint EX=%s\n",
               e->name, e->name);
    else if (!*e->solution)
        printf("\nIt passes. This copy of the kit has no worked solutions; "
               "your lecturer keeps them.\n");
    else
        put_on_screen(e->solution);
}
