# data: build/data/03-two.dat
# command: build/bin/bonkers --preset two --every 0.7 --samples 200000 -o - | build/bin/histogram --skip 1 --block --column v1,v2,x1,x2 --bins 40 --range=-1.34164,1.34164 --range=-0.45,0.45 --range 0,3 --range 0,3 --law microcanonical:2 --law microcanonical:2 --law beta:1,2,0,3 --law beta:2,2,0,3 -o build/data/03-two.dat -
# data: build/data/03-two-states.dat
# command: build/bin/bonkers --preset two --every 0.7 --samples 4000 -o build/data/03-two-states.dat
# alt: Three panels for two balls. The histogram of the light ball's velocity is a comb of a few spikes and not the arcsine law. The scatter plot of the two velocities shows some twenty spots on an ellipse. The histograms of the two positions come close to straight lines, one falling and one rising.
height = 5.5
load 'plots/style.gp'
file = 'build/data/03-two.dat'
states = 'build/data/03-two-states.dat'
stats states using 2 every ::1::1 nooutput
energy = STATS_min
set multiplot layout 1,3 margins 0.075,0.985,0.205,0.97 spacing 0.105,0
set xlabel '{/:Italic v}_1  (m/s)'
set ylabel 'density  (s/m)' offset 1.5
set xrange [-1.4:1.4]
set yrange [0:3]
set tics 1
plot file index 0 using 1:5 with histeps ls 9 lw 1.4*thick, \
     file index 0 using 1:3:4 with yerrorbars ls 1 ps 0.4*big
set ylabel '{/:Italic v}_2  (m/s)' offset 0.6
set yrange [-0.5:0.5]
set ytics 0.2
set parametric
set trange [0:2*pi]
plot sqrt(2*energy)*cos(t), sqrt(2*energy/9)*sin(t) ls 9, \
     states using 6:8 with points pt 7 ps 0.3*big lc rgb blue
set xlabel 'position  (m)'
set ylabel 'density  (1/m)' offset 1.5
set xrange [0:3]
set yrange [0:0.85]
set ytics 0.2
set key at graph 0.5,0.98 center top horizontal samplen 0.8 width 0
plot file index 2 using 1:5 with lines ls 9 lw 1.4*thick, file index 3 using 1:5 with lines ls 9 lw 1.4*thick, \
     file index 2 using 1:3:4 with yerrorbars ls 1 ps 0.35*big title '{/:Italic x}_1', \
     file index 3 using 1:3:4 with yerrorbars ls 2 ps 0.35*big title '{/:Italic x}_2'
