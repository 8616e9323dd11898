/* Scenes of hard bodies, and starts of event-driven engines from them. */
#ifndef HARD_H
#define HARD_H

#include "box/disks.h"
#include "scenes/gallery.h"
#include "line/start.h"

/* The scenes are hard_scenes in gallery.h: cradle, break, gas, brownian,
   four-disks, thermal, piston and galperin. */

/* Converts a scene into disks, or spheres if it is not plane, for the
   engine of chapter 5. The box must have hard walls or be periodic along
   all of their axes; its corner becomes the origin. Returns false, with
   nothing to free, if memory runs out. */
bool hard_disks(struct disks *d, const struct scene *s);

/* Converts a scene whose bodies are free along x only, in order from left
   to right, into a start on a line. Walls that the scene lacks are put at
   infinity. Returns false, with nothing to free, if memory runs out. */
bool hard_start(struct start *start, const struct scene *s);

#endif
