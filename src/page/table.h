/* From chapters/works/A-toolbox.nw: edit there, then run make tangle. */
/* checksum 3406747565 of the lines below */
/* Tables that are texts in memory. */
#ifndef PAGE_TABLE_H
#define PAGE_TABLE_H

#include "toolbox/table.h"

/* Begins a table of this program; NULL without memory. */
struct table *page_table_open(const char *program);

/* Ends it; returns its text, to be freed, or NULL without memory. */
char *page_table_close(struct table *t);

#endif
