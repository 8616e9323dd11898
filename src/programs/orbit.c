/* From chapters/11-step.nw: edit there, then run make tangle. */
/* checksum 3160393421 of the lines below */
#include "motion.h"

#include <stdio.h>

int main(int argc, char *argv[])
{
    struct scene s;
    struct motion m;
    if (!scene_read(&s, "orbit", argc > 1 ? argv[1] : "-") ||
        !motion_begin(&m, "orbit", &s, "leapfrog", 0))
        return 2;
    while (motion_time(&m) < 50000 && motion_run(&m, 1) == STEPPING_DONE)
        printf("%.9g %.9g %.9g\n", motion_time(&m), s.position[1],
               s.position[s.bodies + 1]);
    const bool good = motion_time(&m) >= 50000 && fflush(stdout) == 0;
    motion_end(&m);
    scene_free(&s);
    return good && !ferror(stdout) ? 0 : 1;
}
