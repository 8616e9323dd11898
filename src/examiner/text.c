/* From chapters/B-examiner.nw: edit there, then run make tangle. */
/* checksum 1555442689 of the lines below */
#include "examiner/text.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

char *text_read(const char *path, size_t limit)
{
    FILE *file = fopen(path, "r");
    char *text = file ? malloc(limit + 1) : NULL;
    size_t length = text ? fread(text, 1, limit, file) : 0;
    if (file)
        fclose(file);
    if (!text)
        return NULL;
    text[length] = '\0';
    for (size_t i = 0; i < length; ++i)
        if (text[i] == '\t' || text[i] == '\r')
            text[i] = ' ';
        else if (text[i] != '\n' && !isprint((unsigned char)text[i]))
            text[i] = '?';
    return text;
}

char *text_line(char **rest)
{
    char *line = *rest;
    if (!line || !*line)
        return NULL;
    char *end = line + strcspn(line, "\n");
    *rest = *end ? end + 1 : end;
    *end = '\0';
    return line;
}

const char *text_after(const char *line, const char *prefix)
{
    const size_t length = strlen(prefix);
    return strncmp(line, prefix, length) == 0 ? line + length : NULL;
}

static size_t fold_at(const char *text, size_t room)
{
    size_t best = 0;
    for (size_t i = 0; text[i] && (i <= room || best == 0); ++i)
        if (text[i] == ' ' && i > 0)
            best = i;
    return strlen(text) <= room || best == 0 ? strlen(text) : best;
}

void text_fold(FILE *out, const char *lead, int indent, const char *text)
{
    const size_t room = (size_t)(TEXT_WIDTH - indent);
    fprintf(out, "%-*s", indent, lead);
    while (*text) {
        const size_t length = fold_at(text, room);
        fprintf(out, "%.*s\n", (int)length, text);
        text += length + strspn(text + length, " ");
        if (*text)
            fprintf(out, "%*s", indent, "");
    }
}

void text_field(FILE *out, const char *label, const char *text)
{
    char lead[TEXT_LABEL + 1];
    snprintf(lead, sizeof lead, "  %-10s ", label);
    text_fold(out, lead, TEXT_LABEL, text);
}

static void quote(FILE *out, const char *line, size_t length)
{
    const int room = TEXT_WIDTH - 4;
    fprintf(out, "  | %.*s\n", length < (size_t)room ? (int)length : room,
            line);
}

void text_quote(FILE *out, const char *text, int lines)
{
    for (; *text && lines > 0; --lines) {
        const size_t length = strcspn(text, "\n");
        quote(out, text, length);
        text += length + (text[length] == '\n');
    }
    if (*text)
        quote(out, "...", 3);
}

void text_quote_line(FILE *out, const char *path, int number)
{
    char *text = text_read(path, TEXT_LIMIT);
    char *rest = text;
    char *line = NULL;
    while (number-- > 0 && (line = text_line(&rest)))
        ;
    if (line)
        quote(out, line, strlen(line));
    free(text);
}
