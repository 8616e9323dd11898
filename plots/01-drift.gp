# data: build/data/01-drift.dat
# command: build/bin/collide-forms --study drift --collisions 10000000 -o build/data/01-drift.dat
# lecture: build/bin/collide-forms --study drift --collisions 300000000 -o build/data/01-drift.dat
# alt: Relative energy error against number of collisions, both axes logarithmic. The forms difference, impulse and cm lie on straight lines of slope one, up to one part in a thousand million at ten million collisions. The forms complement and smaller scatter below a line of slope one half, four orders of magnitude lower.
height = 8
load 'plots/style.gp'
file = 'build/data/01-drift.dat'
# Difference, the worst of the three.
stats file using (log(abs($3)/$1)) nooutput
drift = exp(STATS_mean)
eval powers
set xlabel 'collisions {/:Italic n}'
set ylabel '|Δ{/:Italic E}| / {/:Italic E}' offset 0.5
set xrange [800:lecture ? 4e8 : 1.3e7]
set yrange [1e-16:lecture ? 1e-7 : 1e-8]
set key at graph 0.02,0.98 left top reverse Left samplen 1.5 spacing 1.1 maxrows (lecture ? 3 : 5)
eval edges(0.13, 0.98, 0.155, 0.97)
set label 1 '∝ {/:Italic n}' at 1.0e5,6e-11 tc rgb '#555555'
set label 2 '∝ √{/:Italic n}' at 3.2e6,3.5e-14 tc rgb '#555555'
eps = 2.0**-52
plot drift*x ls 9, 0.3*eps*sqrt(x) ls 9, \
     file using 1:(abs($3)) with points ls 2 title 'difference', \
     file using 1:(abs($4)) with points ls 3 title 'impulse', \
     file using 1:(abs($2)) with points ls 1 title 'cm', \
     file using 1:(abs($5)) with points ls 4 title 'complement', \
     file using 1:(abs($6)) with points ls 5 title 'smaller'
