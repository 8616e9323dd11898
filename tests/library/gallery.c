/* The gallery: every scene can be made, with each key at its ends too, and
   comes back from its file with the same bits, which are those that it
   always had. */
#define UNIT_OWN_MAIN
#include "unit.h"

#include "library/galleries.h"
#include "library/scene_same.h"
#include "toolbox/table.h"

#include <inttypes.h>
#include <unistd.h>

/* Calls look for every scene; returns the sum. */
static int for_all(int (*look)(const struct gallery_scene *))
{
    int sum = 0;
    for (size_t i = 0; i < GALLERIES; ++i)
        for (const struct gallery_scene *g = galleries[i]; g->name; ++g)
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

TEST(test_keys, "keys have values that they may take")
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

TEST(test_names, "every scene has its own name")
{
    UNIT_EQUAL(for_all(check_name), 0);
}

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
        if (key->high < INFINITY)
            bad += check_end(
                g, k, key->whole && key->high > 300 ? 100 : key->high);
    }
    return bad;
}

TEST(test_ends, "keys at their ends do no harm")
{
    UNIT_EQUAL(for_all(check_ends), 0);
}

TEST(test_chosen, "what is chosen, and nothing else")
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

/* What a command that somebody has written down makes stays what it is: a
   key is there, may have the values that it could have, and the scene that
   it makes has the same bits. The file has what is promised, a line each: a
   scene, a key, its usual value, its least and its largest, whether it is
   whole, another value, and the sum of the scene that has that, or 0 where
   it is refused. A scene that is not in the file has promised nothing yet;
   build/tests/library/gallery sums writes the file anew. */
#define SUMS "tests/library/scenes.txt"

static uint64_t sum_of(const struct gallery_scene *g, const char *key,
                       double value)
{
    struct scene s;
    if (gallery_make(&s, g, key, value))
        return 0;
    const uint64_t sum = scene_sum(&s);
    scene_free(&s);
    return sum;
}

/* A value of a key that is neither usual nor an end, if there is one. */
static double another(const struct gallery_key *key)
{
    const double u = key->usual;
    if (key->whole)
        return u + 1 <= key->high ? u + 1 : u - 1;
    const double more = u != 0 ? 1.25 * u : 0.1;
    return more <= key->high ? more : 0.75 * u;
}

static int write_sums(const struct gallery_scene *g)
{
    for (size_t k = 0; g->key[k].name; ++k) {
        const struct gallery_key *key = &g->key[k];
        const double value = another(key);
        printf("%s %s %.17g %.17g %.17g %d %.17g %" PRIu64 "\n", g->name,
               key->name, key->usual, key->low, key->high, key->whole,
               value, sum_of(g, key->name, value));
    }
    return 0;
}

TEST(test_sums, "they are what they always were")
{
    char name[32], word[32];
    double usual, low, high, value;
    int whole;
    uint64_t sum;
    size_t lines = 0;
    FILE *f = fopen(SUMS, "r");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    for (; fscanf(f, "%31s %31s %lf %lf %lf %d %lf %" SCNu64, name, word,
                  &usual, &low, &high, &whole, &value, &sum) == 8;
         ++lines) {
        const struct gallery_scene *g = find_anywhere(name);
        const struct gallery_key *key = &g->key[gallery_key(g, word)];
        if (!key->name || key->usual != usual || key->low != low ||
            key->high != high || key->whole != whole)
            UNIT_EQUAL(complain(g, word, "not as it was promised"), 0);
        else if (sum_of(g, word, value) != sum)
            UNIT_EQUAL(complain(g, word, "it makes another scene"), 0);
    }
    UNIT_TRUE(feof(f) && lines > 100);
    fclose(f);
}

int main(int count, char *words[])
{
    if (count > 1 && strcmp(words[1], "sums") == 0)
        return for_all(write_sums);
    return unit_run("gallery");
}
