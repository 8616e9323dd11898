/* A main for the fuzz target, for compilers without libFuzzer: takes the
   seeds apart and puts them together wrongly. Its arguments are
   libFuzzer's: -runs=N -seed=N and folders of seeds; the last input is kept
   in build/fuzz/last, so that it is there when it has ended the process. */
enum { SEEDS = 64, MOST = 1024 };
#include "mutate.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static struct text seeds[SEEDS];
static size_t count;

static void read_seeds(const char *folder)
{
    char path[512];
    DIR *d = opendir(folder);
    for (struct dirent *e; d && (e = readdir(d));) {
        snprintf(path, sizeof path, "%s/%s", folder, e->d_name);
        count += e->d_name[0] != '.' && count < SEEDS &&
                 read_text(path, &seeds[count]);
    }
    if (d)
        closedir(d);
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
            mutate(&t, &seeds[random_below(&r, count)], &r);
        if (last != -1 && ftruncate(last, (off_t)t.size) == 0)
            (void)!pwrite(last, t.byte, t.size, 0);
        LLVMFuzzerTestOneInput(t.byte, t.size);
    }
    fprintf(stderr, "Done %ld runs\n", count > 0 ? runs : 0);
    return count > 0 ? 0 : 1;
}
