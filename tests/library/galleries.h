/* A scene of the gallery, whichever of its lists has it. */
#ifndef GALLERIES_H
#define GALLERIES_H

#include "scenes/gallery.h"
#include "unit.h"

static const struct gallery_scene *const galleries[] = {
    celestial_scenes, elastic_scenes, hard_scenes};
enum { GALLERIES = sizeof galleries / sizeof *galleries };

static inline const struct gallery_scene *find_anywhere(const char *name)
{
    const struct gallery_scene *g = NULL;
    for (size_t i = 0; !g && i < GALLERIES; ++i)
        g = gallery_find(galleries[i], name);
    UNIT_MUST(g);
    return g;
}

/* With its usual values, but for that of the key, unless that is NULL. */
static inline struct scene made(const char *name, const char *key,
                                double value)
{
    struct scene s = {0};
    UNIT_TRUE(!gallery_make(&s, find_anywhere(name), key, value));
    return s;
}

#endif
