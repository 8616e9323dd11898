/* From chapters/works/B-examiner.nw: edit there, then run make tangle. */
/* checksum 422000333 of the lines below */
/* Files as strings, lines cut off, labels and texts in columns. */
#include "examiner/text.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

const char *text_program = "examine";

void text_fail(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, "%s: ", text_program);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(2);
}

bool text_plain(const char *path)
{
    struct stat about;
    return stat(path, &about) == 0 && S_ISREG(about.st_mode);
}

char *text_read(const char *path)
{
    FILE *file = text_plain(path) ? fopen(path, "r") : NULL;
    char *text = file ? malloc(TEXT_LIMIT + 1) : NULL;
    size_t length = text ? fread(text, 1, TEXT_LIMIT, file) : 0;
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

size_t text_fold(const char *text, size_t room)
{
    const size_t length = strlen(text);
    if (length <= room)
        return length;
    for (size_t i = room; i > 0; --i)
        if (text[i] == ' ')
            return i;
    return strcspn(text, " ");
}

void text_field(FILE *out, const char *label, const char *text)
{
    for (; *text; label = "") {
        const size_t length = text_fold(text, TEXT_WIDTH - TEXT_LABEL);
        fprintf(out, "  %-10s %.*s\n", label, (int)length, text);
        text += length;
        text += strspn(text, " ");
    }
}

static void quote(FILE *out, const char *line, size_t length)
{
    const size_t room = TEXT_WIDTH - 4;
    fprintf(out, "  | %.*s\n", (int)(length < room ? length : room), line);
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
    char *text = text_read(path);
    char *rest = text;
    char *line = NULL;
    while (number-- > 0 && (line = text_line(&rest)))
        ;
    if (line)
        quote(out, line, strlen(line));
    free(text);
}
