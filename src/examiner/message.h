/* What a compiler's message means, in plain words. */
#ifndef MESSAGE_H
#define MESSAGE_H

#include <stdbool.h>
#include <stdio.h>

/* Whether we know what this line of a compiler's messages means. */
bool message_known(const char *line);

/* Writes what it means in a plain sentence, if we know. */
void message_explain(FILE *story, const char *line);

#endif
