/* The bites in which the program bonkers runs: where each ends. The program
   is compiled in here, and its calls of the engine pass through note_run.
 */
#include "unit.h"

#include "line/bonkers.h"

#include <unistd.h>

enum { MOST = 64 };

/* What the calls asked for and came to, of one program. */
static struct bite {
    double pause, now;
    uint64_t before, limit, collisions;
    enum bonkers_stop stop;
} bite[MOST];
static size_t bites;

static enum bonkers_stop note_run(struct bonkers *b, double until,
                                  uint64_t limit)
{
    struct bite *e = &bite[bites < MOST ? bites : MOST - 1];
    e->pause = until;
    e->before = b->collisions;
    e->limit = limit;
    e->stop = bonkers_run(b, until, limit);
    e->now = b->now;
    e->collisions = b->collisions;
    ++bites;
    return e->stop;
}

#define main bonkers_main
#define bonkers_run note_run
#include "programs/bonkers.c"
#undef main
#undef bonkers_run

/* Runs the program, whose settings begin as they do in a new process; its
   words are separated by blanks. */
static void run_program(const char *words)
{
    static char text[256], fresh[sizeof given];
    static bool kept;
    if (!kept)
        memcpy(fresh, &given, sizeof given);
    memcpy(&given, fresh, sizeof given);
    kept = true;
    char *argument[32];
    int count = 0;
    snprintf(text, sizeof text, "bonkers -o /dev/null %s", words);
    for (char *w = strtok(text, " "); w && count < 31;
         w = strtok(NULL, " "))
        argument[count++] = w;
    argument[count] = NULL;
    bites = 0;
    optind = 1;
    UNIT_EQUAL(bonkers_main(count, argument), 0);
    UNIT_TRUE(bites > 0 && bites <= MOST);
}

/* The first bite of slabs ends at a collision, and tells how long the
   others are to be: they end at a time. They have about as many collisions,
   as the gas has been at equilibrium from the start, so that a thousand
   bodies fluctuate by a few in a hundred: far less than the quarter. */
TEST(test_pace, "slabs end at a time, paced by what went before")
{
    run_program("--preset random -N 1000 -c 6000000");
    const double size = (double)bite[0].collisions;
    UNIT_TRUE(bites > 5);
    UNIT_TRUE(bite[0].stop == BONKERS_COLLISIONS);
    for (size_t k = 1; k + 1 < bites; ++k) {
        UNIT_TRUE(bite[k].stop == BONKERS_TIME);
        UNIT_EQUAL(bite[k].now, bite[k].pause);
        UNIT_NEAR(bite[k].collisions - bite[k].before, size, size / 4);
        UNIT_TRUE(bite[k].limit > bite[k].before + (uint64_t)size);
    }
    UNIT_TRUE(bite[bites - 1].stop == BONKERS_COLLISIONS);
    UNIT_EQUAL(bite[bites - 1].collisions, 6000000);
}

TEST(test_rows, "but not beyond a row or the end")
{
    run_program("--preset random -N 1000 --every 9000 --until 22500");
    double row = 9000;
    for (size_t k = 0; k < bites; ++k) {
        UNIT_TRUE(bite[k].pause <= row);
        if (bite[k].now == row)
            row = row < 18000 ? 18000 : 22500;
    }
    UNIT_TRUE(bites > 4);
    UNIT_TRUE(bite[bites - 1].stop == BONKERS_TIME);
    UNIT_EQUAL(bite[bites - 1].now, 22500);
}

/* All has happened in three bites; one without a collision is the last that
   ends at a time. */
TEST(test_nobody_meets, "nor for ever when nobody meets any more")
{
    run_program("--preset galperin --engine slab --mass-ratio 1e12");
    UNIT_TRUE(bites <= 6);
    UNIT_TRUE(bite[bites - 1].stop == BONKERS_STILL);
    UNIT_EQUAL(bite[bites - 1].collisions, 3141592);
}

/* An engine with an order counts collisions: its bites end there. */
TEST(test_others, "the heap's end at a collision")
{
    run_program("--preset random -N 1000 --engine heap -c 3000000");
    for (size_t k = 0; k < bites; ++k)
        UNIT_TRUE(bite[k].stop == BONKERS_COLLISIONS &&
                  bite[k].pause == INFINITY);
}
