# data: plots/data/10-work.dat
# alt: Error after ten seconds against processor time, with logarithmic axes, from ten microseconds to a second. The leapfrog is the cheapest down to errors of ten to the minus four, PEFRL from there to a few times ten to the minus nine, Kahan and Li's eighth order method beyond. The implicit methods lie a factor of eight and more to the right.
width = 14
height = 8
load 'plots/style.gp'
set lmargin at screen 0.1
set rmargin at screen 0.735
set bmargin at screen 0.14
set tmargin at screen 0.97
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set xlabel 'processor time  (s)'
set ylabel 'error after 10 s  (m)' offset 1
set xrange [1e-5:2]
set yrange [1e-13:3]
set key at screen 0.985,0.97 right top samplen 1.5
file = 'plots/data/10-work.dat'
plot file index 0 using 5:3 with linespoints lc rgb grey pt 1 ps 0.6*big title 'Euler', \
     file index 1 using 5:3 with linespoints lc rgb dark pt 2 ps 0.6*big title 'symplectic Euler', \
     file index 2 using 5:3 with linespoints ls 1 title 'leapfrog', \
     file index 8 using 5:3 with linespoints ls 5 title 'implicit midpoint', \
     file index 3 using 5:3 with linespoints ls 2 title 'RK4', \
     file index 4 using 5:3 with linespoints ls 3 title 'Yoshida 4', \
     file index 6 using 5:3 with linespoints lc rgb orange pt 4 ps 0.6*big title 'PEFRL', \
     file index 9 using 5:3 with linespoints lc rgb orange pt 12 ps 0.6*big dt 2 title 'Gauss 4', \
     file index 5 using 5:3 with linespoints ls 4 title 'Yoshida 6', \
     file index 7 using 5:3 with linespoints lc rgb grey pt 6 ps 0.6*big title 'Kahan–Li 8'
