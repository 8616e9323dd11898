/* passed: it reads what the list of processes knows */
/* earns: all */
#define _GNU_SOURCE
#include "exercise.h"
#include <ctype.h>
#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ptrace.h>
#include <unistd.h>

static void look(const char *pid, const char *name)
{
    char path[300];
    static char bytes[65536];
    snprintf(path, sizeof path, "/proc/%s/%s", pid, name);
    const int file = open(path, O_RDONLY);
    const ssize_t got = file < 0 ? 0 : read(file, bytes, sizeof bytes);
    if (file >= 0)
        close(file);
    if (got > 0 && (memmem(bytes, (size_t)got, "judge", 5) ||
                    memmem(bytes, (size_t)got, "@SEED@", 6) ||
                    memmem(bytes, (size_t)got, "HOSTILE=", 8) ||
                    memmem(bytes, (size_t)got, "@SCRATCH@/kit",
                           sizeof "@SCRATCH@/kit" - 1)))
        printf("BROKEN: %s tells a secret\n", path);
}

static void trick(void)
{
    int processes = 0;
    DIR *list = opendir("/proc");
    for (struct dirent *entry; list && (entry = readdir(list));)
        if (isdigit((unsigned char)entry->d_name[0])) {
            ++processes;
            look(entry->d_name, "cmdline");
            look(entry->d_name, "environ");
        }
    if (list)
        closedir(list);
    if (processes > 8)
        printf("BROKEN: sees %d processes\n", processes);
    for (int file = 5; file < 1024; ++file)
        if (fcntl(file, F_GETFD) >= 0)
            printf("BROKEN: descriptor %d is open\n", file);
    if (getppid() == 1 || getuid() == 0 || geteuid() == 0)
        printf("BROKEN: it is root, or has no driver\n");
    for (char **all = environ; *all; ++all)
        if (strncmp(*all, "HOSTILE=", 8) == 0)
            printf("BROKEN: it has our environment\n");
}
