/* From chapters/works/07-gas.nw: edit there, then run make tangle. */
/* checksum 711435881 of the lines below */
/* The fast way to run disks: neighbours in cells, events in a calendar. */
#ifndef CELLS_H
#define CELLS_H

#include "box/calendar.h"
#include "box/disks.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Where the anchor of a disk is: the place it had when its neighbours were
   last looked up. */
struct cells_anchor {
    uint32_t cell;
    uint16_t spot;       /* which of the anchors in it */
    uint16_t neighbours; /* how many the disk has */
};

/* The fast way to run disks. To be read: leash and the counts; lanes may
   be made 4 or 1 between runs. */
struct cells {
    struct disks *d;
    struct calendar calendar;   /* one event for each disk */
    double leash;               /* a disk stays this near its anchor, m */
    double inverse[DISKS_AXES]; /* 1/box if that is periodic, or 0, 1/m */
    size_t lanes;               /* neighbours asked together: 8, 4 or 1 */
    uint32_t *neighbour; /* `seats` for each disk; free ones: itself */
    size_t seats;
    struct cells_anchor *anchor;
    size_t grid[DISKS_AXES], cells, room;
    double widest, slack; /* the largest radius; of rounded anchors, m */
    float *place;   /* of each cell: room times x, room times y, and z, m */
    uint32_t *who;  /* of each cell: room times whose anchor it is */
    uint16_t *full; /* how many anchors are in it */
    uint64_t stale; /* events whose partner had met another disk */
    uint64_t renewed; /* ends of a leash */
};

/* Says whether the box suits cells: at least three along each axis, if it
   is periodic, and the longest side between 1e-12 and 1e15 m. */
bool cells_suit(const struct disks *d);

/* Plans from the present state of d, which has to outlive c; it may be
   read between runs, but not changed. Returns false, with nothing to
   free, when there is no memory. Requires cells_suit. */
bool cells_create(struct cells *c, struct disks *d);
void cells_free(struct cells *c);

/* As disks_fit, but looks at neighbours only. Before the first run. */
bool cells_fit(const struct cells *c, size_t *a, size_t *b);

/* Runs as disks_run does, to the same bits, with as many operations for
   a collision however many disks there are. DISKS_COLLISIONS before there
   were so many: there is no memory for longer lists. */
enum disks_stop cells_run(struct cells *c, double until,
                          uint64_t collisions);

/* Returns how many neighbours this machine can ask together: 8, 4 or 1. */
size_t cells_lanes(void);

#endif
