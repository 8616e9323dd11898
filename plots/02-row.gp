# data: build/data/02-row.dat
# command: build/bin/bonkers-studies --study row -o build/data/02-row.dat
# alt: Collisions of a row of bodies that touch, against their number from 10 to 160, both axes logarithmic. Struck from the left, and struck from the right with a nanometre between the bodies, the points rise with slope two; struck from the right while touching they leave that line at forty bodies and stand a hundred times above it at 160.
width = 11
height = 5.6
load 'plots/style.gp'
file = 'build/data/02-row.dat'
set logscale xy
set format y '10^{%T}'
set xlabel 'bodies in the row {/:Italic N}'
set ylabel 'collisions' offset 0.5
set xrange [8:200]
set yrange [10:4e6]
set xtics (10, 20, 40, 80, 160)
eval edges(0.125, 0.975, 0.2, 0.965)
set key at graph 0.03,0.97 left top reverse Left samplen 1.5 spacing 1.15
set label 1 '{/:Italic N}^{ 2}/2' at 110,2.3e3 left tc rgb '#555555'
plot x**2/2 ls 9, \
     file using 1:3 with points ls 2 title 'from the right', \
     file using 1:2 with points ls 1 title 'from the left', \
     file using 1:4 with points ls 3 pt 8 title 'from the right, 1 nm apart'
