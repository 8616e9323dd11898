# data: build/data/05-timeline.dat
# command: build/bin/disks-studies --study timeline --every 0.05 --seed 21 -o build/data/05-timeline.dat
# alt: Height of one disk against time, 0 to 1.5 seconds. A zigzag line is its path, with ticks above at every event of the four disks. Filled circles at every twentieth of a second lie on it. Crosses lie on it until the first event; there they fall back, and from then on follow a path of their own.
height = 6.5
load 'plots/style.gp'
file = 'build/data/05-timeline.dat'
set xrange [0:1.5]
set yrange [0.11:0.99]
set ytics 0.15,0.1,0.86
set xtics 0.1
set xlabel 'time {/:Italic t}  (s)'
set ylabel 'height {/:Italic y} of disk 1  (m)' offset 1
eval edges(0.095, 0.98, 0.18, 0.97)
set grid xtics lc rgb '#dddddd' lt 1
set label 1 "events" at 0.01,0.955 front tc rgb '#333333'
set arrow 1 from 0,0.15 to 1.5,0.15 nohead ls 9 dt 2
set arrow 2 from 0,0.85 to 1.5,0.85 nohead ls 9 dt 2
plot file index 0 using 1:(0.89):(0):(0.03) with vectors nohead lc rgb '#333333' lw 1*thick, \
     file index 0 using 1:3 with lines lc rgb blue lw 1.5*thick, \
     file index 1 using 1:3 with points ls 1 ps 0.7*big, \
     file index 2 using 1:($1 <= 1.5 ? $3 : NaN) with points pt 2 ps 0.8*big lw 1.5*thick lc rgb red
