/* Gravity on a device, if there is one: the bits of the portable kernel in
   double precision, by either way to share the bodies out, and what single
   precision leaves of it. Without a device: that it is said. */
#define UNIT_OWN_MAIN
#include "unit.h"

#include "forces/gravity.h"
#include "forces/opencl.h"
#include "toolbox/random.h"

enum { BODIES = 777 }; /* no multiple of 8, 16 or 64 */
static double mass[BODIES], x[3 * BODIES];
static const double k2 = 0.7, softening = 1e-3;
static char message[OPENCL_MESSAGE];

static void make_bodies(void)
{
    SEEDED(r, 1);
    for (size_t i = 0; i < BODIES; ++i)
        mass[i] = i == 3 ? 1 : 1e-6 * random_uniform(&r);
    for (size_t i = 0; i < 3 * BODIES; ++i)
        x[i] = random_uniform(&r);
}

static struct opencl *open(bool single, enum opencl_way way)
{
    const struct opencl_order order = {BODIES,    mass,   k2,
                                       softening, single, way};
    return opencl_open(&order, message);
}

static void sum_here(double a[])
{
    MADE(gravity, g, gravity_create(&g, BODIES, mass, k2, softening));
    g.kernel = GRAVITY_PORTABLE;
    gravity_add(&g, x, a);
}

static void test_bits(void)
{
    for (int way = OPENCL_AUTO; way <= OPENCL_TILES; ++way) {
        static double here[3 * BODIES], there[3 * BODIES];
        struct opencl *device = open(false, (enum opencl_way)way);
        UNIT_TRUE(device);
        if (!device)
            return;
        for (size_t i = 0; i < 3 * BODIES; ++i)
            here[i] = there[i] = 1;
        sum_here(here);
        opencl_add(device, x, there);
        UNIT_TRUE(!opencl_failure(device));
        UNIT_TRUE(memcmp(here, there, sizeof here) == 0);
        UNIT_TRUE(*opencl_name(device));
        opencl_close(&device);
        UNIT_TRUE(!device);
    }
}

/* Coordinates up to 1 are rounded by 2^-25, a distance by twice that in
   each axis, so a pull over the distance r by at most 3 * 2^-24 * sqrt(3) /
   r, and by a few 2^-24 for its operations; sums keep their losses. Of the
   whole, the pull of the heavy body, nearest at r, is all but a thousandth.
 */
static void test_single(void)
{
    for (int way = OPENCL_BLOCKS; way <= OPENCL_TILES; ++way) {
        static double here[3 * BODIES], there[3 * BODIES];
        struct opencl *device = open(true, (enum opencl_way)way);
        double worst = 0;
        UNIT_TRUE(device);
        if (!device)
            return;
        memset(here, 0, sizeof here);
        memset(there, 0, sizeof there);
        sum_here(here);
        opencl_add(device, x, there);
        opencl_close(&device);
        for (size_t i = 0; i < BODIES; ++i) {
            double off = 0, all = 0, r2 = 0;
            for (size_t k = 0; k < 3; ++k) {
                const size_t at = k * BODIES + i;
                const double d = x[at] - x[k * BODIES + 3];
                off += (there[at] - here[at]) * (there[at] - here[at]);
                all += here[at] * here[at];
                r2 += d * d;
            }
            if (i != 3)
                worst = fmax(worst, sqrt(off / all) /
                                        (0x3p-24 * sqrt(3 / r2) + 0x8p-24));
        }
        UNIT_TRUE(worst < 1);
        UNIT_TRUE(worst > 1e-3);
    }
}

static void test_none(void)
{
    UNIT_TRUE(strlen(message) > 20);
    UNIT_TRUE(!strchr(message, '\n'));
}

int main(void)
{
    make_bodies();
    struct opencl *device = open(false, OPENCL_AUTO);
    if (!device) {
        printf("# note: no sums by OpenCL are tested: %s\n", message);
        return unit_run_these(
            "opencl",
            (struct unit_test[]){
                {"what is missing is said in a line", test_none}, {0}});
    }
    opencl_close(&device);
    return unit_run_these(
        "opencl",
        (struct unit_test[]){{"the same bits either way", test_bits},
                             {"single precision", test_single},
                             {0}});
}
