/* From chapters/B-examiner.nw: edit there, then run make tangle. */
/* checksum 2051664415 of the lines below */
#ifndef TEXT_H
#define TEXT_H

#include <stddef.h>
#include <stdio.h>

/* The first limit bytes of a file as a string, unprintable bytes turned
   into '?', or NULL when it cannot be read. The caller frees it. */
char *text_read(const char *path, size_t limit);

/* Cuts the next line off *rest and returns it without its end; NULL when
   nothing is left. Changes the text in place. */
char *text_line(char **rest);

/* The text behind prefix, or NULL when the line does not start with it. */
const char *text_after(const char *line, const char *prefix);

/* Writes a text folded at spaces to TEXT_WIDTH columns. The first line
   starts with lead, which is as wide as indent; the others with blanks. */
void text_fold(FILE *out, const char *lead, int indent, const char *text);

/* Writes a label and a text, folded, in two columns. */
void text_field(FILE *out, const char *label, const char *text);

/* Writes the first few lines of a text, cut at TEXT_WIDTH columns, behind
   a bar that sets them apart from our own words. */
void text_quote(FILE *out, const char *text, int lines);

/* Writes line number of a file behind such a bar, if there is one. */
void text_quote_line(FILE *out, const char *path, int number);

enum { TEXT_WIDTH = 78, TEXT_LABEL = 13, TEXT_LIMIT = 1 << 16 };

#endif
