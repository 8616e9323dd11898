# data: build/data/09-eccentric.dat
# command: build/bin/gravity-studies --study eccentric -o build/data/09-eccentric.dat
# alt: Left, logarithmic: error of place after one orbit with ten thousand evaluations against eccentricity, for three methods. For round orbits leapfrog has 1e-6, Runge-Kutta 1e-11, the eighth order 1e-14. Towards e = 0.99 all rise, the better ones faster, and beyond 0.95 leapfrog is the best of three bad ones. Right: six orbits of e = 0.95 by leapfrog with a thousand steps each: thin ellipses that turn from orbit to orbit.
load 'plots/style.gp'
load 'plots/methods.gp'
file = 'build/data/09-eccentric.dat'
set multiplot
eval edges(0.1, 0.52, 0.16, 0.97)
set logscale y
set format y '10^{%T}'
set xrange [0:1]
set yrange [1e-15:1e2]
set xlabel 'eccentricity'
set ylabel 'error of place after an orbit' offset 1
set key at graph 0.04,0.97 left top Left reverse samplen 2
plot file index 0 using 1:2 with linespoints ls style_of('leapfrog') title name_of('leapfrog'), \
     file index 0 using 1:3 with linespoints ls style_of('rk4') title name_of('rk4'), \
     file index 0 using 1:4 with linespoints ls style_of('kahan-li8') title name_of('kahan-li8')
unset logscale
set format y '%g'
set size ratio -1
set lmargin at screen 0.62
set rmargin at screen 0.985
set xrange [*:*]
set yrange [*:*]
set xlabel '{/:Italic x}'
set ylabel '{/:Italic y}' offset 1
plot file index 1 using 1:2 with lines ls style_of('leapfrog') lw 0.8*thick, \
     '+' using (0):(0) every ::::0 with points pt 7 ps 1.2*big lc rgb orange
