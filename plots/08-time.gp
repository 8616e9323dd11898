# data: plots/data/08-cost.dat
# alt: Error after ten orbits against processor time, both logarithmic, from ten microseconds to thirty milliseconds. The order of the methods is that of the evaluations: rk8pd and Kahan and Li's method are the cheapest below an error of a thousandth, leapfrog and symplectic Euler have errors of a hundredth only in the middle of the scale, Euler never arrives.
height = 8
load 'plots/style.gp'
size = 0.7
load 'plots/methods.gp'
file = 'plots/data/08-cost.dat'
eval powers
set xrange [1e-5:5e-2]
set yrange [1e-14:10]
set ytics 100
set xlabel 'processor time of ten orbits  (s)'
set ylabel 'error at the end' offset 0.5
eval edges(0.1, 0.755, 0.15, 0.97)
set key at screen 0.99,0.97 right top samplen 2 Left reverse
plot for [m in methods(file, known)] file index at(file, m) using 3:4 \
     with linespoints ls style_of(m) title name_of(m)
