# data: plots/data/08-cost.dat
# alt: Error after ten orbits against processor time, both logarithmic, from ten microseconds to thirty milliseconds. The order of the methods is that of the evaluations: rk8pd and Kahan and Li's method are the cheapest below an error of a thousandth, leapfrog and symplectic Euler cost a thousandth of a second for a hundredth, Euler never arrives.
width = 14
height = 8
load 'plots/style.gp'
file = 'plots/data/08-cost.dat'
set logscale xy
set format '10^{%T}'
set xrange [1e-5:5e-2]
set yrange [1e-14:10]
set ytics 100
set xlabel 'processor time of ten orbits  (s)'
set ylabel 'error at the end' offset 0.5
set lmargin at screen 0.1
set rmargin at screen 0.755
set bmargin at screen 0.15
set tmargin at screen 0.97
set key at screen 0.99,0.97 right top samplen 2 Left reverse
plot file index 0 using 3:4 with linespoints ls 2 ps 0.4*big title 'Euler', \
     file index 1 using 3:4 with linespoints ls 3 ps 0.5*big title 'symplectic Euler', \
     file index 2 using 3:4 with linespoints ls 1 ps 0.4*big title 'leapfrog', \
     file index 8 using 3:4 with linespoints ls 1 pt 6 dt 2 ps 0.4*big title 'midpoint', \
     file index 3 using 3:4 with linespoints ls 4 ps 0.5*big title 'RK4', \
     file index 4 using 3:4 with linespoints ls 5 ps 0.6*big title 'Yoshida 4', \
     file index 5 using 3:4 with linespoints ls 5 pt 12 dt 2 ps 0.6*big title 'Yoshida 6', \
     file index 6 using 3:4 with linespoints ls 3 pt 8 dt 2 ps 0.5*big title 'PEFRL', \
     file index 7 using 3:4 with linespoints ls 2 pt 4 dt 2 ps 0.4*big title 'Kahan–Li 8', \
     file index 9 using 3:4 with linespoints ls 4 pt 10 dt 2 ps 0.5*big title 'Gauss 4', \
     file index 10 using 3:4 with linespoints ls 9 pt 1 ps 0.5*big title 'rk8pd (GSL)'
