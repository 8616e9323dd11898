# data: build/data/11-break.dat
# command: build/bin/spheres-studies --study break -o build/data/11-break.dat
# alt: Two pictures of sixteen balls half a second after the break. Left, filled balls and open balls are mirror images of each other in the axis of the shot; two balls have flown far out, one to either side. Right, by events there are two answers for a hundred racks, mirror images too; rings mark the places by steps, the deepest pair first, which fall on one of the two.
width = 14
height = 7.5
load 'plots/style.gp'
file = 'build/data/11-break.dat'
set multiplot layout 1,2 margins 0.075,0.99,0.16,0.9 spacing 0.035,0
set size ratio -1
set xrange [-0.75:2.6]
set yrange [-1.7:1.7]
set xlabel '{/:Italic x}  (m)'
set ylabel '{/:Italic y}  (m)' offset 1.5
set title 'by steps' offset 0,-0.6
set key at graph 0.03,0.97 left top samplen 1
plot file index 0 using 1:2 with points lc rgb blue pt 7 ps 0.9*big title 'ascending', \
     file index 0 using 3:4 with points lc rgb red pt 6 lw 1.3*thick ps 0.9*big title 'descending'
set title 'by events'
set ylabel ''
set format y ''
plot file index 1 using 1:2 with points lc rgb dark pt 7 ps 0.5*big title 'events', \
     file index 0 using 5:6 with points lc rgb green pt 6 lw 1.3*thick ps 1.1*big title 'deepest first'
unset multiplot
