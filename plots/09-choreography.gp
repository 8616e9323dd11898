# data: build/data/09-choreography.dat
# command: build/bin/gravity-studies --study choreography -o build/data/09-choreography.dat
# alt: Left, logarithmic: how far the bodies of a choreography are off their circle against the number of orbits, for 3, 4, 6, 8 and 9 bodies. All start at rounding, ten to the minus sixteen, and rise in straight lines, the more bodies the steeper, to one tenth after eight to three orbits. Right: rate of growth against the number of bodies from 3 to 10, points of the runs on the line of the linear theory, from 0.7 to 2.4.
height = 7.4
load 'plots/style.gp'
file = 'build/data/09-choreography.dat'
set multiplot layout 1,2 margins 0.1,0.985,0.15,0.97 spacing 0.11,0
set logscale y
set format y '10^{%T}'
set xlabel 'orbits'
set ylabel 'deviation from the circle' offset 1
set xrange [0:8.5]
set yrange [1e-17:3]
set key at graph 0.98,0.04 right bottom samplen 1.5
plot file index 0 using 1:2 with points ls 1 title '3', \
     file index 1 using 1:2 with points ls 2 title '4', \
     file index 3 using 1:2 with points ls 3 title '6', \
     file index 5 using 1:2 with points ls 4 title '8', \
     file index 6 using 1:2 with points ls 5 title '9 bodies'
unset logscale
set format y '%g'
set xlabel 'bodies {/:Italic N}'
set ylabel 'growth rate / angular velocity' offset 0
set xrange [2.5:10.5]
set yrange [0:2.7]
plot file index 8 using 1:4 with lines ls 9, \
     file index 8 using 1:5 with points ls 1
