/* Stores each verdict with a checksum of everything that it depends on. */
#include "examiner/cache.h"
#include "examiner/sum.h"
#include "examiner/text.h"
#include "toolbox/replace.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Returns whether an #include names a system header or a header that the
   kit gives to students. A name in angle brackets is not a system header if
   the kit has a header of that name, because the compiler finds the kit's
   first. */
static bool harmless(const char *what)
{
    char name[64], path[128];
    if (text_after(what, "\"exercise.h\"") ||
        text_after(what, "\"collide.h\"") ||
        text_after(what, "\"force.h\""))
        return true;
    if (sscanf(what, "<%63[^>]", name) != 1)
        return false;
    snprintf(path, sizeof path, "src/%s", name);
    if (access(path, F_OK) == 0)
        return false;
    snprintf(path, sizeof path, "src/examiner/%s", name);
    return access(path, F_OK) != 0;
}

/* Returns whether the file includes none of the student's other files. The
   key does not cover included files, so a verdict that depends on them
   cannot be stored. */
static bool stands_alone(const char *path)
{
    char *text = text_read(path);
    char *rest = text;
    bool alone = text != NULL;
    for (char *line; alone && (line = text_line(&rest));) {
        const char *hash = strchr(line, '#');
        const char *word = hash ? hash + 1 + strspn(hash + 1, " ") : "";
        const char *what = text_after(word, "include");
        if (what)
            alone = harmless(what + strspn(what, " "));
    }
    free(text);
    return alone;
}

/* Returns a checksum of everything that all verdicts depend on: the
   examiner, the library, the compiler's command, the table of equations,
   and headers in exercises/, which the compiler would find before the
   kit's. The checksum does not cover the compiler's version and the system
   headers: run make clean after an upgrade. */
static uint64_t sum_common(void)
{
    static const char *const files[] = {
        "build/check/examine",    "build/check/flags",
        "build/check/libcheck.a", "tests/equations.txt",
        "exercises/exercise.h",   "src/examiner/exercise.h",
        "exercises/collide.h",    "src/examiner/collide.h",
        "exercises/force.h",      "src/examiner/force.h"};
    static uint64_t sum;
    const size_t count = sum ? 0 : sizeof files / sizeof *files;
    for (size_t i = 0; i < count; ++i)
        sum = sum_file(sum, files[i]);
    return sum;
}

/* Returns 0 only if the verdict cannot be stored. The key does not contain
   the times of files: a file restored from an archive may be older than the
   verdict on the file that it replaces. Reading the files takes a few
   milliseconds, since a whole course has only a few megabytes. */
uint64_t cache_key(const struct exercise *e, bool strict, int seconds)
{
    char path[64];
    if (!stands_alone(e->file))
        return 0;
    uint64_t sum = sum_number(sum_common(), (uint64_t)seconds * 2 + strict);
    snprintf(path, sizeof path, "build/check/%s.suite.o", e->name);
    sum = sum_file(sum, path);
    snprintf(path, sizeof path, "build/check/%s.list", e->name);
    sum = sum_file(sum, path);
    snprintf(path, sizeof path, "build/check/%s.types.h", e->name);
    sum = sum_file(sum, path);
    sum = sum_bytes(sum, e->file, strlen(e->file));
    sum = sum_file(sum, e->file);
    return sum ? sum : 1;
}

enum { CACHE_SIZE = 1 << 16 };

/* Reads a stored verdict unchanged; text_read would escape some bytes. */
static bool load(const char *name, char text[CACHE_SIZE])
{
    char path[64];
    snprintf(path, sizeof path, "build/check/%s.verdict", name);
    FILE *file = text_plain(path) ? fopen(path, "r") : NULL;
    if (!file)
        return false;
    text[fread(text, 1, CACHE_SIZE - 1, file)] = '\0';
    fclose(file);
    return true;
}

/* Ignores a damaged or incomplete file, because its checksum is wrong. */
bool cache_load(struct exercise *e, uint64_t key)
{
    static char text[CACHE_SIZE];
    uint64_t said, sum;
    int state, earned, gap, wants, at = 0, story = 0;
    if (key == 0 || !load(e->name, text) ||
        sscanf(text, "%" SCNx64 " %" SCNx64 "%n", &said, &sum, &at) != 2 ||
        said != key ||
        sum != sum_bytes(key, text + at, strlen(text + at)) ||
        sscanf(text + at, "%d %d %d %d%n", &state, &earned, &gap, &wants,
               &story) != 4)
        return false;
    e->state = (enum state)state;
    e->earned = earned;
    e->gap = gap;
    e->wants = wants;
    e->story = strdup(text + at + story + 1);
    return e->story != NULL;
}

/* The stored checksum includes the key, to detect a verdict that was copied
   to another key. A verdict of more than 64 KiB is not stored. */
void cache_save(const struct exercise *e, uint64_t key)
{
    static char text[CACHE_SIZE], body[CACHE_SIZE - 64];
    char path[64];
    const int length =
        snprintf(body, sizeof body, "\n%d %d %d %d\n%s", (int)e->state,
                 e->earned, e->gap, e->wants, e->story ? e->story : "");
    if (key == 0 || length < 0 || (size_t)length >= sizeof body)
        return;
    snprintf(path, sizeof path, "build/check/%s.verdict", e->name);
    snprintf(text, sizeof text, "%016" PRIx64 " %016" PRIx64 "%s", key,
             sum_bytes(key, body, (size_t)length), body);
    replace_file(path, text, strlen(text), REPLACE_USUAL, false);
}
