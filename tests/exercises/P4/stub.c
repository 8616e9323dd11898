/* Project P4. Enough (three to four hours)

   A program of your own: given bodies, a time and a tolerance, it finds
   which of three methods gets there with the fewest forces. Section "Enough
   of your own" of chapter 12 has the contract and the eight stages. Write
   down your own picks first.

     P4 BODIES T TOL

   Build it:    cc -std=c11 -Wall -Isrc/examiner exercises/P4-enough.c \
                    -o build/P4 -lm
   Run it:      build/P4 bodies.txt 6 1e-3
   Check it:    make check EX=P4
   Hints:       make hint EX=P4
   Draw it:     cd build && gnuplot ../exercises/P4.gp */

#include "force.h"

int main(void)
{
    return 0;
}
