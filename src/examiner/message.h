/* Explains messages of compilers in plain words. */
#ifndef MESSAGE_H
#define MESSAGE_H

#include <stdbool.h>
#include <stdio.h>

/* Returns whether this line of a compiler's messages can be explained. */
bool message_known(const char *line);

/* Writes the explanation of a line, if there is one. */
void message_explain(FILE *story, const char *line);

#endif
