/* Exercise 04a. Springs of air (core, 30 minutes)

   A piston stands in a long box, with gas on its left and on its right. The
   gas of the chapter lives on a line. Let these particles move in f
   directions, among which collisions share out the energy. So one part in f
   of the kinetic energy K is along the box, and a gas in a piece of length
   l presses on the piston with the force 2 K / (f l). What it gives to a
   slow piston, force times way, is taken from K. Write the right-hand side
   of the equations of motion, for any solver to step on.

   Given:
     f          the number of directions, at least 1
     length     of the box, in m: from 0 to length
     mass       of the piston, in kg
     gas        mass of the gas of both sides together, in kg, of which a
                third moves as if it were part of the piston; 0 leaves the
                gas out
     energy[2]  kinetic energy of the left gas, energy[0], and of the right
                gas, energy[1], WHEN THE PISTON IS IN THE MIDDLE of the box,
                in J
     state[2]   where the piston is now, state[0], between 0 and length, in
                m, and its velocity, state[1], in m/s, positive to the right
   To fill in:
     slope[2]   how fast state[0] and state[1] change

   Check your answer with    make check EX=04a
   Hints, which ask before they tell:    make hint EX=04a */

#include "exercise.h"
#include <math.h>

void piston_slopes(int f, double length, double mass, double gas,
                   const double energy[2], const double state[2],
                   double slope[2])
{
    /* TODO: replace these lines by your own. How long are the two parts
       now, how much energy has each gas by now, and which way does each
       push? */
    (void)f;
    (void)length;
    (void)mass;
    (void)gas;
    (void)energy;
    slope[0] = NOT_DONE_YET(state[1]);
    slope[1] = 0.0;
}
