/* Fuzzing the reader of scenes: any bytes are a scene or are refused, and
   nothing worse happens. A scene that was read is written and read again,
   and has to come out with the same bits. Made for libFuzzer; alone.c has a
   main for compilers without it. */
#include "scenes/scene.h"

#include "../library/scene_same.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* A table that is kept in memory: scene.c needs no other part of it. */
struct table {
    FILE *stream;
};

bool table_print(struct table *t, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    const bool good = vfprintf(t->stream, format, values) >= 0;
    va_end(values);
    return good;
}

static void check_written(const struct scene *s)
{
    struct scene again;
    struct scene_error e;
    char *text;
    size_t size;
    struct table t = {open_memstream(&text, &size)};
    if (!t.stream)
        abort();
    scene_write(s, &t);
    if (fclose(t.stream) != 0)
        abort();
    if (!scene_parse(&again, text, size, &e)) {
        fprintf(stderr, "%s\nline %zu: %s\n", text, e.line, e.text);
        abort();
    }
    if (!scene_same(s, &again))
        abort();
    free(text);
    scene_free(&again);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct scene s;
    struct scene_error e = {0};
    char *text = malloc(size + (size == 0)); /* its end is an end */
    if (!text)
        abort();
    if (size > 0)
        memcpy(text, data, size);
    if (scene_parse(&s, text, size, &e)) {
        check_written(&s);
        scene_free(&s);
    } else if (e.line == 0 || strncmp(e.text, "found ", 6) != 0 ||
               !strstr(e.text, ", expected ")) {
        abort();
    }
    free(text);
    return 0;
}
