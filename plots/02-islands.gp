# data: build/data/02-islands.dat
# command: build/bin/bonkers-studies --study islands --until 0.8 -o build/data/02-islands.dat
# alt: Sixty nearly upright world lines in a narrow band of time. About twenty collisions are marked; they form nine groups, each group with a symbol and colour of its own, and between two groups there is always a body that no collision has touched.
width = 14
height = 6.6
load 'plots/style.gp'
file = 'build/data/02-islands.dat'
set xlabel 'position {/:Italic x} (m)'
set ylabel 'time {/:Italic t} (s)' offset 0.8
set xrange [0:61]
set yrange [0:0.8]
set lmargin at screen 0.085
set bmargin at screen 0.17
set tmargin at screen 0.97
set rmargin at screen 0.98
shape(k) = word('7 5 9 11 13', int(k-1)%5+1)+0
colour(k) = word('0x0072b2 0xd55e00 0x009e73 0xaa4499 0x000000', int(k-1)%5+1)+0
plot file index 0 using 1:2 with lines ls 9, \
     file index 1 using 1:2:(1.1*big):(shape($3)):(colour($3)) with points ps variable pt variable lc rgb variable
