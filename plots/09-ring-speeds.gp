# data: build/data/09-ring-speeds.dat
# command: build/bin/gravity-studies --study ring-speeds -o build/data/09-ring-speeds.dat
# alt: Speed of a circle against its radius from 1.5 to 3. Without a ring it falls smoothly. With a ring of two per cent of the planet's mass between 2 and 2.5 it lies below that curve inside and above it outside, with a sharp dip at the inner edge and a sharp peak at the outer one. A dashed curve, for a ring seven times as heavy, has the same shape but much larger.
height = 7.4
load 'plots/style.gp'
file = 'build/data/09-ring-speeds.dat'
eval edges(0.105, 0.985, 0.15, 0.97)
set xlabel '{/:Italic r}  (AU)'
set ylabel 'speed  (AU/d)' offset 1
set xrange [1.5:3]
set yrange [0.0065:0.0178]
set object 1 rectangle from 2,0.0065 to 2.5,0.0178 fs solid 1 noborder fc rgb '#f0f0f0' behind
set label 1 'ring' at 2.25,0.007 center tc rgb '#555555'
set key at graph 0.02,0.97 left top Left reverse samplen 2
plot file using 1:4 with lines lc rgb red lw 1.5*thick dt 2 title '0.02 planets on every AU^2', \
     file using 1:3 with lines ls 1 title 'a ring of 0.02 planets', \
     file using 1:2 with lines ls 9 title 'no ring'
