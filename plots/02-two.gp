# data: build/data/02-two-3.dat
# command: build/bin/bonkers --preset two --mass-ratio 3 --every 0.37 --samples 4000 -o build/data/02-two-3.dat
# data: build/data/02-two-golden.dat
# command: build/bin/bonkers --preset two --mass-ratio 1.618033988749895 --every 0.37 --samples 4000 -o build/data/02-two-golden.dat
# lecture: build/bin/bonkers --preset two --mass-ratio 1.618033988749895 --every 0.37 --samples 20000 -o build/data/02-two-golden.dat
# alt: Scaled velocities of two balls in a box on the circle of constant energy, in two panels. For the mass ratio 3 all samples fall on twelve points. For the golden ratio many points cover the circle, in unequal density.
height = 7.2
load 'plots/style.gp'
set multiplot
set size ratio -1
set xrange [-1.25:1.25]
set yrange [-1.25:1.25]
set tics 1
set xlabel '{/:Italic v}_1 √({/:Italic m}_1/2{/:Italic E})'
set ylabel '{/:Italic v}_2 √({/:Italic m}_2/2{/:Italic E})' offset 0.8
set parametric
set trange [0:2*pi]
eval edges(0.08, 0.5, 0.16, 0.9)
file = 'build/data/02-two-3.dat'
m2 = mass(file, 2)
set title sprintf('{/:Italic m}_2/{/:Italic m}_1 = %g', m2) offset 0,-0.6
plot cos(t),sin(t) ls 9, file using ($6/sqrt(2*$2)):($8*sqrt(m2/(2*$2))) with points ls 1
set lmargin at screen 0.57
set rmargin at screen 0.99
unset ylabel
file = 'build/data/02-two-golden.dat'
m2 = mass(file, 2)
set title sprintf('{/:Italic m}_2/{/:Italic m}_1 = %.3f…', m2)
plot cos(t),sin(t) ls 9, file using ($6/sqrt(2*$2)):($8*sqrt(m2/(2*$2))) with points ls 2 ps 0.2*big
