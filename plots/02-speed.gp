# data: plots/data/02-speed.dat
# alt: Collisions per second against the number of particles from 4 to a million, both axes logarithmic, for four engines. At four particles all are alike within a factor of two. The naive engine and the scan fall in proportion to one over N, the naive one below the scan and in the end faster; the heap falls slowly, by a factor of some ten in all; the slab engine is level.
height = 8.4
load 'plots/style.gp'
file = 'plots/data/02-speed.dat'
# The scan, from a thousand particles on; the line is a little above it.
stats file using ($1 >= 1000 ? log($1*$3) : NaN) nooutput
scan = exp(STATS_mean)
eval powers
set xlabel 'particles {/:Italic N}'
set ylabel 'collisions per second' offset 0.5
set xrange [3:1.6e6]
set yrange [50:1e8]
eval edges(0.12, 0.98, 0.145, 0.97)
set key at graph 0.03,0.05 left bottom reverse Left samplen 2 spacing 1.1
set label 1 '∝ 1/{/:Italic N}' at 2e4,1.6e5 tc rgb '#555555'
plot 1.3*scan/x ls 9, \
     file using 1:5 with linespoints ls 1 title 'slab', \
     file using 1:4 with linespoints ls 3 title 'heap', \
     file using 1:3 with linespoints ls 2 title 'scan', \
     file using 1:2 with linespoints ls 5 title 'naive'
