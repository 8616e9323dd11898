# data: build/data/05-positions.dat
# command: build/bin/disks --disks 4 --radius 0.15 --box 1,1 --every 0.01 --samples 1000000 --measure positions -o build/data/05-positions.dat
# lecture: build/bin/disks --disks 4 --radius 0.15 --box 1,1 --every 0.01 --samples 10000000 --measure positions -o build/data/05-positions.dat
# data: plots/data/disks4_r0.15_unitbox.dat
# alt: Two panels, the density of x and of y from 0 to 1 metre. Zero up to 0.15, then 2.6, falling to 1.0 at 0.42, with a small hump of 1.1 in the middle, and the mirror image to 0.85. The points lie on the reference line.
height = 6.5
load 'plots/style.gp'
file = 'build/data/05-positions.dat'
truth = 'plots/data/disks4_r0.15_unitbox.dat'
set multiplot layout 1,2 margins 0.085,0.985,0.17,0.97 spacing 0.06,0
set xrange [0:1]
set yrange [0:2.9]
set xtics 0.2
set ylabel 'density  (1/m)' offset 1
do for [k=0:1] {
    set xlabel '{/:Italic '.(k == 0 ? 'x' : 'y').'}  (m)'
    plot file using ($1 > 0.1499 && $1 < 0.8499 ? $1 + 0.005 : NaN):(column(2+2*k)):(column(3+2*k)) with yerrorbars ls (k+1) ps 0.4*big lw 0.8*thick, \
         truth using (($1+$2)/2):3 with lines lc rgb dark lw 0.8*thick
    unset ylabel
}
