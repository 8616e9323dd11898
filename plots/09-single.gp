# data: build/data/09-single.dat
# command: build/bin/gravity-studies --study single -o build/data/09-single.dat
# alt: Relative error of the pull of a ring on its own particles, in single precision, against the number of particles from 192 to 49152, both axes logarithmic. With the planet's pull summed first it rises from 0.002 to 0.3, and the line of the model runs through its points. With the planet last, and with a compensated sum, it stays between 0.0001 and 0.0015.
height = 6.4
load 'plots/style.gp'
file = 'build/data/09-single.dat'
eval edges(0.11, 0.985, 0.19, 0.97)
set logscale xy
eval decades
set format '10^{%T}'
set xlabel 'particles of the ring'
set ylabel 'error of its own pull' offset -0.3
set xrange [130:70000]
set yrange [5e-5:5]
set key at graph 0.03,0.95 left top Left reverse samplen 2
plot file using 1:5 with lines ls 9 title 'model', \
     file using 1:2 with points ls 1 title 'planet first', \
     file using 1:3 with points ls 2 pt 4 ps 1.8 title 'planet last', \
     file using 1:4 with points ls 3 title 'compensated'
