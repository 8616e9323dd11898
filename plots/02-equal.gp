# data: build/data/02-equal.dat
# command: build/bin/bonkers --masses 1,1,1,1,1,1 --positions 1,2.2,3.1,4.7,6,7.4 --velocities 1.3,-0.6,0.35,-1.9,0.8,-0.2 --walls 0,8 --every 0.01 --until 8 -o build/data/02-equal.dat
# alt: World lines of six beads of equal mass between two stops, position across and time upwards. The picture is made of six straight lines that pass through each other and turn round only at the stops; the thick line of one bead goes along one of them from crossing to crossing, and at each it changes to another.
width = 11
height = 5.8
load 'plots/style.gp'
file = 'build/data/02-equal.dat'
set xlabel 'position {/:Italic x} (m)'
set ylabel 'time {/:Italic t} (s)' offset 0.8
set xrange [-0.1:8.1]
set yrange [0:8]
set tics 2
eval edges(0.105, 0.98, 0.19, 0.97)
set arrow 1 from 0,graph 0 to 0,graph 1 nohead ls 9 lw 4*thick
set arrow 2 from 8,graph 0 to 8,graph 1 nohead ls 9 lw 4*thick
plot for [i=1:6] file using (column(3+2*i)):1 with lines lc rgb '#333333' lw 1.0*thick, \
     file using 9:1 with lines lc rgb red lw 3*thick
