# data: build/data/09-eight.dat
# command: build/bin/gravity-studies --study figure-eight -o build/data/09-eight.dat
# alt: Left: three bodies on one figure of eight lying on its side, at its right and left loop and at the crossing. Right, logarithmic: error of the places after one period against evaluations of the forces; leapfrog falls with slope two, Runge-Kutta with slope four, and the eighth-order method reaches rounding after a few thousand evaluations.
load 'plots/style.gp'
load 'plots/methods.gp'
file = 'build/data/09-eight.dat'
set multiplot
eval edges(0.085, 0.48, 0.16, 0.97)
set size ratio -1
set xrange [-1.25:1.25]
set yrange [-1.0:1.0]
set xlabel '{/:Italic x}'
set ylabel '{/:Italic y}' offset 1
plot file index 0 using 2:3 with lines ls 9, \
     file index 0 every ::0::0 using 2:3 with points ls 1 ps 1.3*big, \
     file index 0 every ::0::0 using 4:5 with points ls 2 ps 1.2*big, \
     file index 0 every ::0::0 using 6:7 with points ls 3 ps 1.5*big, \
     file index 0 every 12::0::60 using 2:3 with points ls 1 ps 0.5*big, \
     file index 0 every 12::0::60 using 4:5 with points ls 2 ps 0.5*big, \
     file index 0 every 12::0::60 using 6:7 with points ls 3 ps 0.5*big
set size noratio
set lmargin at screen 0.59
set rmargin at screen 0.985
eval powers
set xrange [70:3e5]
set yrange [1e-16:1]
set xlabel 'evaluations in a period'
set ylabel 'error after it' offset 1
set key at graph 0.97,0.97 right top samplen 2
plot file index 1 using 1:2 with linespoints ls style_of('leapfrog') title name_of('leapfrog'), \
     file index 2 using 1:2 with linespoints ls style_of('rk4') title name_of('rk4'), \
     file index 3 using 1:2 with linespoints ls style_of('kahan-li8') title name_of('kahan-li8')
