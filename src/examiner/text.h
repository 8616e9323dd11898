/* Reads text safely, and prints it folded for a terminal. */
#ifndef TEXT_H
#define TEXT_H

#include <stdbool.h>
#include <stdio.h>

enum { TEXT_WIDTH = 78, TEXT_LABEL = 13, TEXT_LIMIT = 1 << 20 };

/* Returns whether this is a plain file, not a folder or a pipe. */
bool text_plain(const char *path);

/* Returns bytes as text that is safe to show; the caller frees it. Keeps
   line ends and other UTF-8 characters. Bytes that are not UTF-8 and
   control characters become \x1b and the like. Characters that change the
   direction of writing or cannot be seen become \u202e and the like. All
   output of students is escaped in this way before it is shown. */
char *text_escaped(const char *bytes, size_t length);

/* Returns the first TEXT_LIMIT bytes of a file, escaped, with tabs and
   carriage returns replaced by blanks; the caller frees them. Returns NULL
   if the file cannot be read. */
char *text_read(const char *path);

/* Returns whether a file is UTF-16, with two bytes for each letter, as
   some editors save it. */
bool text_utf16(const char *path);

/* Removes the next line from *rest and returns it without its line end.
   Returns NULL if nothing is left. Changes the text in place. */
char *text_line(char **rest);

/* Returns the rest of a line after a prefix, or NULL if the line does not
   begin with it. */
const char *text_after(const char *line, const char *prefix);

/* Returns how many bytes of a text fit into `room` columns if the text is
   broken at a space. If the first word is longer, returns its length. */
size_t text_fold(const char *text, size_t room);

/* Writes a label and a text in two columns, folded at spaces so that no
   line is wider than TEXT_WIDTH. */
void text_field(FILE *out, const char *label, const char *text);

/* Writes the first lines of a text, at most `lines` of them, cut at
   TEXT_WIDTH columns. A bar before each line shows that the text is not the
   examiner's own. */
void text_quote(FILE *out, const char *text, int lines);

/* Writes line `number` of a file as text_quote does, if the file has that
   line. */
void text_quote_line(FILE *out, const char *path, int number);

/* The name that begins error messages; "examine" unless a program sets
   it. */
extern const char *text_program;

/* Prints an error message, formatted as by printf, and exits with status
   2. */
_Noreturn void text_fail(const char *format, ...);

/* Returns `memory`. If it is NULL, ends with an error message. */
void *text_must(void *memory);

/* Opens a stream that writes into memory. When the stream is closed,
   *text is the text written, which the caller frees, and *size its number
   of bytes; size may be NULL. Ends with an error message if memory runs
   out. */
FILE *text_stream(char **text, size_t *size);

#endif
