/* Opens and closes a table that is a text in memory. */
#include "page/table.h"

#include "toolbox/lines.h"

#include <stdlib.h>

struct table *page_table_open(const char *program)
{
    struct table *t = calloc(1, sizeof *t);
    if (!t)
        return NULL;
    t->program = program;
    t->stream = open_memstream(&t->name, &t->size);
    if (t->stream)
        return t;
    free(t);
    return NULL;
}

char *page_table_close(struct table *t)
{
    const bool good = fclose(t->stream) == 0 && t->error == 0;
    char *text = good ? t->name : NULL;
    if (!good)
        free(t->name);
    free(t);
    return text;
}
