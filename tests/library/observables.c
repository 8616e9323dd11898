/* Observables of a scene whose numbers are known. */
#define UNIT_OWN_MAIN
#include "unit.h"

#include "forces/observables.h"

static struct scene scene;
static struct motion motion;

/* Masses 2 and 3, a spring of rest length 1, k2 = 5, weight along -z. */
static bool build(void)
{
    static const double place[] = {1, 4, 2, 6, 3, 3}; /* x x y y z z */
    static const double velocity[] = {1, 0, 0, -2, 3, 1};
    if (!scene_create(&scene, 2))
        return false;
    memcpy(scene.position, place, sizeof place);
    memcpy(scene.velocity, velocity, sizeof velocity);
    PUT(scene.mass, 2, 3);
    scene.freedom[1] = 1;
    scene.k2 = 5;
    scene.gravity[2] = -10;
    scene.dt = 0.5;
    scene.time = 7;
    return scene_add_kind(&scene, 4, 0) &&
           scene_add_spring(&scene, 0, 1, 0, 1) &&
           motion_begin(&motion, "observables", &scene, "leapfrog", 0);
}

static void look(const char *text, size_t n, const double expected[])
{
    struct observables o;
    char message[OBSERVABLES_MESSAGE] = "";
    double values[OBSERVABLES_MOST];
    for (size_t k = 0; k < OBSERVABLES_MOST; ++k)
        values[k] = 77;
    UNIT_TRUE(observables_read(&o, text, scene.bodies, message));
    UNIT_EQUAL(o.columns, n);
    observables_values(&o, &motion, values);
    for (size_t k = n; k < OBSERVABLES_MOST; ++k) /* nothing beyond */
        UNIT_EQUAL(values[k], 77);
    for (size_t k = 0; k < n; ++k) /* sums of a few numbers below 200 */
        UNIT_NEAR(values[k], expected[k], 1e-13);
}

static double look_at(const char *text)
{
    struct observables o;
    char message[OBSERVABLES_MESSAGE] = "";
    double values[OBSERVABLES_MOST] = {0};
    UNIT_TRUE(observables_read(&o, text, scene.bodies, message));
    observables_values(&o, &motion, values);
    return values[0];
}

/* The distance is 5: gravity -5*2*3/5, the spring 4/2 (5 - 1)^2. */
TEST(test_energies, "energy and its parts are the formulas'")
{
    const double kinetic = 10 + 1.5 * 5, gravity = -6, springs = 32,
                 weight = 10 * (2 * 3 + 3 * 3);
    look("parts", 4, (double[]){kinetic, gravity, springs, weight});
    look("kinetic", 1, (double[]){kinetic});
    look("potential", 1, (double[]){gravity + springs + weight});
    look("energy", 1, (double[]){kinetic + gravity + springs + weight});
    /* Momentum is kept along x and y, where the speeds differ by 1 and by
       2 and the reduced mass is 6/5, and not along z, where weight acts. */
    look("temperature", 1, (double[]){2 * (0.6 * (1 + 4) + 9 + 1.5) / 6});
}

/* A drift changes no temperature, unless something could stop it. */
TEST(test_drift, "a drift is no heat where momentum is kept")
{
    double *vx = scene.velocity;
    vx[0] += 1000;
    vx[1] += 1000;
    look("temperature", 1, (double[]){4.5});
    scene.freedom[1] = 0;
    const double kinetic =
        1001 * 1001 + 1.5 * 1000 * 1000 + 0.6 * 4 + 9 + 1.5;
    UNIT_NEAR(look_at("temperature"), 2 * kinetic / 6, 1e-9 * kinetic);
    scene.freedom[1] = 1;
    scene.wall[0] = SCENE_HARD;
    UNIT_NEAR(look_at("temperature"), 2 * kinetic / 6, 1e-9 * kinetic);
    scene.wall[0] = SCENE_OPEN;
    scene.damping = 0.1;
    UNIT_NEAR(look_at("temperature"), 2 * (kinetic - 2.4 + 6) / 6,
              1e-9 * kinetic);
    scene.damping = 0;
    vx[0] -= 1000;
    vx[1] -= 1000;
}

TEST(test_sums, "sums over bodies are the formulas'")
{
    look("t", 1, (double[]){7});
    look("momentum", 3, (double[]){2, -6, 9});
    look("centre", 3, (double[]){14 / 5., 22 / 5., 3});
    /* 2 (1,2,3)x(1,0,3) + 3 (4,6,3)x(0,-2,1) = 2 (6,0,-2) + 3 (12,-4,-8) */
    look("angular-momentum", 3, (double[]){48, -12, -28});
    look("collisions", 1, (double[]){0});
}

TEST(test_bodies, "bodies are asked one by one")
{
    look("x:0,y:0,z:0,vx:0,vy:0,vz:0", 6, (double[]){1, 2, 3, 1, 0, 3});
    look("x:1,y:1,z:1,vx:1,vy:1,vz:1", 6, (double[]){4, 6, 3, 0, -2, 1});
    look("speed:0,distance:0:1,distance:1:0,t", 4,
         (double[]){sqrt(10), 5, 5, 7});
    scene.velocity[0] = 6;
    scene.velocity[2] = 2;
    look("speed:0", 1, (double[]){7});
    scene.velocity[0] = 1;
    scene.velocity[2] = 0;
}

TEST(test_many, "as many as there is room for")
{
    struct observables o;
    char message[OBSERVABLES_MESSAGE] = "", many[8 * OBSERVABLES_MOST] = "";
    for (int k = 0; k < OBSERVABLES_MOST; ++k)
        strcat(many, k == 0 ? "parts" : ",x:1");
    UNIT_TRUE(observables_read(&o, many, 2, message));
    UNIT_EQUAL(o.count, OBSERVABLES_MOST);
    UNIT_EQUAL(o.columns, OBSERVABLES_MOST + 3);
}

/* Places are drawn along their axes, all else against time. */
TEST(test_sorts, "along which axis they lie")
{
    static const struct {
        const char *text;
        size_t width, axis;
        const char *unit;
    } sorts[] = {{"x:1", 1, 0, "length"},       {"y:0", 1, 1, "length"},
                 {"z:1", 1, 2, "length"},       {"t", 1, 3, "time"},
                 {"vx:1", 1, 3, "length/time"}, {"centre", 3, 3, "length"}};
    for (size_t i = 0; i < sizeof sorts / sizeof sorts[0]; ++i) {
        struct observables o;
        char message[OBSERVABLES_MESSAGE] = "";
        UNIT_TRUE(observables_read(&o, sorts[i].text, 2, message));
        const struct observables_sort sort = observables_sort(&o.list[0]);
        UNIT_EQUAL(sort.width, sorts[i].width);
        UNIT_EQUAL(sort.axis, sorts[i].axis);
        UNIT_SAYS(sort.unit, sorts[i].unit);
    }
}

TEST(test_states, "states of bodies")
{
    static const double right[] = {4, 6, 3, 0, -2, 1, 1, 2, 3, 1, 0, 3, 77};
    double values[13];
    values[12] = 77;
    observables_states(&motion, 2, (size_t[]){1, 0}, values);
    for (size_t k = 0; k < 13; ++k)
        UNIT_EQUAL(values[k], right[k]);
}

/* All that there are have a name and say how many bodies they are asked
   of, which reading them proves; then there are no more. */
TEST(test_names, "their names")
{
    static const char *const asked[] = {"", ":1", ":1:0"};
    size_t k = 0, bodies;
    const char *name;
    for (; (name = observables_name(k, &bodies)); ++k) {
        struct observables o;
        char message[OBSERVABLES_MESSAGE] = "", text[64];
        snprintf(text, sizeof text, "%s%s", name, asked[bodies]);
        UNIT_TRUE(observables_read(&o, text, 2, message));
    }
    UNIT_EQUAL(k, 18);
    UNIT_EQUAL(bodies, 0);
    UNIT_TRUE(!observables_name(k + 1, &bodies) && bodies == 0);
}

/* A column for each number, named after the bodies. */
TEST(test_head, "the head of a table of them")
{
    static const char path[] = "build/tests/observables-head";
    static const char *const lines[] = {
        " 1 px [mass length/time] momentum\n",
        " 3 pz [mass length/time] momentum\n",
        " 4 x:1 [length] coordinate of a body\n",
        " 5 d:1:0 [length] distance of two bodies\n",
        " 6 vy:0 [length/time] velocity of a body\n",
        " 7 x:1 [length] place\n",
        " 12 vz:1 [length/time] velocity\n"};
    static char text[4096];
    struct observables o;
    char message[OBSERVABLES_MESSAGE] = "";
    UNIT_TRUE(
        observables_read(&o, "momentum,x:1,distance:1:0,vy:0", 2, message));
    struct table *t = table_open("observables", path);
    CU_ASSERT_PTR_NOT_NULL_FATAL(t);
    observables_head(&o, t);
    observables_head_states(t, 1, (size_t[]){1});
    table_row(t, 12, (double[12]){0});
    UNIT_TRUE(table_close(t));
    FILE *f = fopen(path, "r");
    CU_ASSERT_PTR_NOT_NULL_FATAL(f);
    text[fread(text, 1, sizeof text - 1, f)] = '\0';
    fclose(f);
    remove(path);
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; ++i)
        UNIT_TRUE(strstr(text, lines[i]) != NULL);
}

static void refuse(const char *text, const char *why)
{
    struct observables o;
    char message[OBSERVABLES_MESSAGE] = "";
    UNIT_TRUE(!observables_read(&o, text, scene.bodies, message));
    UNIT_TRUE(strstr(message, why) != NULL);
    if (!strstr(message, why))
        printf("# '%s': %s\n", text, message);
}

TEST(test_numbers, "bodies by their numbers")
{
    struct observables o;
    char message[OBSERVABLES_MESSAGE], text[32];
    for (size_t bodies = 1; bodies <= 101; bodies += 10)
        for (size_t i = 0; i <= bodies; ++i) {
            snprintf(text, sizeof text, "x:%zu", i);
            UNIT_TRUE(observables_read(&o, text, bodies, message) ==
                      (i < bodies));
        }
}

TEST(test_refused, "what is no observable is refused")
{
    refuse("heat", "'heat' is no observable");
    refuse("", "'' is no observable");
    refuse("energy,", "'' is no observable");
    refuse("energ", "'energ' is no observable");
    refuse("t,z:2", "'z:2': z needs 1 of the bodies 0 to 1");
    refuse("z", "'z': z needs 1");
    refuse("z:", "'z:': z needs 1");
    refuse("z:-1", "'z:-1': z needs 1");
    refuse("z:0x", "'z:0x': z needs 1");
    refuse("z:0:1", "'z:0:1': z needs 1");
    refuse("z:99999999999999999999999", "z needs 1");
    refuse("energy:0", "'energy:0': energy is asked of no body");
    refuse("distance:0",
           "needs 2 of the bodies 0 to 1, as in distance:0:1");
    char many[3 * OBSERVABLES_MOST] = "t";
    for (int k = 0; k < OBSERVABLES_MOST; ++k)
        strcat(many, ",t");
    refuse(many, "more than 64");
}

int main(void)
{
    if (!build())
        return printf("not ok observables: no memory\n"), 1;
    const int result = unit_run("observables");
    motion_end(&motion);
    scene_free(&scene);
    return result;
}
