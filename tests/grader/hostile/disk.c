/* passed: it fills its folder, and tries all others */
/* earns: all */
#include "exercise.h"
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { MIB = 1 << 20 };

static long fill(const char *folder)
{
    static char block[MIB];
    long written = 0;
    for (int i = 0; i < 100; ++i) {
        char path[256];
        snprintf(path, sizeof path, "%s/hostile-was-here-%d", folder, i);
        const int file = open(path, O_WRONLY | O_CREAT, 0666);
        const ssize_t now = file < 0 ? -1 : write(file, block, MIB);
        if (file >= 0)
            close(file);
        if (now < 0 && file < 0)
            break;
        written += now > 0 ? now : 0;
    }
    return written;
}

static void trick(void)
{
    static const char *const others[] = {
        "/",          "/tmp",      "/var/tmp",
        "/dev",       "/dev/shm",  "/etc",
        "/usr",       "/usr/lib",  "/kit",
        "/exercises", "/proc",     "/sys",
        "/root",      "/home",     "/run",
        "/dev/pts",   "..",        "../..",
        "@ROOT@",     "@SCRATCH@", "@ROOT@/build",
        "/opt",       "/mnt",      NULL};
    for (const char *const *other = others; *other; ++other)
        if (fill(*other) > 0)
            printf("BROKEN: could write to %s\n", *other);
    const long own = fill(".");
    if (own > 33 * MIB)
        printf("BROKEN: %ld bytes in its own folder\n", own);
}
