/* Project P2. Disks (four to five hours)

   A program of your own: four disks that fly, four that are thrown, and two
   big ones among many small. Section "Disks of your own" of chapter 7 has
   the contract and the seven stages.

     P2 fly DISKS RADIUS TC ROWS
     P2 watch DISKS RADIUS TC ROWS
     P2 throw N RADIUS SEED SAMPLES
     P2 pair N RADIUS SMALL SEED SAMPLES

   Build it:    cc -std=c11 -Wall exercises/P2-disks.c -o build/P2 -lm
   Run it:      build/P2 throw 4 0.15 1 10000
   Check it:    make check EX=P2
   Hints:       make hint EX=P2
   Draw it:     cd build && gnuplot ../exercises/P2.gp */

int main(void)
{
    return 0;
}
