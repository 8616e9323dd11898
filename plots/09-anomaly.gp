# data: build/data/09-anomaly.dat
# command: build/bin/gravity-studies --study anomaly -o build/data/09-anomaly.dat
# alt: Left: eccentric against mean anomaly from 0 to pi for four eccentricities: a nearly straight line for 0.1, and for 0.99 a curve that leaves the origin almost vertically. Right: an ellipse of eccentricity 0.7 with the Sun in a focus and 24 places at equal times, far apart near the Sun and close together far from it.
height = 6.6
load 'plots/style.gp'
file = 'build/data/09-anomaly.dat'
set multiplot
eval edges(0.1, 0.47, 0.17, 0.97)
set xrange [0:pi]
set yrange [0:pi]
set xtics ('0' 0, '{/Symbol p}/2' pi/2, '{/Symbol p}' pi)
set ytics ('0' 0, '{/Symbol p}/2' pi/2, '{/Symbol p}' pi)
set xlabel 'mean anomaly {/:Italic M}'
set ylabel 'eccentric anomaly {/:Italic E}' offset 0.3
set key at graph 0.97,0.04 right bottom samplen 2
plot file index 0 using 1:5 with lines ls 4 title '{/:Italic e} = 0.99', \
     file index 0 using 1:4 with lines ls 3 dt 4 title '0.9', \
     file index 0 using 1:3 with lines ls 2 dt 2 title '0.5', \
     file index 0 using 1:2 with lines ls 1 title '0.1'
set lmargin at screen 0.53
set rmargin at screen 0.99
set size ratio -1
set xrange [-1.8:0.5]
set yrange [-0.85:0.85]
unset xtics
unset ytics
unset border
unset xlabel
unset ylabel
set parametric
set trange [0:2*pi]
plot cos(t) - 0.7, sqrt(1 - 0.49)*sin(t) ls 9, \
     file index 1 using 1:2:(-$1):(-$2) with vectors nohead lc rgb '#cccccc', \
     file index 1 using 1:2 with points ls 1, \
     '+' using (0):(0) every ::::0 with points pt 7 ps 1.6*big lc rgb orange
