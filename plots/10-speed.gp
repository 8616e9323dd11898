# data: plots/data/10-speed.dat
# alt: Steps of a body per second against the side of the grid, 8 to 512 on a logarithmic axis. Spring by spring is lowest and falls slowly. By bands, in sweeps or in two trips, it is about three times as high up to 256; at 512 all have fallen, two trips more than sweeps. Computing every spring twice lies between.
width = 11
load 'plots/style.gp'
eval edges(0.14, 0.985, 0.16, 0.97)
set logscale x 2
set xlabel 'bodies on a side'
set ylabel 'steps of a body per second  (millions)' offset 0.5
set xrange [6.5:630]
set yrange [0:460]
set key at graph 0.98,0.97 right top samplen 1.5
file = 'plots/data/10-speed.dat'
plot file using 1:($3/1e6) with linespoints ls 1 title 'bands, in sweeps', \
     file using 1:($4/1e6) with linespoints ls 4 title 'bands, two trips', \
     file using 1:($5/1e6) with linespoints ls 3 title 'every spring twice', \
     file using 1:($2/1e6) with linespoints ls 2 title 'spring by spring'
