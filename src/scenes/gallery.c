/* Finds scenes and keys by name, and makes a scene from its keys. */
#include "scenes/gallery.h"

#include <string.h>

const struct gallery_scene *gallery_find(const struct gallery_scene list[],
                                         const char *name)
{
    for (; list->name; ++list)
        if (strcmp(list->name, name) == 0)
            return list;
    return NULL;
}

size_t gallery_usual(const struct gallery_scene *g,
                     double value[GALLERY_KEYS])
{
    size_t n = 0;
    for (; g->key[n].name; ++n)
        value[n] = g->key[n].usual;
    return n;
}

size_t gallery_key(const struct gallery_scene *g, const char *name)
{
    size_t n = 0;
    while (g->key[n].name && strcmp(g->key[n].name, name) != 0)
        ++n;
    return n;
}

const char *gallery_choose(struct scene *s,
                           const struct gallery_scene list[],
                           const char *name,
                           const struct gallery_choice chosen[])
{
    const struct gallery_scene *g = gallery_find(list, name);
    if (!g)
        return "there is no such scene";
    double value[GALLERY_KEYS];
    const size_t keys = gallery_usual(g, value);
    for (; chosen && chosen->key; ++chosen) {
        const size_t k = gallery_key(g, chosen->key);
        if (k == keys)
            return "the scene has no such key";
        value[k] = chosen->value;
    }
    return g->build(s, value);
}

const char *gallery_make(struct scene *s, const struct gallery_scene *g,
                         const char *name, double value)
{
    return gallery_choose(s, g, g->name,
                          (struct gallery_choice[]){{name, value}, {0}});
}
