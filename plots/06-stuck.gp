# data: build/data/06-radii.dat
# command: build/bin/sample-studies --study memory --radii 0.1,0.12,0.14,0.15,0.16,0.17,0.18,0.185,0.19,0.195,0.2,0.205,0.21,0.22,0.23,0.24 --step 0.15 --samples 1000000 -o build/data/06-radii.dat
# lecture: build/bin/sample-studies --study memory --radii 0.1,0.12,0.14,0.15,0.16,0.17,0.18,0.185,0.19,0.195,0.2,0.205,0.21,0.22,0.23,0.24 --step 0.15 --samples 10000000 -o build/data/06-radii.dat
# alt: Left, inefficiency against radius: of the place of one disk it rises from 100 sweeps at 0.1 beyond 10000 at 0.18 and suddenly falls to 20 at 0.2, where the run is shorter than the memory; that of the share at the walls rises slowly from 7 to 260. Right, mean place of disk 1: close to 0.5 up to a radius of 0.18, and 0.3 from 0.2 on.
height = 6.5
load 'plots/style.gp'
file = 'build/data/06-radii.dat'
lock = (sqrt(2)-1)/2
set multiplot layout 1,2 margins 0.095,0.985,0.18,0.97 spacing 0.12,0
set xrange [0.09:0.26]
set xtics 0.05
set xlabel 'radius {/:Italic r}  (m)'
set ylabel 'inefficiency {/:Italic g}  (sweeps)' offset 1
set logscale y
set format y '10^{%T}'
set yrange [3:5e6]
set arrow 1 from lock,graph 0 to lock,graph 1 nohead dt 3 lc rgb '#555555'
set key at graph 0.03,0.97 left top samplen 1
plot file using 1:4 with linespoints ls 1 lw 1*thick title 'place of one disk', \
     file using 1:5 with linespoints ls 2 lw 1*thick title 'share at the walls'
unset logscale
set format y '%g'
set yrange [0.2:0.8]
set ylabel 'mean of {/:Italic x}_1  (m)' offset 1
plot 0.5 ls 9 lw 2*thick, file using 1:6 with points ls 1
