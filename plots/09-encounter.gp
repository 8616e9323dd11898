# data: build/data/09-encounter.dat
# command: build/bin/gravity-studies --study encounter -o build/data/09-encounter.dat
# alt: Error of place, left, and of energy, right, after a fall past the Sun, against the closest approach from 0.3 to 3e-6 astronomical units, all logarithmic. Without softening both methods fail abruptly below about 0.01: leapfrog's place error rises with slope minus three and its energy jumps to ten thousand times what it was. With softening the energy error stays below 2e-7 throughout, and the place is wrong by 0.004 at the far end and by two, the whole width, at the near end.
load 'plots/style.gp'
load 'plots/methods.gp'
file = 'build/data/09-encounter.dat'
set multiplot layout 1,2 margins 0.1,0.985,0.16,0.97 spacing 0.115,0
eval powers
set xlabel 'closest approach  (AU)'
set ylabel 'error of place  (AU)' offset 1
set xrange [2e-6:0.5]
set yrange [1e-16:1e6]
set key at graph 0.03,0.06 left bottom Left reverse samplen 2
plot file using 1:5 with linespoints ls style_of('leapfrog') title name_of('leapfrog'), \
     file using 1:6 with linespoints ls style_of('kahan-li8') title name_of('kahan-li8'), \
     file using 1:7 with linespoints ls style_of('leapfrog') pt 6 dt 3 title name_of('leapfrog').', softened'
set ylabel 'error of the energy' offset 1
plot file using 1:2 with linespoints ls style_of('leapfrog'), \
     file using 1:3 with linespoints ls style_of('kahan-li8'), \
     file using 1:4 with linespoints ls style_of('leapfrog') pt 6 dt 3
