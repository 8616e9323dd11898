# data: build/data/05-collapse.dat
# command: build/bin/disks-studies --study collapse -o build/data/05-collapse.dat
# lecture: build/bin/disks-studies --study collapse --starts 40 -o build/data/05-collapse.dat
# alt: Left, share of starts that collapse against the restitution: for 100 disks all of them up to 0.5, none from 0.7 on; for 30 disks nearly all up to 0.45, none from 0.55; for 10 disks less than half even at 0.05. Right, 100 disks in a square; the filled ones stand in two touching rows that begin at walls and meet.
height = 7.5
load 'plots/style.gp'
file = 'build/data/05-collapse.dat'
set multiplot
eval edges(0.085, 0.5, 0.16, 0.97)
set xrange [0:1]
set yrange [-0.03:1.08]
set xlabel 'restitution {/:Italic e}'
set ylabel 'share that collapses' offset 1
set key at graph 0.98,0.95 right top samplen 1.5 title '{/:Italic N}'
plot file index 0 using 1:4 with linespoints ls 1 title '100', \
     file index 0 using 1:3 with linespoints ls 2 title '30', \
     file index 0 using 1:2 with linespoints ls 3 title '10'
side = sqrt(100*2.8)
eval edges(0.53, 0.995, 0.02, 0.98)
unset key
unset xlabel
unset ylabel
eval drawing
set xrange [-0.5:side+0.5]
set yrange [-0.5:side+0.5]
set object 1 rectangle from 0,0 to side,side fs empty border lc rgb '#333333' lw 1.5*thick
plot file index 1 using 1:2:(0.5) with circles fc rgb '#dddddd' fs solid border lc rgb '#888888', \
     file index 1 using 1:($3 > 0 ? $2 : NaN):(0.5) with circles fc rgb red fs solid border lc rgb red
