/* Lists scenes that a program can make by name, and their parameters. */
#ifndef GALLERY_H
#define GALLERY_H

#include "scenes/scene.h"

/* A key is a parameter of a scene, set on a command line as in --particles
   3072. */
struct gallery_key {
    const char *name; /* without the dashes; NULL ends the list */
    double usual, low, high;
    bool whole;       /* only whole numbers are allowed */
    const char *help; /* one phrase, with the unit */
};

enum { GALLERY_KEYS = 15 }; /* maximum number of keys of a scene */

/* A scene that a program can make. For all values in the ranges of the
   keys, `build` must make a scene that can be written and read, or return a
   message. Tests set each key to each end of its range. */
struct gallery_scene {
    const char *name, *about; /* a name of NULL ends a list */
    struct gallery_key key[GALLERY_KEYS + 1];
    /* Makes the scene, with value[k] for key[k]. Returns NULL or, on
       failure, an error message; then there is nothing to free. */
    const char *(*build)(struct scene *s, const double value[]);
};

/* A value for a key. A list of choices ends with a key of NULL. */
struct gallery_choice {
    const char *key;
    double value;
};
#define GALLERY_CHOICES(...)                                               \
    ((const struct gallery_choice[]){__VA_ARGS__, {0}})

/* The scenes of chapters 9, 10 and 11. */
extern const struct gallery_scene celestial_scenes[];
extern const struct gallery_scene elastic_scenes[];
extern const struct gallery_scene hard_scenes[];

/* Returns the scene of this name, or NULL if the list has none. */
const struct gallery_scene *gallery_find(const struct gallery_scene list[],
                                         const char *name);

/* Fills value[] with the usual values of the keys. Returns the number of
   keys. */
size_t gallery_usual(const struct gallery_scene *g,
                     double value[GALLERY_KEYS]);

/* Returns the index of the key of this name in the scene. If there is none,
   returns the number of keys. */
size_t gallery_key(const struct gallery_scene *g, const char *name);

/* Makes the scene `name` of the list. Its keys have their usual values,
   except for those in `chosen`, which may be NULL. Returns the result of
   build, or a message if there is no such scene or key. */
const char *gallery_choose(struct scene *s,
                           const struct gallery_scene list[],
                           const char *name,
                           const struct gallery_choice chosen[]);

/* Makes the scene g with the usual values of its keys, except that the key
   `name` has the given value; name may be NULL. Returns NULL or a message,
   as gallery_choose does. */
const char *gallery_make(struct scene *s, const struct gallery_scene *g,
                         const char *name, double value);

#endif
