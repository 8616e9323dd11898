/* What mutate and tokens know of C's text: how to read it, and where its
   parts end. PROGRAM, the name in messages, is the includer's. Nothing that
   grow gives is freed where the process ends soon. */
#ifndef SOURCE_H
#define SOURCE_H

#include <ctype.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

_Noreturn static void fail(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fputs(PROGRAM ": ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(2);
}

static void *grow(void *memory, size_t bytes)
{
    memory = realloc(memory, bytes ? bytes : 1);
    if (!memory)
        fail("out of memory");
    return memory;
}

/* The text of a file, a NUL behind it, and its length. */
static char *read_file(const char *path, size_t *length)
{
    char *text = NULL;
    size_t got;
    FILE *file = fopen(path, "r");
    if (!file)
        fail("cannot read '%s'", path);
    *length = 0;
    do {
        text = grow(text, *length + 65537);
        got = fread(text + *length, 1, 65536, file);
        *length += got;
    } while (got > 0);
    fclose(file);
    text[*length] = '\0';
    return text;
}

static bool is_comment(const char *at)
{
    return at[0] == '/' && (at[1] == '*' || at[1] == '/');
}

static const char *after_comment(const char *at)
{
    const char *end =
        at[1] == '*' ? strstr(at + 2, "*/") : strchr(at, '\n');
    if (!end)
        return at + strlen(at);
    return at[1] == '*' ? end + 2 : end;
}

static const char *after_directive(const char *at)
{
    while (*at && *at != '\n')
        if (is_comment(at))
            at = after_comment(at);
        else
            at += *at == '\\' && at[1] ? 2 : 1;
    return at;
}

static const char *after_word(const char *at)
{
    while (isalnum((unsigned char)*at) || *at == '_')
        ++at;
    return at;
}

static bool starts_word(const char *at)
{
    return isalpha((unsigned char)*at) || *at == '_';
}

static bool starts_number(const char *at)
{
    return isdigit((unsigned char)*at) ||
           (*at == '.' && isdigit((unsigned char)at[1]));
}

static const char *after_quoted(const char *at)
{
    const char quote = *at++;
    while (*at && *at != quote)
        at += *at == '\\' && at[1] ? 2 : 1;
    return *at ? at + 1 : at;
}

static const char *after_punctuation(const char *at)
{
    static const char *const longer[] = {
        "<<=", ">>=", "...", "->", "++", "--", "<<", ">>",
        "<=",  ">=",  "==",  "!=", "&&", "||", "+=", "-=",
        "*=",  "/=",  "%=",  "&=", "|=", "^="};
    for (size_t i = 0; i < sizeof longer / sizeof *longer; ++i)
        if (*at == *longer[i] &&
            strncmp(at, longer[i], strlen(longer[i])) == 0)
            return at + strlen(longer[i]);
    return at + 1;
}

#endif
