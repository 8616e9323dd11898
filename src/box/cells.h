/* Runs disks fast, with neighbour lists, cells and a calendar. */
#ifndef CELLS_H
#define CELLS_H

#include "box/calendar.h"
#include "box/disks.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The anchor of a disk: the position of the disk when its neighbour list
   was made, stored in the cell that contains it. */
struct cells_anchor {
    uint32_t cell;
    uint16_t spot;       /* index of the anchor in its cell */
    uint16_t neighbours; /* number of neighbours */
};

/* An engine for the disks of *d. Each anchor is surrounded by a skin. The
   list of a disk contains all disks that it can meet while both stay within
   their skins (7.14, eq:neighbours). `skin` and the counts may be read.
   `lanes` may be reduced to 4 or 1 between runs. */
struct cells {
    struct disks *d;
    struct calendar calendar; /* one event for each disk */
    double skin;              /* largest distance of a disk from its anchor,
                                 m */
    double inverse[DISKS_AXES]; /* 1/box, 1/m, or 0 if not periodic */
    size_t lanes;               /* neighbours examined at once: 8, 4 or 1 */
    /* The neighbour lists have `seats` entries for each disk, so no disk
       needs a pointer. Unused entries contain the disk itself, which is
       harmless, since no disk meets itself. */
    uint32_t *neighbour;
    size_t seats;
    struct cells_anchor *anchor;
    size_t grid[DISKS_AXES], cells, room;
    double widest, slack; /* largest radius; allowance for rounding to
                             floats, m */
    float *place;     /* all x, all y, all z of each cell, `room` of each,
                         m */
    uint32_t *who;    /* disks of the `room` anchors of each cell */
    uint16_t *full;   /* number of anchors in each cell */
    uint64_t stale;   /* events dropped because the partner had collided */
    uint64_t renewed; /* lists renewed at the end of a skin */
};

/* Returns whether the box suits cells: a periodic axis must be wide enough
   for three cells, and the longest side must be between 1e-12 and 1e15
   m. */
bool cells_suit(const struct disks *d);

/* Plans the first event of every disk of *d. *d must outlive *c, and may be
   read but not changed between runs. Returns false, with nothing to free,
   if memory runs out. Requires cells_suit. */
bool cells_create(struct cells *c, struct disks *d);
void cells_free(struct cells *c);

/* Returns the same as disks_fit, but examines only neighbours. Must be
   called before the first run. */
bool cells_fit(const struct cells *c, size_t *a, size_t *b);

/* Runs like disks_run, with results equal to the last bit. The time per
   collision does not grow with the number of disks. If memory runs out,
   returns DISKS_COLLISIONS before the number of collisions is reached. */
enum disks_stop cells_run(struct cells *c, double until,
                          uint64_t collisions);

/* Returns the number of neighbours that vector code of this processor
   examines at once: 8, 4 or 1. */
size_t cells_lanes(void);

#endif
