# data: build/data/02-worldlines.dat
# command: build/bin/bonkers --preset mixed --every 0.005 --until 3 -o build/data/02-worldlines.dat
# lecture: build/bin/bonkers --preset mixed --every 0.005 --until 6 -o build/data/02-worldlines.dat
# alt: World lines of eight bodies between two walls, position across and time upwards. Four heavy bodies, thick lines, move to the right, meet four light ones and squeeze them against the right wall; the light lines turn to and fro steeply, the heavy ones bend gently back. No line crosses another.
width = 14
height = 8.6
load 'plots/style.gp'
file = 'build/data/02-worldlines.dat'
set xlabel 'position {/:Italic x} (m)'
set ylabel 'time {/:Italic t} (s)' offset 0.8
set xrange [0.85:10.15]
set yrange [0:lecture ? 6 : 3]
set lmargin at screen 0.085
set bmargin at screen 0.145
set tmargin at screen 0.97
set rmargin at screen 0.98
set arrow 1 from 1,graph 0 to 1,graph 1 nohead ls 9 lw 4*thick
set arrow 2 from 10,graph 0 to 10,graph 1 nohead ls 9 lw 4*thick
plot for [i=1:4] file using (column(3+2*i)):1 with lines lc rgb blue lw 3*thick, \
     for [i=5:8] file using (column(3+2*i)):1 with lines lc rgb red lw 1.2*thick
