/* The gallery: every scene can be made, with each key at its ends too, and
   comes back from its file with the same bits. */
#include "unit.h"

#include "scenes/gallery.h"
#include "library/scene_same.h"
#include "toolbox/table.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const struct gallery_scene *const lists[] = {
    celestial_scenes, elastic_scenes, hard_scenes};
enum { LISTS = sizeof lists / sizeof lists[0] };

/* Calls look for every scene; returns the sum. */
static int for_all(int (*look)(const struct gallery_scene *))
{
    int sum = 0;
    for (size_t i = 0; i < LISTS; ++i)
        for (const struct gallery_scene *g = lists[i]; g->name; ++g)
            sum += look(g);
    return sum;
}

static int complain(const struct gallery_scene *g, const char *what,
                    const char *more)
{
    printf("not ok gallery: %s: %s - %s\n", g->name, what, more);
    return 1;
}

/* Options have names of their own, and values that they may take. */
static int check_keys(const struct gallery_scene *g)
{
    int bad = 0;
    for (size_t k = 0; g->key[k].name; ++k) {
        const struct gallery_key *key = &g->key[k];
        if (!(key->low <= key->usual && key->usual <= key->high))
            bad +=
                complain(g, key->name, "its usual value is out of range");
        if (key->whole && key->usual != floor(key->usual))
            bad += complain(g, key->name, "its usual value is not whole");
        if (gallery_key(g, key->name) != k)
            bad += complain(g, key->name, "there are two");
        if (k >= GALLERY_KEYS || !key->help || !*key->help)
            bad += complain(g, key->name, "it has no help, or no place");
    }
    return bad;
}

static void test_keys(void)
{
    UNIT_EQUAL(for_all(check_keys), 0);
}

static const struct gallery_scene *other;

static int is_namesake(const struct gallery_scene *g)
{
    return strcmp(g->name, other->name) == 0;
}

static int check_name(const struct gallery_scene *g)
{
    other = g;
    return for_all(is_namesake) - 1;
}

static void test_names(void)
{
    UNIT_EQUAL(for_all(check_name), 0);
}

/* Writes and reads; says whether it is the same. */
static bool comes_back(const struct scene *s)
{
    static const char *const path = "build/tests/gallery.plist";
    struct scene again;
    struct table *t = table_open("gallery", path);
    if (!t)
        return false;
    scene_write(s, t);
    bool good = table_close(t) && scene_read(&again, "gallery", path);
    if (good) {
        good = scene_same(s, &again);
        scene_free(&again);
    }
    unlink(path);
    return good;
}

static int check_written(const struct gallery_scene *g)
{
    struct scene s;
    const char *wrong = gallery_make(&s, g, NULL, 0);
    if (wrong)
        return complain(g, "it cannot be made", wrong);
    const bool good = comes_back(&s);
    scene_free(&s);
    return good ? 0 : complain(g, "written and read", "it is another");
}

static void test_written(void)
{
    UNIT_EQUAL(for_all(check_written), 0);
}

/* A key at one of its ends gives a scene that is good, or a refusal that
   says why. */
static int check_end(const struct gallery_scene *g, size_t k, double value)
{
    struct scene s;
    const char *wrong = gallery_make(&s, g, g->key[k].name, value);
    if (wrong)
        return *wrong ? 0 : complain(g, g->key[k].name, "refused, no word");
    const bool good = comes_back(&s);
    scene_free(&s);
    return good ? 0 : complain(g, g->key[k].name, "a bad scene at an end");
}

static int check_ends(const struct gallery_scene *g)
{
    int bad = 0;
    for (size_t k = 0; g->key[k].name; ++k) {
        const struct gallery_key *key = &g->key[k];
        if (key->low > -INFINITY)
            bad += check_end(g, k, key->low);
        if (key->high < INFINITY && !(key->whole && key->high > 300))
            bad += check_end(g, k, key->high);
    }
    return bad;
}

static void test_ends(void)
{
    UNIT_EQUAL(for_all(check_ends), 0);
}

/* Chosen values, and refusals of what is not there, as build makes them. */
static void test_chosen(void)
{
    const struct gallery_scene *g = gallery_find(hard_scenes, "cradle");
    double value[GALLERY_KEYS];
    struct scene s, t;
    gallery_usual(g, value);
    value[gallery_key(g, "left")] = 2;
    value[gallery_key(g, "gap")] = 0.25;
    CU_ASSERT_PTR_NULL_FATAL(g->build(&s, value));
    CU_ASSERT_PTR_NULL_FATAL(gallery_choose(
        &t, hard_scenes, "cradle",
        (struct gallery_choice[]){{"left", 2}, {"gap", 0.25}, {0}}));
    CU_ASSERT(scene_same(&s, &t));
    scene_free(&s);
    scene_free(&t);
    CU_ASSERT_PTR_NOT_NULL(gallery_choose(
        &t, hard_scenes, "cradle",
        (struct gallery_choice[]){{"gap", 0.25}, {"leff", 2}, {0}}));
    CU_ASSERT_PTR_NOT_NULL(
        gallery_choose(&t, elastic_scenes, "cradle", NULL));
}

int main(void)
{
    return unit_run("gallery",
                    (struct unit_test[]){
                        {"keys have values that they may take", test_keys},
                        {"every scene has its own name", test_names},
                        {"scenes come back from files", test_written},
                        {"keys at their ends do no harm", test_ends},
                        {"what is chosen, and nothing else", test_chosen},
                        {0}});
}
