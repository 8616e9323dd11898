/* A main for the fuzz target, for compilers without libFuzzer: takes the
   seeds apart and puts them together wrongly. Its arguments are
   libFuzzer's: -runs=N -seed=N and folders of seeds; the last input is kept
   in build/fuzz/last, so that it is there when it has ended the process. */
#include "toolbox/random.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { SEEDS = 64, MOST = 1024 };

struct text {
    size_t size;
    uint8_t byte[MOST];
};

static struct text seeds[SEEDS];
static size_t count;

static void read_seeds(const char *folder)
{
    char path[512];
    DIR *d = opendir(folder);
    for (struct dirent *e; d && (e = readdir(d));) {
        snprintf(path, sizeof path, "%s/%s", folder, e->d_name);
        FILE *f = e->d_name[0] == '.' ? NULL : fopen(path, "r");
        if (f && count < SEEDS) {
            seeds[count].size = fread(seeds[count].byte, 1, MOST, f);
            ++count;
        }
        if (f)
            fclose(f);
    }
    if (d)
        closedir(d);
}

/* Puts n bytes in place of the next `gone` of the text. */
static void splice(struct text *t, size_t at, size_t gone,
                   const void *bytes, size_t n)
{
    struct text old = *t;
    if (gone > t->size - at)
        gone = t->size - at;
    if (n > MOST - at)
        n = MOST - at;
    size_t rest = old.size - at - gone;
    if (rest > MOST - at - n)
        rest = MOST - at - n;
    memcpy(t->byte + at, bytes, n);
    memcpy(t->byte + at + n, old.byte + at + gone, rest);
    t->size = at + n + rest;
}

static void mutate(struct text *t, struct random *r)
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
    const struct text *other = &seeds[random_below(r, count)];
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

int main(int argc, char *argv[])
{
    long runs = 100000, seed = 1;
    struct random r;
    for (int i = 1; i < argc; ++i)
        if (strncmp(argv[i], "-runs=", 6) == 0)
            runs = atol(argv[i] + 6);
        else if (strncmp(argv[i], "-seed=", 6) == 0)
            seed = atol(argv[i] + 6);
        else if (argv[i][0] != '-')
            read_seeds(argv[i]);
    const int last = open("build/fuzz/last", O_RDWR | O_CREAT, 0666);
    random_seed(&r, (uint64_t)seed);
    for (long i = 0; i < runs && count > 0; ++i) {
        struct text t = seeds[random_below(&r, count)];
        for (uint64_t k = random_below(&r, 6); k > 0; --k)
            mutate(&t, &r);
        if (last != -1 && ftruncate(last, (off_t)t.size) == 0)
            (void)!pwrite(last, t.byte, t.size, 0);
        LLVMFuzzerTestOneInput(t.byte, t.size);
    }
    fprintf(stderr, "Done %ld runs\n", count > 0 ? runs : 0);
    return count > 0 ? 0 : 1;
}
