/* Scenes of hard bodies, and how event-driven engines start from them. */
#ifndef HARD_H
#define HARD_H

#include "box/disks.h"
#include "scenes/gallery.h"
#include "line/start.h"

/* The scenes are hard_scenes in gallery.h: cradle, break, gas, brownian,
   four-disks, thermal, piston and galperin. */

/* Make of a scene what the engines of parts I and II start from. Both
   return false, with nothing to free, when there is no memory.
   hard_disks: the disks of a scene in a box of hard walls, or of periodic
   ones, along x and y, and along z if anything happens there; the corner of
   the box goes to the origin.
   hard_start: bodies that are free along x only, in order from left to
   right; walls at infinity where the scene has none. */
bool hard_disks(struct disks *d, const struct scene *s);
bool hard_start(struct start *start, const struct scene *s);

#endif
