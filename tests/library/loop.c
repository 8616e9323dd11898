/* The loop of ticks and events, against places and times by hand. */
#include "unit.h"

#include "box/loop.h"

/* Two disks that fly at each other, 1 m/s each, and meet 4 s later; walls
   are 1 s and 2 s behind them. */
static void begin(struct loop *l, double offset)
{
    *l = (struct loop){.offset = offset};
    UNIT_MUST(disks_create(&l->d, 2, 2));
    PUT(l->d.box, 15, 6);
    for (size_t i = 0; i < 2; ++i) {
        l->d.disk[i].radius = 1;
        PUT(l->d.disk[i].position, i ? 12 : 2, 3);
        l->d.disk[i].velocity[0] = i ? -1 : 1;
    }
    l->next = disks_next(&l->d);
}

static void loop_free(struct loop *l)
{
    disks_free(&l->d);
}

/* Ticks of 3/4 s: five of them lead to 3.75 s; the sixth goes to the event,
   where the clock stops. With an offset of 1 that is where the disks touch;
   with the -1 of the article both are two ticks before it. */
TEST(test_turns, "ticks, and an offset at an event")
{
    for (int offset = -1; offset <= 1; offset += 2) {
        MADE(loop, l, begin(&l, offset));
        UNIT_EQUAL(l.next.time, 4);
        for (int k = 1; k <= 5; ++k) {
            loop_turn(&l, 0.75);
            UNIT_EQUAL(l.t, 0.75 * k);
            UNIT_EQUAL(l.d.now, 0.75 * k);
            UNIT_EQUAL(l.d.disk[0].since, 0.75 * k);
            UNIT_EQUAL(l.d.disk[0].position[0], 2 + 0.75 * k);
            UNIT_EQUAL(l.d.disk[1].position[0], 12 - 0.75 * k);
            UNIT_EQUAL(l.d.collisions, 0);
        }
        loop_turn(&l, 0.75);
        const double far = 0.75 * (offset - 1);
        UNIT_EQUAL(l.t, 4);
        UNIT_EQUAL(l.d.collisions, 1);
        UNIT_EQUAL(l.d.disk[0].position[0], 6 + far);
        UNIT_EQUAL(l.d.disk[1].position[0], 8 - far);
        UNIT_EQUAL(l.d.disk[0].position[1], 3);
        UNIT_EQUAL(l.d.disk[0].velocity[0], -1);
        UNIT_EQUAL(loop_overlap(&l), 0);
        UNIT_EQUAL(l.next.time, 4 + 5 + far);
    }
    /* An event at the tick itself is one. */
    MADE(loop, l, begin(&l, 1));
    loop_turn(&l, 4);
    UNIT_EQUAL(l.d.collisions, 1);
    UNIT_EQUAL(l.d.disk[0].position[0], 6);
}

TEST(test_go_to, "events up to a tick")
{
    MADE(loop, l, begin(&l, 1));
    loop_go_to(&l, 3.5);
    UNIT_EQUAL(l.t, 3.5);
    UNIT_EQUAL(l.d.now, 3.5);
    UNIT_EQUAL(l.d.collisions, 0);
    UNIT_EQUAL(l.d.disk[0].position[0], 2);
    loop_go_to(&l, 4);
    UNIT_EQUAL(l.d.collisions, 1);
    UNIT_EQUAL(l.next.time, 9);
    loop_go_to(&l, 12);
    UNIT_EQUAL(l.d.wall_collisions, 2);
    UNIT_EQUAL(l.d.now, 12);
}

/* How deep two disks are in each other, or one in a wall, whichever is
   deeper. */
TEST(test_overlap, "overlaps by hand")
{
    static const struct {
        double x[2], y[2], deepest;
    } states[] = {{{5, 9}, {3, 3}, 0},        {{5, 6.5}, {3, 3}, 0.5},
                  {{5, 5.75}, {2, 3}, 0.75},  {{0.75, 9}, {3, 3}, 0.25},
                  {{9, 14.5}, {3, 3}, 0.5},   {{5, 9}, {0.875, 3}, 0.125},
                  {{5, 9}, {3, 5.25}, 0.25},  {{0.5, 2}, {3, 3}, 0.5},
                  {{0.75, 2.25}, {3, 3}, 0.5}};
    for (size_t n = 0; n < sizeof states / sizeof states[0]; ++n) {
        MADE(loop, l, begin(&l, 1));
        for (size_t i = 0; i < 2; ++i) {
            PUT(l.d.disk[i].position, states[n].x[i], states[n].y[i]);
        }
        UNIT_EQUAL(loop_overlap(&l), states[n].deepest);
    }
}
