/* Project P1. Bonkers, upright (after David MacKay; two to four hours)

   A program of your own, from its first line to its last: beads on a wire
   between two stops, flat and upright. Section "A program of your own" of
   chapter 4 has the contract and the seven stages.

     P1 BEADS LENGTH G TC ROWS

   Build it:    cc -std=c11 -Wall -Isrc/examiner exercises/P1-bonkers.c \
                    -o build/P1 -lm
   Run it:      build/P1 beads.txt 1 0 0.1 20
   Check it:    make check EX=P1
   Hints:       make hint EX=P1
   Draw it:     cd build && gnuplot ../exercises/P1.gp */

#include "collide.h"

int main(void)
{
    return 0;
}
