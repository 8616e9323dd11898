# data: build/data/03-spread.dat
# command: build/bin/bonkers --preset thermal --every 2.4 --samples 200000 -o - | build/bin/histogram --skip 1 --block --column v1,v2,v3,v4,v5,v6,v7,v8,v9,v10 --table columns -o build/data/03-spread.dat -
# data: build/data/03-states.dat
# command: build/bin/bonkers --preset thermal --every 10 --samples 2000 -o build/data/03-states.dat
# alt: Standard deviation of the velocity against mass on logarithmic axes: five points near one kilogram and one metre a second, five near four kilograms and half a metre a second, all on a straight line of slope minus one half.
width = 10
load 'plots/style.gp'
file = 'build/data/03-spread.dat'
# the masses of the ten, from a table that tells them
array m[10]
do for [i=1:10] { m[i] = mass('build/data/03-states.dat', i) }
set logscale xy
set xrange [0.8:5]
set yrange [0.42:1.15]
set xtics (1, 2, 3, 4)
set ytics (0.5, 0.7, 1)
set xlabel 'mass  (kg)'
set ylabel 'standard deviation of {/:Italic v}  (m/s)' offset 0.5
set key at graph 0.97,0.95 right top samplen 1.5
eval edges(0.14, 0.98, 0.18, 0.97)
plot 1/sqrt(x) ls 9 lw 1.5*thick title '√(2{/:Italic E}/{/:Italic nm})', \
     file using (m[int($0)+1]):5:6 with yerrorbars ls 1 title 'ten balls'
