/* How a text is made wrong. MOST, the longest text, is the includer's. */
#ifndef MUTATE_H
#define MUTATE_H

#include "toolbox/random.h"

#include <stddef.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

struct text {
    size_t size;
    uint8_t byte[MOST];
};

static bool read_text(const char *path, struct text *t)
{
    FILE *f = fopen(path, "r");
    t->size = f ? fread(t->byte, 1, MOST, f) : 0;
    if (f)
        fclose(f);
    return f != NULL;
}

/* Puts n bytes in place of the next `gone` of the text. */
static void splice(struct text *t, size_t at, size_t gone,
                   const void *bytes, size_t n)
{
    if (gone > t->size - at)
        gone = t->size - at;
    if (n > MOST - at)
        n = MOST - at;
    size_t rest = t->size - at - gone;
    if (rest > MOST - at - n)
        rest = MOST - at - n;
    memmove(t->byte + at + n, t->byte + at + gone, rest);
    memcpy(t->byte + at, bytes, n);
    t->size = at + n + rest;
}

/* Changes t in one place, perhaps by a part of the other text. */
static void mutate(struct text *t, const struct text *other,
                   struct random *r)
{
    static const char *const words[] = {
        "nan",   "-1",     "1e999",
        "-0",    "0x1p3",  "4294967296",
        "1e308", "5e-324", "0",
        "1",     "7",      " ",
        "\n",    "#",      "sl",
        "pos",   "carry",  "9007199254740993",
        "kept",  "vel",    "kept 0 1 2 -0",
        "e",     ".",      "-",
        "\r\n",  "\t",     "walls hard open open"};
    const size_t at = random_below(r, t->size + 1);
    const size_t from = random_below(r, other->size + 1);
    const char *word = words[random_below(r, sizeof words / sizeof *words)];
    const uint8_t any = (uint8_t)random_below(r, 256);
    const size_t few = random_below(r, 12), many = random_below(r, 60);
    switch (random_below(r, 6)) {
    case 0: splice(t, at, 1, &any, 1); break;
    case 1: splice(t, at, few, "", 0); break;
    case 2: splice(t, at, many, "", 0); break;
    case 3: splice(t, at, few * (few % 2), word, strlen(word)); break;
    case 4: splice(t, at, 0, &any, 1); break;
    default:
        splice(t, at, 0, other->byte + from,
               many < other->size - from ? many : other->size - from);
    }
}

#endif
