/* The scenes of hard bodies, and that they equal the starts of parts I and
   II. */
#include "unit.h"

#include "library/galleries.h"
#include "line/bonkers.h"
#include "forces/hard.h"
#include "forces/spheres.h"

/* No two overlap by more than rounding does, and none sticks out. */
static bool fits(const struct scene *s)
{
    const size_t n = s->bodies;
    for (size_t i = 0; i < n; ++i) {
        for (size_t k = 0; k < SCENE_AXES; ++k)
            if (s->wall[k] == SCENE_HARD &&
                !(s->position[k * n + i] >=
                      s->low[k] + s->radius[i] - 1e-9 &&
                  s->position[k * n + i] <=
                      s->high[k] - s->radius[i] + 1e-9))
                return false;
        for (size_t j = 0; j < i; ++j) {
            double square = 0;
            for (size_t k = 0; k < SCENE_AXES; ++k)
                square +=
                    pow(s->position[k * n + i] - s->position[k * n + j], 2);
            if (!(sqrt(square) >= s->radius[i] + s->radius[j] - 1e-9))
                return false;
        }
    }
    return true;
}

TEST(test_all, "every scene can be made, and fits")
{
    size_t count = 0;
    for (const struct gallery_scene *g = hard_scenes; g->name;
         ++g, ++count) {
        double value[GALLERY_KEYS];
        const size_t keys = gallery_usual(g, value);
        FREED(scene) s;
        for (size_t k = 0; k < keys; ++k) {
            UNIT_TRUE(value[k] >= g->key[k].low &&
                      value[k] <= g->key[k].high);
            UNIT_TRUE(!g->key[k].whole || value[k] == floor(value[k]));
        }
        UNIT_TRUE(!g->build(&s, value));
        UNIT_TRUE(s.contact && s.dt > 0 && fits(&s));
    }
    UNIT_TRUE(count >= 8);
}

TEST(test_wrong, "what cannot be made is refused")
{
    const struct gallery_scene *cradle =
        gallery_find(hard_scenes, "cradle");
    struct scene s;
    UNIT_TRUE(gallery_make(&s, cradle, "left", 6) != NULL);
    UNIT_TRUE(gallery_make(&s, cradle, "string", 0.25) != NULL);
    UNIT_TRUE(gallery_make(&s, gallery_find(hard_scenes, "gas"), "radius",
                           1) != NULL);
    UNIT_TRUE(gallery_make(&s, gallery_find(hard_scenes, "piston"),
                           "particles", 10) != NULL);
}

/* `disks --disks 4 --radius 0.15 --box 1,1 --seed 7`, as that program makes
   it (chapter 7). */
TEST(test_four_disks, "four disks are those of chapter 5")
{
    FREED(disks) e;
    SEEDED(r, 7);
    FREED(scene) s = made("four-disks", "seed", 7);
    CREATED(disks, d, 2, 4);
    d.box[0] = d.box[1] = 1;
    for (size_t i = 0; i < 4; ++i)
        d.disk[i].radius = 0.15;
    UNIT_TRUE(disks_place_lattice(&d));
    disks_set_speed(&d, 1, &r);
    UNIT_TRUE(hard_disks(&e, &s));
    UNIT_TRUE(memcmp(d.disk, e.disk, 4 * sizeof *d.disk) == 0);
    UNIT_TRUE(memcmp(d.box, e.box, sizeof d.box) == 0);
}

static const char *const lines[] = {"thermal", "piston", "galperin"};
static const enum start_kind kinds[] = {START_THERMAL, START_PISTON,
                                        START_GALPERIN};

/* Without a radius number for number; with one the collisions are as many:
   for 20 s, since rounding grows. */
TEST(test_lines, "the lines are those of chapters 2 to 4")
{
    for (int k = 0; k < 3; ++k)
        for (int wide = 0; wide < 2; ++wide) {
            FREED(start) a, b;
            FREED(bonkers) x, y;
            size_t wrong;
            FREED(scene) s = made(lines[k], "radius", wide ? 0.05 : 0);
            const struct start_request request = {.kind = kinds[k],
                                                  .seed = 1};
            UNIT_TRUE(start_fill(&a, &request) && hard_start(&b, &s));
            UNIT_EQUAL(b.movers, a.movers);
            for (size_t i = 0; i < a.movers; ++i) {
                UNIT_EQUAL(b.mass[i], a.mass[i]);
                UNIT_EQUAL(b.v[i], a.v[i]);
                if (!wide)
                    UNIT_EQUAL(b.x[i], a.x[i]);
            }
            for (size_t i = wide; i < a.movers; ++i)
                b.radius[i] = s.radius[0];
            b.radius[0] = s.radius[0];
            UNIT_TRUE(bonkers_begin(&x, &a, 1, BONKERS_SCAN, &wrong) &&
                      bonkers_begin(&y, &b, 1, BONKERS_SCAN, &wrong));
            bonkers_run(&x, 20, UINT64_MAX);
            bonkers_run(&y, 20, UINT64_MAX);
            UNIT_TRUE(x.collisions > 0);
            UNIT_EQUAL(y.collisions, x.collisions);
        }
}

/* Steps see the ten bodies collide as often as events do: the mean of
   2 s, up to one collision that is not yet found. */
TEST(test_line_by_steps, "a line collides as often by steps")
{
    FREED(start) start;
    FREED(bonkers) b;
    size_t wrong;
    FREED(scene) s = made("thermal", NULL, 0);
    UNIT_TRUE(hard_start(&start, &s) &&
              bonkers_begin(&b, &start, 1, BONKERS_SCAN, &wrong));
    bonkers_run(&b, 2, UINT64_MAX);
    CREATED(spheres, p, &s, SPHERES_APPROACHING);
    p.shift = SPHERES_BACK;
    p.dt = 0.001;
    for (int k = 0; k < 2000; ++k) {
        for (size_t i = 0; i < s.bodies; ++i)
            s.position[i] += s.velocity[i] * p.dt;
        spheres_resolve(&p, s.position, s.velocity);
    }
    UNIT_NEAR(p.collisions + p.wall_collisions, b.collisions, 1);
}

/* A hanging ball feels no force: string and weight cancel. */
TEST(test_strings, "hanging balls hang")
{
    FREED(scene) s = made("cradle", "string", 1);
    UNIT_EQUAL(s.bodies, 10);
    UNIT_EQUAL(s.springs, 5);
    for (size_t i = 0; i < 5; ++i) {
        const struct scene_spring *g = &s.spring[i];
        const double dx = s.position[g->a] - s.position[g->b],
                     dz = s.position[20 + g->a] - s.position[20 + g->b];
        UNIT_NEAR(sqrt(dx * dx + dz * dz), 1, 1e-15);
        UNIT_NEAR(s.kind[0].stiffness * (1 - g->rest),
                  s.mass[i] * -s.gravity[2], 1e-10);
        UNIT_TRUE(!s.freedom[g->b] && !s.freedom[20 + g->b]);
        UNIT_NEAR(s.velocity[i], 0, 0);
    }
    UNIT_NEAR(s.position[0] - s.position[5], -0.5, 1e-15);
}
