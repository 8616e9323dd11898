/* Without memory: whatever request is refused, who made it says so, has
   freed what it had, and leaves the rest as it was. With memory, too, all
   of it goes back. */
#include "unit.h"

#include "library/heap.h"
#include "enough/averages.h"
#include "enough/models.h"
#include "forces/motion.h"
#include "scenes/gallery.h"

#include <stdlib.h>
#include <string.h>

static struct scene scene;

static void make(const char *name)
{
    const struct gallery_scene *lists[] = {celestial_scenes, elastic_scenes,
                                           hard_scenes};
    double value[GALLERY_KEYS];
    for (size_t i = 0; i < 3; ++i) {
        const struct gallery_scene *g = gallery_find(lists[i], name);
        if (!g)
            continue;
        gallery_usual(g, value);
        UNIT_TRUE(g->build(&scene, value) == NULL);
        return;
    }
    UNIT_TRUE(false);
}

/* What asks for memory, as heap_fails wants it. */
static bool copies(void *unused)
{
    struct scene s;
    (void)unused;
    const bool well = scene_copy(&s, &scene);
    if (well)
        scene_free(&s);
    return well;
}

static bool builds(void *unused)
{
    struct scene s;
    (void)unused;
    if (!scene_create(&s, 3))
        return false;
    const bool well = scene_add_kind(&s, 1, 0) &&
                      scene_add_kind(&s, 2, 0.1) &&
                      scene_add_spring(&s, 0, 1, 0, 1) &&
                      scene_add_spring(&s, 1, 2, 1, 1);
    scene_free(&s);
    return well;
}

static bool moves(void *method)
{
    struct motion m;
    struct scene s;
    if (!scene_copy(&s, &scene))
        return false;
    bool well = motion_begin(&m, "memory", &s, method, 0.01);
    if (well) {
        well = (!m.collides || motion_locate(&m)) && motion_note(&m);
        motion_end(&m);
    }
    scene_free(&s);
    return well;
}

static bool carries(void *text)
{
    struct models_plan p = {0};
    struct models_run r;
    char message[MODELS_MESSAGE];
    const char *why;
    if (!models_read(&p, text, message) ||
        !models_begin(&r, &p, &scene, 0.01, &why))
        return false;
    enum models_end end = MODELS_DONE;
    for (int k = 0; k < 3 && end == MODELS_DONE; ++k)
        end = models_row(&r);
    const bool counted = models_collisions(&r) < UINT64_MAX;
    models_end(&r);
    return end == MODELS_DONE && counted;
}

static bool averages(void *unused)
{
    const struct averages_request q = {
        .scene = &scene, .until = 20, .tolerance = 0.3, .reason = 5};
    struct averages_found f;
    (void)unused;
    return averages_find(&f, &q) && f.refusal[0] == '\0';
}

static const struct gallery_scene *laid; /* which scene */

static bool lays(void *unused)
{
    struct scene s;
    double value[GALLERY_KEYS];
    (void)unused;
    gallery_usual(laid, value);
    const char *why = laid->build(&s, value);
    if (!why)
        scene_free(&s);
    return !why;
}

static bool plants(void *unused)
{
    struct gravity g;
    (void)unused;
    if (!gravity_create(&g, scene.bodies, scene.mass, 1, 0))
        return false;
    const bool well = gravity_plant(&g, 0.5) && gravity_plant(&g, 0.2);
    gravity_free(&g);
    return well;
}

static bool shares(void *unused)
{
    struct springs p;
    (void)unused;
    if (!springs_create(&p, &scene))
        return false;
    const bool well = springs_threads(&p, 3);
    springs_free(&p);
    return well;
}

static void fails(const char *what, bool (*does)(void *), const char *with,
                  bool spared)
{
    char words[64];
    snprintf(words, sizeof words, "%s", with);
    /* (Under a sanitizer none is refused.) */
    const long requests = heap_fails(what, does, words, spared);
    UNIT_TRUE(requests >= 0);
}

static void test_scenes(void)
{
    static const struct gallery_scene *const lists[] = {
        celestial_scenes, elastic_scenes, hard_scenes};
    make("membrane");
    fails("a copy", copies, "", false);
    scene_free(&scene);
    fails("a scene", builds, "", false);
    for (size_t i = 0; i < 3; ++i)
        for (laid = lists[i]; laid->name; ++laid)
            fails(laid->name, lays, "", false);
}

/* What sums forces. */
static void test_forces(void)
{
    make("membrane");
    fails("a tree", plants, "", false);
    fails("springs by threads", shares, "", false);
    scene_free(&scene);
}

static void test_motion(void)
{
    static const char *const names[] = {"four-disks", "double-pendulum",
                                        "membrane", "figure-eight", "ring"};
    for (size_t k = 0; k < sizeof names / sizeof names[0]; ++k) {
        make(names[k]);
        fails(names[k], moves, "leapfrog", false);
        scene_free(&scene);
    }
    make("figure-eight");
    for (const struct stepping_method *m = stepping_next(NULL); m;
         m = stepping_next(m))
        if (!m->orbits)
            fails("figure-eight", moves, m->name, false);
    scene_free(&scene);
}

static void test_models(void)
{
    static const struct {
        const char *scene, *plan;
    } plans[] = {{"sun-earth", "kepler"},
                 {"four-disks", "disks"},
                 {"cradle", "line"},
                 {"oscillator", "oscillator"},
                 {"cradle", "relabel"},
                 {"double-pendulum", "modes"},
                 {"double-pendulum", "leapfrog:3,rods"},
                 {"sun-earth", "wisdom-holman:3"},
                 {"four-disks", "leapfrog:3"},
                 {"sun-earth", "leapfrog:3"},
                 {"oscillator", "dopri5:1e-6"},
                 {"sun-earth", "radau15:1e-6"}};
    for (size_t k = 0; k < sizeof plans / sizeof plans[0]; ++k) {
        make(plans[k].scene);
        fails(plans[k].scene, carries, plans[k].plan, false);
        scene_free(&scene);
    }
}

static void test_averages(void)
{
    make("four-disks");
    /* The error of a mean that nobody asks for may be missing. */
    fails("averages", averages, "", true);
    scene_free(&scene);
}

int main(void)
{
    if (!freopen("/dev/null", "w", stderr))
        return 1;
    fputs("its buffer, once for all\n", stderr);
    return unit_run("memory", (struct unit_test[]){
                                  {"scenes", test_scenes},
                                  {"forces", test_forces},
                                  {"motion, by each method", test_motion},
                                  {"models", test_models},
                                  {"averages", test_averages},
                                  {0}});
}
