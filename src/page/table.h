/* Keeps tables in memory, because a browser has no files. */
#ifndef PAGE_TABLE_H
#define PAGE_TABLE_H

#include "toolbox/table.h"

/* Begins a table of this program, which is kept in memory. Returns NULL if
   memory runs out. Lines, head and rows are written by the functions of
   toolbox/table.h, so their bytes are the same as in a file. */
struct table *page_table_open(const char *program);

/* Frees the table. Returns its text, which the caller frees, or NULL if
   memory has run out. */
char *page_table_close(struct table *t);

#endif
