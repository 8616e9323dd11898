# data: build/data/09-work.dat
# command: build/bin/gravity-studies --study work -o build/data/09-work.dat
# lecture: build/bin/gravity-studies --study work --orbits 1000 -o build/data/09-work.dat
# alt: Two panels with logarithmic axes: error against evaluations of the forces in a period of the stars. Left, largest error of the energy; right, error of the planet's place after 400 days. Each method falls with a slope of its own: symplectic Euler highest, then leapfrog, Runge-Kutta, Yoshida's fourth order, PEFRL, Yoshida's sixth order, and Kahan and Li's eighth order, which reaches the level of rounding with about 600 evaluations.
height = 8.6
load 'plots/style.gp'
load 'plots/methods.gp'
file = 'build/data/09-work.dat'
set multiplot layout 1,2 margins 0.1,0.8,0.15,0.97 spacing 0.135,0
set logscale xy
eval decades
set format y '10^{%T}'
set xlabel 'evaluations in a period'
set ylabel 'largest error of the energy' offset 0.8
set xrange [40:8000]
set yrange [1e-16:1]
plot for [m in methods(file, '')] file index at(file, m) using 1:2 with linespoints ls style_of(m)
set key at screen 0.995,0.93 right top Left reverse samplen 1.5
set ylabel 'error of place after 400 d  (AU)' offset 0.8
plot for [m in methods(file, '')] file index at(file, m) using 1:3 with linespoints ls style_of(m) title name_of(m)
