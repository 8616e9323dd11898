/* From chapters/11-step.nw: edit there, then run make tangle. */
/* checksum 2115311974 of the lines below */
/* Prints the orbit of a planet: a minimal program that uses the library. */
#include "forces/motion.h"
#include "toolbox/options.h"

#include <stdio.h>

int main(int argc, char *argv[])
{
    static const struct options_entry entries[] = {
        {"", 0, "[SCENE]", "a scene file; - is standard input"}, {0}};
    const char *file = NULL;
    struct options o;
    struct scene s;
    struct motion m;
    options_begin(&o, "orbit", "Print t, x and y of body 1 until 50000.",
                  entries, argc, argv);
    while (options_next(&o) != -1) {
        if (file)
            options_fail(&o, "'%s': one SCENE is enough", options_text(&o));
        file = options_text(&o);
    }
    if (!scene_read(&s, "orbit", file ? file : "-") ||
        !motion_begin(&m, "orbit", &s, "leapfrog", 0))
        return 2;
    while (motion_time(&m) < 50000 && motion_run(&m, 1) == STEPPING_DONE)
        printf("%.9g %.9g %.9g\n", motion_time(&m), s.position[1],
               s.position[s.bodies + 1]);
    const bool good =
        motion_time(&m) >= 50000 && fflush(stdout) == 0 && !ferror(stdout);
    if (!good)
        fprintf(stderr, "orbit: at t = %.9g: not finite, or not written\n",
                motion_time(&m));
    motion_end(&m);
    scene_free(&s);
    return good ? 0 : 1;
}
