# data: build/data/02-drift.dat
# command: build/bin/bonkers-studies --study drift --collisions 10000000 -o build/data/02-drift.dat
# lecture: build/bin/bonkers-studies --study drift --collisions 1000000000 -o build/data/02-drift.dat
# alt: Relative error of the energy against the number of collisions, both axes logarithmic. Double precision scatters about a line of slope one half up to a million collisions and then rises with slope one, to ten to the minus twelve; three bodies with masses 1, 2 and 1.5 lie on a line of slope one from the beginning, a hundred times higher at the end; single precision follows a line of slope one half, half a thousand million times higher.
height = 7.6
load 'plots/style.gp'
file = 'build/data/02-drift.dat'
eval powers
set xlabel 'collisions {/:Italic n}'
set ylabel '|Δ{/:Italic E}| / {/:Italic E}' offset 0.5
set xrange [80:lecture ? 1.3e9 : 1.3e7]
set yrange [1e-17:1e-3]
eval edges(0.13, 0.98, 0.155, 0.97)
set label 1 'single precision' at 1.2e3,2e-4 tc rgb red
set label 2 'double precision' at 3e5,5e-15 tc rgb blue
eps = 2.0**-52
single = 2.0**-23
set label 3 'masses 1, 2, 1.5' at 6e4,2e-11 right tc rgb '#007a58'
plot 0.3*eps*sqrt(x) ls 9, 0.3*single*sqrt(x) ls 9, \
     x > 3e5 ? 5e-4*eps*x : NaN ls 9, 0.05*eps*x ls 9, \
     file using 1:(abs($3)) with points ls 3, \
     file using 1:(abs($2)) with points ls 1, \
     file using 1:(abs($4)) with points ls 2
