# data: plots/data/10-work.dat
# alt: Error after ten seconds against processor time, with logarithmic axes, from ten microseconds to a second. The leapfrog is the cheapest down to errors of ten to the minus four, PEFRL from there to a few times ten to the minus nine, Kahan and Li's eighth order method beyond. The implicit methods lie a factor of eight and more to the right.
width = 14
height = 8
load 'plots/style.gp'
load 'plots/methods.gp'
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
plot for [m in methods(file, known)] file index at(file, m) using 5:3 \
     with linespoints ls style_of(m) title name_of(m)
