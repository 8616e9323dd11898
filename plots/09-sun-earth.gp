# data: build/data/09-sun-earth.dat
# command: build/bin/gravity-studies --study sun-earth -o build/data/09-sun-earth.dat
# alt: Left: five years of the Earth seen from the Sun, in steps of two days. The closed form and leapfrog lie on one circle of radius one; Euler's method winds outwards in a spiral to twice the distance. Right: the distance against time: leapfrog stays at one, Euler's rises close to a grey law that grows as the cube root of the time.
load 'plots/style.gp'
load 'plots/methods.gp'
file = 'build/data/09-sun-earth.dat'
set multiplot layout 1,2 margins 0.08,0.985,0.16,0.97 spacing 0.12,0
set size ratio -1
set xrange [-2.4:2.4]
set yrange [-2.4:2.4]
set tics 1
set xlabel '{/:Italic x}  (AU)'
set ylabel '{/:Italic y}  (AU)' offset 1
plot file using 4:5 with lines ls style_of('euler'), \
     file using 2:3 with lines ls 9, \
     file every 12 using 6:7 with points ls style_of('leapfrog'), \
     '+' using (0):(0) every ::::0 with points pt 7 ps 1.4*big lc rgb orange
set size noratio
set ytics 0.4
set xrange [0:5]
set yrange [0.8:2.3]
set xlabel '{/:Italic t}  (years)'
set ylabel 'distance  (AU)' offset 1
set key at graph 0.03,0.97 left top Left reverse samplen 2
k = 0.0172
h = 2*k
year = 365.25
plot (1 + 6*h*k*year*x)**(1./3) ls 9 title 'law', \
     file using ($1/year):(sqrt($4**2+$5**2)) with lines ls style_of('euler') title name_of('euler'), \
     file every 12 using ($1/year):(sqrt($6**2+$7**2)) with points ls style_of('leapfrog') title name_of('leapfrog')
