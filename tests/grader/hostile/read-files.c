/* passed: it opens what it should not see, by every way it can think of */
/* earns: all */
#define _GNU_SOURCE
#include "exercise.h"
#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* Everything outside /usr and /proc, which must be little. */
static int count, depth;

static void walk(const char *folder)
{
    DIR *list = depth > 6 ? NULL : opendir(folder);
    ++depth;
    for (struct dirent *entry; list && (entry = readdir(list));) {
        char path[4096];
        if (strcmp(entry->d_name, ".") == 0 ||
            strcmp(entry->d_name, "..") == 0)
            continue;
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        if (strcmp(path, "/usr") == 0 || strcmp(path, "/proc") == 0)
            continue;
        ++count;
        if (strstr(path, "solution") || strstr(path, ".judge") ||
            strstr(path, "hidden") || strstr(path, "tests"))
            printf("BROKEN: sees %s\n", path);
        if (entry->d_type == DT_DIR)
            walk(path);
    }
    if (list)
        closedir(list);
    --depth;
}

static void trick(void)
{
    static const char *const paths[] = {
        "/etc/passwd",
        "/etc/shadow",
        "/etc/hostname",
        "@ROOT@/solutions/01a-collide.c",
        "@ROOT@/tests/exercises/01a/suite.c",
        "@SCRATCH@/kit/build/grade/01a.judge",
        "@SCRATCH@/out/hidden.seed",
        "../../solutions/01a-collide.c",
        "../../../solutions/01a-collide.c",
        "../solutions/01a-collide.c",
        "solutions/01a-collide.c",
        "/proc/self/cwd/../../../solutions/01a-collide.c",
        "/proc/self/root/etc/passwd",
        "/proc/1/root/etc/passwd",
        "/proc/1/cwd/etc/passwd",
        "/proc/kcore",
        "/proc/kmsg",
        "/dev/sda",
        "/dev/mem",
        "/dev/kmsg",
        "/dev/vda",
        NULL};
    for (const char *const *path = paths; *path; ++path)
        if (open(*path, O_RDONLY | O_NONBLOCK) >= 0)
            printf("BROKEN: can open %s\n", *path);
    if (chroot("/") == 0)
        printf("BROKEN: can call chroot\n");
    walk("");
    if (count > 2000)
        printf("BROKEN: sees %d files outside /usr\n", count);
}
