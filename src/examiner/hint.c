/* Shows the next hint for an exercise, and stores how many were shown. */
#include "examiner/hint.h"
#include "examiner/text.h"
#include "toolbox/replace.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* The file that stores the numbers of hints given. It is not in build/,
   which make clean deletes, and not in exercises/, which holds only the
   student's own files. */
static const char path[] = ".progress";

static int given(const char *name)
{
    char *text = text_read(path);
    char *rest = text;
    const char *number;
    int count = 0;
    for (char *line; (line = text_line(&rest));)
        if ((number = text_after(line, name)) && *number == ' ')
            count = atoi(number);
    free(text);
    return count < 0 || count > 1000 ? 0 : count;
}

/* The stored number is 100 * stage + number of hints given. For example,
   302 means two hints for the third stage of a project. An exercise has
   only stage 0. */
enum { PER_STAGE = 100 };

static int stage_of(const struct exercise *e)
{
    const bool project = *e->name == 'P';
    return !project ? 0 : e->wants > 0 ? e->wants : 1;
}

static int given_here(const struct exercise *e)
{
    const int count = given(e->name) - PER_STAGE * stage_of(e);
    return count < 0 || count >= PER_STAGE ? 0 : count;
}

static void remember(const char *name, int count)
{
    char *text = text_read(path), *rest = text, *fresh = NULL;
    size_t size;
    FILE *out = text_stream(&fresh, &size);
    for (char *line; (line = text_line(&rest));)
        if (!text_after(line, name))
            fprintf(out, "%s\n", line);
    fprintf(out, "%s %d\n", name, count);
    fclose(out);
    if (!replace_file(path, fresh, size, REPLACE_USUAL, false))
        fprintf(stderr, "examine: cannot write '%s': %s\n", path,
                strerror(errno));
    free(fresh);
    free(text);
}

void hint_forget(const struct exercise *e)
{
    if (given(e->name) > 0)
        remember(e->name, 0);
}

/* Returns the number of hints for a stage. Prints hint number `wanted`, or
   none if wanted is 0. */
static int find_hint(char *text, int stage, int wanted)
{
    int number = 0;
    char head[24] = "";
    bool first = true, ours = false;
    if (stage > 0)
        snprintf(head, sizeof head, "Stage %d.", stage);
    for (char *line; (line = text_line(&text));) {
        if (first)
            number += ours = text_after(line, head) != NULL;
        first = strcmp(line, "--") == 0;
        if (ours && !first && number == wanted)
            puts(line);
    }
    return number;
}

static int count_hints(const char *file, int stage)
{
    char *text = text_read(file);
    if (!text)
        text_fail("there are no hints: cannot read '%s'", file);
    const int count = find_hint(text, stage, 0);
    free(text);
    return count;
}

/* Shows the next hint, then stores its number, so that the student gets the
   hint even if the disk is full. */
void hint_show(const struct exercise *e)
{
    char file[64];
    snprintf(file, sizeof file, "tests/exercises/%s/hints.txt", e->name);
    const int stage = stage_of(e), count = count_hints(file, stage);
    int number = given_here(e) + 1;
    const bool again = number > count;
    number = again ? count : number;
    printf("%s, %s: hint %d of %d%s\n\n", e->name, e->title, number, count,
           again ? ", the last one again; there are no more" : "");
    char *text = text_read(file);
    if (text)
        find_hint(text, stage, number);
    free(text);
    printf("\nThen: make check EX=%s%s\n", e->name,
           number < count ? ", or the next hint: the same command again"
                          : "");
    if (!again)
        remember(e->name, PER_STAGE * stage + number);
}
