/* Observables of a scene whose numbers are known. */
#include "unit.h"

#include "forces/observables.h"

#include <stdlib.h>

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
    scene.mass[0] = 2;
    scene.mass[1] = 3;
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
    double values[OBSERVABLES_MOST] = {0};
    UNIT_TRUE(observables_read(&o, text, scene.bodies, message));
    UNIT_EQUAL((double)o.columns, (double)n);
    observables_values(&o, &motion, values);
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
static void test_energies(void)
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
static void test_drift(void)
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

static void test_sums(void)
{
    look("t", 1, (double[]){7});
    look("momentum", 3, (double[]){2, -6, 9});
    look("centre", 3, (double[]){14 / 5., 22 / 5., 3});
    /* 2 (1,2,3)x(1,0,3) + 3 (4,6,3)x(0,-2,1) = 2 (6,0,-2) + 3 (12,-4,-8) */
    look("angular-momentum", 3, (double[]){48, -12, -28});
    look("collisions", 1, (double[]){0});
}

static void test_bodies(void)
{
    look("x:0,y:0,z:0,vx:0,vy:0,vz:0", 6, (double[]){1, 2, 3, 1, 0, 3});
    look("x:1,y:1,z:1,vx:1,vy:1,vz:1", 6, (double[]){4, 6, 3, 0, -2, 1});
    look("speed:0,distance:0:1,distance:1:0,t", 4,
         (double[]){sqrt(10), 5, 5, 7});
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

/* Every body has its number, and there is none beyond the last. */
static void test_numbers(void)
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

static void test_refused(void)
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
    const int result = unit_run(
        "observables",
        (struct unit_test[]){
            {"energy and its parts are the formulas'", test_energies},
            {"a drift is no heat where momentum is kept", test_drift},
            {"sums over bodies are the formulas'", test_sums},
            {"bodies are asked one by one", test_bodies},
            {"what is no observable is refused", test_refused},
            {"bodies by their numbers", test_numbers},
            {0}});
    motion_end(&motion);
    scene_free(&scene);
    return result;
}
