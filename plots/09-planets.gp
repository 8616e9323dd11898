# data: build/data/09-planets.dat
# command: build/bin/gravity-studies --study planets -o build/data/09-planets.dat
# lecture: build/bin/gravity-studies --study planets --orbits 10000 -o build/data/09-planets.dat
# alt: Eccentricity of the Earth's orbit, left, and of Mars's, right, over a thousand years, with Jupiter's mass as it is and 30, 100 and 300 times that. With the true mass the curves are nearly flat; the heavier Jupiter is, the more they swing, up to 0.05 for the Earth and 0.17 for Mars.
load 'plots/style.gp'
file = 'build/data/09-planets.dat'
set multiplot layout 1,2 margins 0.095,0.96,0.16,0.9 spacing 0.1,0
set xlabel '{/:Italic t}  (years)'
set ylabel 'eccentricity' offset 1
set yrange [0:0.085]
set key at graph 0.02,0.98 left top Left reverse samplen 2 horizontal maxcols 2
set title 'the Earth' offset 0,-0.6
plot file using 1:8 with lines ls 4 title '× 300', \
     file using 1:6 with lines ls 2 title '× 100', \
     file using 1:4 with lines ls 3 title '× 30', \
     file using 1:2 with lines ls 1 title 'Jupiter'
set title 'Mars'
set yrange [0:0.2]
plot file using 1:9 with lines ls 4, \
     file using 1:7 with lines ls 2, \
     file using 1:5 with lines ls 3, \
     file using 1:3 with lines ls 1
