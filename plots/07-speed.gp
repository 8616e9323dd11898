# data: plots/data/07-speed.dat
# alt: Processor time of a collision against the number of disks, both axes logarithmic, from a hundred to a million. With pairs it rises in proportion to N, from one microsecond to nearly a tenth of a millisecond at ten thousand disks. With cells it stays under one microsecond up to ten thousand, for disks and spheres at two packings each, and grows to some microseconds at a million, where the memory is the brake.
height = 8.4
load 'plots/style.gp'
file = 'plots/data/07-speed.dat'
# Pairs, disks at packing 0.30.
stats file index 0 using (log($1*$2)) nooutput
pair = exp(-STATS_mean)
set logscale xy
set format x '10^{%T}'
set xlabel '{/:Italic N}'
set ylabel 'time of a collision  (µs)' offset 1
set xrange [60:1.6e6]
set yrange [0.2:1500]
eval edges(0.11, 0.98, 0.145, 0.97)
set key at graph 0.98,0.96 right top reverse Left samplen 2 spacing 1.1
set label 1 'pairs' at 4e3,75 right tc rgb '#555555'
set label 2 '∝ {/:Italic N}' at 6e4,300 left tc rgb '#555555'
plot 1e6*pair*x ls 9, \
     file index 0 using 1:(1e6/$2) with points pt 4 ps 0.7*big lc rgb grey, \
     file index 1 using 1:(1e6/$2) with points pt 4 ps 0.7*big lc rgb grey, \
     file index 2 using 1:(1e6/$2) with points pt 6 ps 0.7*big lc rgb grey, \
     file index 3 using 1:(1e6/$2) with points pt 6 ps 0.7*big lc rgb grey, \
     file index 0 using 1:(1e6/$3) with linespoints ls 1 title 'disks, 0.30', \
     file index 1 using 1:(1e6/$3) with linespoints ls 2 title 'disks, 0.70', \
     file index 2 using 1:(1e6/$3) with linespoints ls 3 title 'spheres, 0.30', \
     file index 3 using 1:(1e6/$3) with linespoints ls 4 title 'spheres, 0.49'
