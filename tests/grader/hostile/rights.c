/* passed: it asks the kernel for more than it has */
/* earns: all */
#define _GNU_SOURCE
#include "exercise.h"
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

static void trick(void)
{
    const struct rlimit more = {RLIM_INFINITY, RLIM_INFINITY};
    static const int limits[] = {RLIMIT_CPU, RLIMIT_AS, RLIMIT_NPROC,
                                 RLIMIT_FSIZE, RLIMIT_CORE};
    for (int i = 0; i < 5; ++i)
        if (setrlimit(limits[i], &more) == 0)
            printf("BROKEN: limit %d could be raised\n", limits[i]);
    if (setuid(0) == 0 || setgid(0) == 0)
        printf("BROKEN: it could become root\n");
    if (mount("none", "/work", "tmpfs", 0, NULL) == 0 ||
        mount(NULL, "/", NULL, MS_REMOUNT, NULL) == 0 ||
        umount2("/exercises", MNT_DETACH) == 0)
        printf("BROKEN: it could mount\n");
    if (unshare(CLONE_NEWNET) == 0)
        printf("BROKEN: it could leave its network\n");
    if (sethostname("x", 1) == 0 || nice(-5) != -1)
        printf("BROKEN: it has rights of root\n");
    if (prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) != 1)
        printf("BROKEN: a set-user-id program would help it\n");
}
