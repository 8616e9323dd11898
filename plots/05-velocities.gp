# data: build/data/05-velocities.dat
# command: build/bin/disks --disks 4 --radius 0.15 --box 1,1 --every 0.1 --samples 100000 --measure states -o - | build/bin/histogram --block --column vx,vy --range=-2,2 --bins 40 --law microcanonical:8,2,1 -o build/data/05-velocities.dat -
# lecture: build/bin/disks --disks 4 --radius 0.15 --box 1,1 --every 0.1 --samples 400000 --measure states -o - | build/bin/histogram --block --column vx,vy --range=-2,2 --bins 40 --law microcanonical:8,2,1 -o build/data/05-velocities.dat -
# alt: Density of a component of the velocity from minus 2 to 2 metres per second. The points follow a curve that is 0.51 high in the middle and reaches zero at 2. A dashed Gaussian of the same width is higher in the middle, 0.56, lower at one, and higher beyond 1.6.
height = 6.5
load 'plots/style.gp'
file = 'build/data/05-velocities.dat'
law(v) = abs(v) < 2 ? gamma(4)/gamma(3.5)/sqrt(pi)/2*(1-v*v/4)**2.5 : 0
gauss(v) = exp(-v*v)/sqrt(pi)
set samples 500
set xrange [-2.2:2.2]
set yrange [0:0.62]
set xlabel 'component of the velocity  (m/s)'
set ylabel 'density  (s/m)' offset 1
eval edges(0.09, 0.985, 0.18, 0.97)
set key at graph 0.02,0.96 left top reverse Left samplen 2
plot gauss(x) with lines lc rgb red dt 2 lw 1.5*thick title 'Gaussian', \
     law(x) with lines lc rgb '#555555' lw 1.5*thick title '(1 − {/:Italic mv}^2/2{/:Italic E})^{5/2}', \
     file index 0 using 1:3:4 with yerrorbars ls 1 title '{/:Italic v_x}', \
     file index 1 using 1:3:4 with yerrorbars ls 3 title '{/:Italic v_y}'
