/* Reads text safely, and prints it folded for a terminal. */
#ifndef TEXT_H
#define TEXT_H

#include <stdbool.h>
#include <stdio.h>

enum { TEXT_WIDTH = 78, TEXT_LABEL = 13, TEXT_LIMIT = 1 << 20 };

/* Returns whether this is a plain file, not a folder or a pipe. */
bool text_plain(const char *path);

/* Returns bytes as text that a person can read; the caller frees it. UTF-8
   and line ends stay. A byte that is not UTF-8, a zero byte and a character
   that controls a terminal become \x1b and the like; a character that
   changes the direction of writing or cannot be seen becomes \u202e and the
   like. All output of students is escaped so before it is shown. */
char *text_escaped(const char *bytes, size_t length);

/* Returns the first TEXT_LIMIT bytes of a file, escaped, with blanks for
   tabs and carriage returns, or NULL when the file cannot be read. The
   caller frees them. */
char *text_read(const char *path);

/* Returns whether a file is UTF-16, with two bytes for each letter, as
   some editors save it. */
bool text_utf16(const char *path);

/* Cuts the next line off *rest and returns it without its end; NULL when
   nothing is left. Changes the text in place. */
char *text_line(char **rest);

/* Returns the rest of a line after a prefix, or NULL if the line does not
   begin with it. */
const char *text_after(const char *line, const char *prefix);

/* Returns the number of bytes of a text that fit into this many columns, up
   to a space; a longer word is counted whole. */
size_t text_fold(const char *text, size_t room);

/* Writes a label and a text in two columns, folded at spaces so that no
   line is wider than TEXT_WIDTH. */
void text_field(FILE *out, const char *label, const char *text);

/* Writes the first few lines of a text, cut at TEXT_WIDTH columns, after a
   bar that sets them apart from our own words. */
void text_quote(FILE *out, const char *text, int lines);

/* Writes one line of a file after such a bar, if the file has that line. */
void text_quote_line(FILE *out, const char *path, int number);

/* The name that begins error messages; "examine" unless a program sets
   it. */
extern const char *text_program;

/* Prints an error message, as printf does, and exits with 2. */
_Noreturn void text_fail(const char *format, ...);

/* Returns its argument, which a function has allocated, or ends with an
   error message if it is NULL. */
void *text_must(void *memory);

/* Opens a stream that writes into memory. When it is closed, *text is what
   was written, for the caller to free, and *size (which may be NULL) its
   number of bytes. Ends with an error message if there is no memory. */
FILE *text_stream(char **text, size_t *size);

#endif
