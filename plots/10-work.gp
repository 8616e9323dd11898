# data: plots/data/10-work.dat
# alt: Error after ten seconds against processor time, with logarithmic axes, from ten microseconds to a second. The leapfrog is the cheapest down to errors of ten to the minus four, PEFRL from there to a few times ten to the minus nine, Kahan and Li's eighth order method beyond. The implicit methods lie a factor of eight and more to the right.
height = 8
load 'plots/style.gp'
load 'plots/methods.gp'
eval edges(0.1, 0.735, 0.14, 0.97)
eval powers
set xlabel 'processor time  (s)'
set ylabel 'error after 10 s  (m)' offset 1
set xrange [1e-5:2]
set yrange [1e-13:3]
set key at screen 0.985,0.97 right top samplen 1.5
file = 'plots/data/10-work.dat'
plot for [m in methods(file, known)] file index at(file, m) using 5:3 \
     with linespoints ls style_of(m) title name_of(m)
