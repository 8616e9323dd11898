/* Scenes of hard bodies, and their conversion for event-driven engines. */
#ifndef HARD_H
#define HARD_H

#include "box/disks.h"
#include "scenes/gallery.h"
#include "line/start.h"

/* The scenes are hard_scenes in gallery.h: cradle, break, gas, brownian,
   four-disks, thermal, piston and galperin. */

/* Converts a scene into disks for the engine of chapter 5, or into spheres
   if the scene is not planar. The box must have hard walls along both or
   all three axes, or be periodic along all of them. The lower corner of
   the box becomes the origin. Returns false, with nothing to free, if
   memory runs out. */
bool hard_disks(struct disks *d, const struct scene *s);

/* Converts a scene into a start on a line. The bodies must be free along x
   only and numbered from left to right. Missing walls are put at infinity.
   Returns false, with nothing to free, if memory runs out. */
bool hard_start(struct start *start, const struct scene *s);

#endif
