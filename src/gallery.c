/* From chapters/08-scenes.nw: edit there, then run make tangle. */
/* checksum 1964114359 of the lines below */
#include "gallery.h"

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

const char *gallery_make(struct scene *s, const struct gallery_scene *g,
                         const char *name, double value)
{
    double values[GALLERY_KEYS + 1];
    gallery_usual(g, values);
    if (name)
        values[gallery_key(g, name)] = value;
    return g->build(s, values);
}
