# data: build/data/08-orbit.dat
# command: for m in euler symplectic-euler leapfrog; do build/bin/orbit0 $m 0.02 5; echo; echo; done > build/data/08-orbit.dat
# alt: Left: five years of a planet seen from the sun. Euler's method winds outwards in a spiral; the points of leapfrog lie on the circle of radius one. Right: the energy against time. Euler's rises at once and levels off at a third of its value; that of the other two methods stays within the width of the line.
height = 6.8
load 'plots/style.gp'
load 'plots/methods.gp'
file = 'build/data/08-orbit.dat'
set multiplot layout 1,2 margins 0.07,0.985,0.16,0.97 spacing 0.14,0
set size ratio -1
set xrange [-2.6:2.6]
set yrange [-2.6:2.6]
set tics 1
set xlabel '{/:Italic x}  (AU)'
set ylabel '{/:Italic y}  (AU)' offset 1
plot file index 0 using 2:3 with lines ls style_of('euler'), \
     file index 2 using 2:3 with points ls style_of('leapfrog'), \
     '+' using (0):(0) every ::::0 with points pt 7 ps 1.4*big lc rgb orange
set size noratio
set xrange [0:5]
set yrange [-21:-4]
set ytics 5
set xlabel '{/:Italic t}  (years)'
set ylabel 'energy  (AU^2/yr^2)' offset 0
set key at graph 0.97,0.55 right top Left reverse samplen 2
plot for [k=0:2] m=word('euler symplectic-euler leapfrog', k+1) file index k using 1:4 \
     with lines ls style_of(m) lw (3-k)*1.2*thick title name_of(m)
