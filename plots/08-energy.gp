# data: build/data/08-energy.dat
# command: build/bin/step-studies --study energy -o build/data/08-energy.dat
# lecture: build/bin/step-studies --study energy --orbits 20000 -o build/data/08-energy.dat
# alt: Largest error of the energy so far against the number of orbits, logarithmic, 400 evaluations of the forces an orbit. Euler is off by a fifth at once and by all of it in the end, RK4 rises in proportion to time. The symplectic methods reach a level within the first orbits and stay: midpoint at five per cent, symplectic Euler at two, Gauss 4 at two thousandths, leapfrog below a thousandth, Yoshida 4 at ten to the minus four, the others lower, Kahan and Li's lowest.
width = 14
height = 8
load 'plots/style.gp'
file = 'build/data/08-energy.dat'
set logscale xy
set format '10^{%T}'
set xrange [0.1:lecture ? 22000 : 1100]
set yrange [1e-6:10]
set xlabel 'orbits'
set ylabel 'largest error of the energy so far' offset 0.5
set lmargin at screen 0.1
set rmargin at screen 0.755
set bmargin at screen 0.15
set tmargin at screen 0.97
set key at screen 0.99,0.97 right top samplen 2 Left reverse
plot file index 0 using 1:2 with linespoints ls 2 pi 8 title 'Euler', \
     file index 1 using 1:2 with linespoints ls 3 pi 8 title 'symplectic Euler', \
     file index 2 using 1:2 with linespoints ls 1 pi 8 title 'leapfrog', \
     file index 8 using 1:2 with linespoints ls 1 pt 6 dt 2 pi 8 title 'midpoint', \
     file index 3 using 1:2 with linespoints ls 4 pi 8 title 'RK4', \
     file index 4 using 1:2 with linespoints ls 5 pi 8 title 'Yoshida 4', \
     file index 5 using 1:2 with linespoints ls 5 pt 12 dt 2 pi 8 title 'Yoshida 6', \
     file index 6 using 1:2 with linespoints ls 3 pt 8 dt 2 pi 8 title 'PEFRL', \
     file index 7 using 1:2 with linespoints ls 2 pt 4 dt 2 pi 8 title 'Kahan–Li 8', \
     file index 9 using 1:2 with linespoints ls 4 pt 10 dt 2 pi 8 title 'Gauss 4'
