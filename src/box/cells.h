/* The fast engine for disks: neighbour lists, cells and a calendar. */
#ifndef CELLS_H
#define CELLS_H

#include "box/calendar.h"
#include "box/disks.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Where the anchor of a disk is: the place that it had when its list of
   neighbours was made. */
struct cells_anchor {
    uint32_t cell;
    uint16_t spot;       /* which of the anchors in it */
    uint16_t neighbours; /* how many the disk has */
};

/* An engine for the disks of *d. Around each anchor lies a skin; a list
   holds all disks that a disk can meet while both are within theirs (7.14,
   eq:neighbours). To be read: skin and the counts; lanes may be made 4 or 1
   between runs. */
struct cells {
    struct disks *d;
    struct calendar calendar; /* one event for each disk */
    double skin;              /* how far from its anchor a disk may go, m */
    double inverse[DISKS_AXES]; /* 1/box if that is periodic, or 0, 1/m */
    size_t lanes;               /* neighbours examined at once: 8, 4 or 1 */
    /* The lists: as many seats for each disk, so that none needs a pointer.
       In the free ones it sits itself, which is harmless to ask, since no
       disk meets itself. */
    uint32_t *neighbour;
    size_t seats;
    struct cells_anchor *anchor;
    size_t grid[DISKS_AXES], cells, room;
    double widest, slack; /* largest radius; for rounded anchors, m */
    float *place;   /* of each cell: room times x, room times y, and z, m */
    uint32_t *who;  /* of each cell: room times whose anchor it is */
    uint16_t *full; /* of each cell: how many anchors are in it */
    uint64_t stale; /* events whose partner had met another disk */
    uint64_t renewed; /* lists made anew at the end of a skin */
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

/* Runs as disks_run does, to the same bits, with a number of operations
   for a collision that does not grow with that of the disks. Returns
   DISKS_COLLISIONS before there were so many if there is no memory for
   longer lists. */
enum disks_stop cells_run(struct cells *c, double until,
                          uint64_t collisions);

/* Returns how many neighbours this processor examines in one instruction:
   8, 4 or 1. */
size_t cells_lanes(void);

#endif
