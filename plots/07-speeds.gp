# data: build/data/07-speeds-250.dat
# command: build/bin/gas0 250 10001 > build/data/07-speeds-250.dat
# lecture: build/bin/gas0 250 40001 > build/data/07-speeds-250.dat
# data: build/data/07-speeds-10.dat
# command: build/bin/gas0 10 50001 1.5 1 > build/data/07-speeds-10.dat
# alt: Left, the density of the speed rises from zero to a top at 0.7 and falls to nothing at 3; points on a line. Right, the deviation from Maxwell's law in per cent: for ten disks from minus 10 at rest to plus 12 in the middle and far below at high speeds, for 250 within half a per cent up to speed 2 and then falling; points on lines.
height = 6.8
load 'plots/style.gp'
few = 'build/data/07-speeds-10.dat'
many = 'build/data/07-speeds-250.dat'
half = 1./21 # half a bin
set multiplot layout 1,2 margins 0.075,0.985,0.18,0.97 spacing 0.125,0
set xlabel 'speed {/:Italic u}'
set ylabel 'density' offset 1.5
set xrange [0:3.2]
set yrange [0:0.95]
set ytics 0.2
p(u,N) = u**2 < N ? 2*u*(N-1.)/N*(1-u**2/N)**(N-2) : NaN
plot p(x,250) ls 9 lw 1.6*thick, many using ($1+half):2 with points ls 1
set ylabel 'per cent above Maxwell' offset 0.5
set xrange [0:2.9]
set yrange [-20:15]
set ytics 5
set key at graph 0.03,0.05 left bottom Left reverse samplen 1
plot few using ($1+half):(100*($4/$5-1)) with lines ls 9 lw 1.4*thick, \
     many using ($1+half):(100*($4/$5-1)) with lines ls 9 lw 1.4*thick, \
     few using ($1+half):(100*($2/$5-1)):(100*$3/$5) with yerrorbars ls 2 title '10 disks', \
     many using ($1+half):(100*($2/$5-1)):(100*$3/$5) with yerrorbars ls 1 title '250 disks'
