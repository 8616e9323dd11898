# data: build/data/08-energy.dat
# command: build/bin/step-studies --study energy -o build/data/08-energy.dat
# lecture: build/bin/step-studies --study energy --orbits 20000 -o build/data/08-energy.dat
# alt: Largest error of the energy so far against the number of orbits, logarithmic, 400 evaluations of the forces an orbit. Euler is off by a fifth at once and by all of it in the end, RK4 rises in proportion to time. The symplectic methods reach a level within the first orbits and stay: midpoint at five per cent, symplectic Euler at two, Gauss 4 at two thousandths, leapfrog below a thousandth, Yoshida 4 at ten to the minus four, the others lower, Kahan and Li's lowest.
height = 8
load 'plots/style.gp'
load 'plots/methods.gp'
file = 'build/data/08-energy.dat'
eval powers
set xrange [0.1:lecture ? 22000 : 1100]
set yrange [1e-6:10]
set xlabel 'orbits'
set ylabel 'largest error of the energy so far' offset 0.5
eval edges(0.1, 0.755, 0.15, 0.97)
set key at screen 0.99,0.97 right top samplen 2 Left reverse
plot for [m in methods(file, known)] file index at(file, m) using 1:2 \
     with linespoints ls style_of(m) pi 8 title name_of(m)
