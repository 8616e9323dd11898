/* Explains messages of compilers in plain words. */
#ifndef MESSAGE_H
#define MESSAGE_H

#include <stdbool.h>
#include <stdio.h>

enum { MESSAGE_NAME = 64 };

/* Copies the first quoted name, or "" if there is none. The quotation marks
   are ASCII, because the compiler runs in the C locale. */
void message_quoted(char name[MESSAGE_NAME], const char *from);

/* Returns whether this line of a compiler's messages can be explained. */
bool message_known(const char *line);

/* Writes the explanation of a line, if there is one. */
void message_explain(FILE *story, const char *line);

#endif
