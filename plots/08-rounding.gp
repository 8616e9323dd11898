# data: build/data/08-rounding.dat
# command: build/bin/step-studies --study rounding -o build/data/08-rounding.dat
# lecture: build/bin/step-studies --study rounding --orbits 16384 -o build/data/08-rounding.dat
# alt: Error of the energy against the number of orbits for Kahan and Li's method, logarithmic. At 100 steps an orbit it is flat at 3e-11, with compensation or without. At 400 steps it grows without compensation as the root of the number of orbits, from ten to the minus 14 to 2e-13; with it, it starts below ten to the minus 15 and in the end is a hundred times smaller.
load 'plots/style.gp'
file = 'build/data/08-rounding.dat'
# From the first point of 400 plain steps on.
stats file index 2 using ($2/sqrt($1)) every ::0::0 nooutput
first = STATS_min
eval powers
set xrange [0.8:lecture ? 20000 : 700]
set yrange [1e-16:1e-7]
set ytics 100
set xlabel 'orbits'
set ylabel 'error of the energy' offset 0.5
eval edges(0.11, 0.985, 0.17, 0.97)
set key at graph 0.02,0.97 left top reverse Left samplen 2
plot first*sqrt(x) ls 9, \
     file index 0 using 1:2 with linespoints ls 5 title '100 steps an orbit, plain', \
     file index 1 using 1:2 with linespoints ls 5 pt 12 dt 2 title '100 steps, carried', \
     file index 2 using 1:2 with linespoints ls 2 title '400 steps, plain', \
     file index 3 using 1:2 with linespoints ls 1 title '400 steps, carried'
