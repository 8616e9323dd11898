# data: build/data/01-map.dat
# command: build/bin/collide-forms --study map --tests 8 --seed 8 -o build/data/01-map.dat
# alt: Two panels. Left: the plane of velocities u1 and u2 with the ellipse of constant energy; eight pairs of points, before and after a collision, each joined by a straight line of constant momentum; two arrows mark the fixed direction (1,1) and the reversed direction. Right: the same in scaled velocities, where the ellipse is a circle and each pair is a mirror image in the fixed line.
load 'plots/style.gp'
file = 'build/data/01-map.dat'
a = 1.0
b = 0.25
set multiplot layout 1,2 margins 0.1,0.985,0.175,0.97 spacing 0.12,0
set size ratio -1
set parametric
set trange [0:2*pi]
set samples 400
set xrange [-1.5:1.5]
set yrange [-1.5:1.5]
set tics 1
set mxtics 2
set mytics 2
set zeroaxis ls 9 dt 3

# The eigenvectors as arrows, names beside their tips.
set xlabel '{/:Italic u}_1  (m/s)'
set ylabel '{/:Italic u}_2  (m/s)' offset 1
set arrow 1 from 0,0 to 0.8,0.8 lw 2*thick lc rgb red front
set label 1 'fixed: (1, 1)' at 1.36,1.05 right tc rgb red front
set arrow 2 from 0,0 to 0.9,-0.225 lw 2*thick lc rgb green front
set label 2 'reversed: ({/:Italic a}, −{/:Italic b})' at 1.42,-0.75 right tc rgb green front
set label 3 'constant energy' at -1.42,1.3 left tc rgb '#555555'
plot sqrt(a)*cos(t), sqrt(b)*sin(t) ls 9 lw 1.5*thick, \
     file using 1:2:($3-$1):($4-$2) with vectors nohead lc rgb blue lw 0.8*thick, \
     file using 1:2 with points pt 6 ps 0.8*big lw 1.5*thick lc rgb blue, \
     file using 3:4 with points pt 7 ps 0.8*big lc rgb blue

set xlabel '√{/:Italic m}_1 {/:Italic u}_1  (J^{1/2})'
set ylabel '√{/:Italic m}_2 {/:Italic u}_2  (J^{1/2})' offset 1
# directions of length one: (sqrt m1, sqrt m2) and (sqrt a, -sqrt b)
set arrow 1 from 0,0 to 1/sqrt(5),2/sqrt(5) lw 2*thick lc rgb red front
set arrow 3 from -1.4/sqrt(5),-2.8/sqrt(5) to 1.4/sqrt(5),2.8/sqrt(5) nohead dt 2 lw 1*thick lc rgb red
set label 1 'fixed' at 0.72,1.2 left tc rgb red front
set arrow 2 from 0,0 to 2/sqrt(5),-1/sqrt(5) lw 2*thick lc rgb green front
set label 2 'reversed' at 1.42,-0.85 right tc rgb green front
plot cos(t), sin(t) ls 9 lw 1.5*thick, \
     file using ($1/sqrt(a)):($2/sqrt(b)):(($3-$1)/sqrt(a)):(($4-$2)/sqrt(b)) with vectors nohead lc rgb blue lw 0.8*thick, \
     file using ($1/sqrt(a)):($2/sqrt(b)) with points pt 6 ps 0.8*big lw 1.5*thick lc rgb blue, \
     file using ($3/sqrt(a)):($4/sqrt(b)) with points pt 7 ps 0.8*big lc rgb blue
