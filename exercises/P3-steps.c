/* Project P3. Steps (about four hours)

   A program of your own, from its first line to its last: bodies that
   attract each other, and springs between them, in steps of DT; and it says
   how wrong it is. Section "Steps of your own" of chapter 11 has the
   contract and the seven stages.

     P3 BODIES G METHOD DT EVERY ROWS

   Build it:    cc -std=c11 -Wall exercises/P3-steps.c -o build/P3 -lm
   Run it:      build/P3 bodies.txt 1 leapfrog 0.01 10 20
   Check it:    make check EX=P3
   Hints:       make hint EX=P3
   Draw it:     cd build && gnuplot ../exercises/P3.gp */

int main(void)
{
    return 0;
}
