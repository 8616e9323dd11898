/* Exercise 05e. A check that finds the clock (core, 35 minutes)

   A program moves a disk in a box and records it at each tick of a clock.
   Its energy is right, and its film looks well. Is its clock right? You
   cannot read the program, you can only let it run.

   Given:
     width    how far the centre of the disk can go: its x from 0 to width,
     height   its y from 0 to height, in m; there is nothing else in the
              box, which may be a molecule's, 1e-9 m, or a planet's, 1e9 m
     run      run(start, tick, samples, kept) lets the disk start where you
              say, inside, in m and m/s, and fills in kept[0], where it is
              after one tick, kept[1] after two, ..., kept[samples - 1]
   Returns true if the program is right, as far as you can find out, and
   false if it is not. A right one rounds, at each bounce and each tick: it
   is within 1e-10 of the way that the disk has covered, for up to 1000
   ticks and bounces. A wrong one is off by more than 1e-5 of the box
   sooner or later. None of them ever changes a speed.

   You earn points for each wrong program that you refuse, and none if you
   refuse a right one.

   Check your answer with    make check EX=05e
   Hints, which ask before they tell:    make hint EX=05e */

#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

struct state {
    double x, y, vx, vy;
};

bool clock_is_right(double width, double height,
                    void (*run)(struct state start, double tick,
                                size_t samples, struct state kept[]))
{
    /* TODO: replace these lines by your own. Of which run do you know
       beforehand where the disk must be at each tick? */
    const struct state start = {width / 2, height / 2, 1.0, 0.5};
    struct state kept[1];
    run(start, 0.01, 1, kept);
    return NOT_DONE_YET(true);
}
