/* passed: memory that no limit on addresses counts */
/* earns: all */
#define _GNU_SOURCE
#include "exercise.h"
#include <stdio.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <unistd.h>

static void trick(void)
{
#if defined(__x86_64__) || defined(__aarch64__)
    const int shared = shmget(IPC_PRIVATE, 1 << 20, IPC_CREAT | 0600);
    if (shared >= 0) {
        shmctl(shared, IPC_RMID, NULL);
        printf("BROKEN: it could get memory to share\n");
    }
    if (memfd_create("x", 0) >= 0)
        printf("BROKEN: it could get a file that is memory\n");
#endif
    struct rlimit files;
    if (getrlimit(RLIMIT_NOFILE, &files) != 0 || files.rlim_max > 256)
        printf("BROKEN: it can open files without number\n");
}
