/* Tables in memory: in a browser there are no files. */
#ifndef PAGE_TABLE_H
#define PAGE_TABLE_H

#include "toolbox/table.h"

/* Begins a table of this program, which is kept in memory. Returns NULL if
   there is not enough memory. Lines, head and rows are written with the
   functions of toolbox/table.h, so that the bytes are those of a file. */
struct table *page_table_open(const char *program);

/* Frees the table. Returns its text, to be freed by the caller, or NULL if
   there was not enough memory. */
char *page_table_close(struct table *t);

#endif
