/* Reads files as text, and writes labels and texts in columns. */
#include "examiner/text.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

const char *text_program = "examine";

/* Exits with status 2, which is not a verdict: a full disk, for example, is
   not the student's fault. */
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

void *text_must(void *memory)
{
    if (!memory)
        text_fail("out of memory");
    return memory;
}

FILE *text_stream(char **text, size_t *size)
{
    static size_t ignored;
    return text_must(open_memstream(text, size ? size : &ignored));
}

/* Returns the length of the UTF-8 character that begins the `left` bytes at
   s, or 0 if they are not valid. Sets *code to its code point. */
static size_t character(const unsigned char *s, size_t left,
                        unsigned long *code)
{
    static const unsigned long least[] = {0, 0, 0x80, 0x800, 0x10000};
    *code = *s;
    if (*s < 0x80)
        return 1;
    const size_t length = *s >= 0xf8   ? 0
                          : *s >= 0xf0 ? 4
                          : *s >= 0xe0 ? 3
                          : *s >= 0xc0 ? 2
                                       : 0;
    if (length == 0 || length > left)
        return 0;
    *code = *s & (0xffu >> (length + 1));
    for (size_t i = 1; i < length; ++i) {
        if ((s[i] & 0xc0) != 0x80)
            return 0;
        *code = *code << 6 | (s[i] & 0x3f);
    }
    const bool valid = *code >= least[length] && *code <= 0x10ffff &&
                       (*code < 0xd800 || *code > 0xdfff);
    return valid ? length : 0;
}

/* Returns whether a character is safe to show. Unsafe characters are
   control characters (below 32, and 127 to 159); characters that change the
   direction of writing, since they can make one line of code look like
   another; Unicode's line ends; two characters without width; and two that
   XML forbids. */
static bool is_seen(unsigned long code)
{
    static const unsigned long unseen[][2] = {
        {0, '\n' - 1},    {'\n' + 1, 0x1f}, {0x7f, 0x9f},
        {0x61c, 0x61c},   {0x200b, 0x200b}, {0x200e, 0x200f},
        {0x2028, 0x202e}, {0x2066, 0x2069}, {0xfeff, 0xfeff},
        {0xfffe, 0xffff}};
    for (size_t i = 0; i < sizeof unseen / sizeof *unseen; ++i)
        if (code >= unseen[i][0] && code <= unseen[i][1])
            return false;
    return true;
}

char *text_escaped(const char *bytes, size_t length)
{
    const unsigned char *s = (const unsigned char *)bytes;
    char *text = text_must(malloc(4 * length + 1)), *end = text;
    for (size_t i = 0; i < length;) {
        unsigned long code;
        const size_t whole = character(s + i, length - i, &code);
        if (whole <= 1 && (whole == 0 || !is_seen(code))) {
            end += sprintf(end, "\\x%02x", s[i]);
        } else if (!is_seen(code)) {
            end += sprintf(end, "\\u%04lx", code);
        } else {
            memcpy(end, s + i, whole);
            end += whole;
        }
        i += whole ? whole : 1;
    }
    *end = '\0';
    return text;
}

/* Other kinds of files are refused, because opening a named pipe would
   block. */
bool text_plain(const char *path)
{
    struct stat about;
    return stat(path, &about) == 0 && S_ISREG(about.st_mode);
}

/* Reads at most 1 MiB, the limit on a test's output. Escapes are necessary;
   otherwise a student's program could move the cursor up and write "passed"
   over the line above. */
char *text_read(const char *path)
{
    FILE *file = text_plain(path) ? fopen(path, "r") : NULL;
    char *bytes = file ? malloc(TEXT_LIMIT) : NULL;
    const size_t length = bytes ? fread(bytes, 1, TEXT_LIMIT, file) : 0;
    if (file)
        fclose(file);
    if (!bytes)
        return NULL;
    for (size_t i = 0; i < length; ++i)
        if (bytes[i] == '\t' || bytes[i] == '\r')
            bytes[i] = ' ';
    char *text = text_escaped(bytes, length);
    free(bytes);
    return text;
}

bool text_utf16(const char *path)
{
    unsigned char s[8] = {0};
    FILE *file = text_plain(path) ? fopen(path, "r") : NULL;
    const size_t length = file ? fread(s, 1, sizeof s, file) : 0;
    if (file)
        fclose(file);
    if (length >= 2 && s[0] + s[1] == 0xff + 0xfe && abs(s[0] - s[1]) == 1)
        return true; /* a byte-order mark comes first */
    int zeros[2] = {0};
    for (size_t i = 0; i < sizeof s; ++i)
        zeros[i % 2] += s[i] == 0;
    return length == sizeof s && abs(zeros[0] - zeros[1]) == 4;
}

/* Keeps empty lines, unlike strtok, so that lines can be counted. */
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

/* A word that is longer than a line is not broken, because a path with a
   line break in it cannot be copied. */
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

/* Writes a line with a vertical bar in front of it, so that nobody takes a
   "passed" from a student's program for the examiner's. Cuts long lines
   instead of folding them, because a compiler's caret in the next line may
   point at a column. */
static void quote(FILE *out, const char *line, size_t length)
{
    const size_t room = TEXT_WIDTH - 4;
    if (length > room)
        for (length = room; (line[length] & 0xc0) == 0x80;)
            --length;
    fprintf(out, "  | %.*s\n", (int)length, line);
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
