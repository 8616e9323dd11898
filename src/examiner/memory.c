/* Keeps verdicts, each with a checksum of all that it depends on. */
#include "examiner/memory.h"
#include "examiner/sum.h"
#include "examiner/text.h"
#include "toolbox/replace.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Returns whether an include leads to a header of the system's or to
   exercise.h. The compiler looks for a header in angle brackets among ours
   first, and so does this. */
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

/* Returns whether a file includes no other of the student's: a verdict
   would rest on that, too. It is not followed; such a verdict is not
   remembered. */
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

/* Sums what all verdicts rest on: the examiner, whose words the story has,
   the library, the compiler's command, the table of equations, the
   student's exercise.h, which would be found before ours. The compiler is
   known by its command and not by its version, and the system's headers not
   at all: after an upgrade make clean forgets what was known. */
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

/* Sums all that a verdict rests on. Dates would answer another question: a
   file put back from an archive is older than the verdict on what it
   replaces. Reading some megabytes takes some milliseconds for the whole
   course. The key 0 means none and is avoided. */
uint64_t memory_key(const struct exercise *e, bool strict, int seconds)
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

enum { MEMORY_ROOM = 1 << 16 };

/* Reads what was kept, byte for byte; text_read would escape the letters of
   a file's name. */
static bool load(const char *name, char text[MEMORY_ROOM])
{
    char path[64];
    snprintf(path, sizeof path, "build/check/%s.verdict", name);
    FILE *file = text_plain(path) ? fopen(path, "r") : NULL;
    if (!file)
        return false;
    text[fread(text, 1, MEMORY_ROOM - 1, file)] = '\0';
    fclose(file);
    return true;
}

/* Reads the kept verdict with this key. A file with a wrong byte, or half a
   file, has another sum than it says and is ignored. */
bool memory_recall(struct exercise *e, uint64_t key)
{
    static char text[MEMORY_ROOM];
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

/* Writes the verdict on an exercise. The sum begins with the key, so that a
   verdict cannot be given another one by hand. A story of more than 64 KiB
   is not kept. */
void memory_keep(const struct exercise *e, uint64_t key)
{
    static char text[MEMORY_ROOM], body[MEMORY_ROOM - 64];
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
