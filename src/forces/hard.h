/* Scenes of hard bodies, and starts of event-driven engines from them. */
#ifndef HARD_H
#define HARD_H

#include "box/disks.h"
#include "scenes/gallery.h"
#include "line/start.h"

/* The scenes are hard_scenes in gallery.h: cradle, break, gas, brownian,
   four-disks, thermal, piston and galperin. */

/* Make from a scene the start of an engine of part I or II. Both return
   false, with nothing to free, if memory runs out. hard_disks: the disks of
   a scene in a box of hard walls, or a periodic one, along x and y, and
   along z if the scene is not plane; the corner of the box becomes the
   origin. hard_start: bodies that are free along x only, in order from left
   to right; walls at infinity if the scene has none. */
bool hard_disks(struct disks *d, const struct scene *s);
bool hard_start(struct start *start, const struct scene *s);

#endif
