# data: build/data/02-reverse.dat
# command: build/bin/bonkers-studies --study reverse --collisions 1000000 -o build/data/02-reverse.dat
# lecture: build/bin/bonkers-studies --study reverse --collisions 20000000 -o build/data/02-reverse.dat
# alt: Largest error of a position after n collisions forth and as many back, both axes logarithmic. Naive engine and scan lie on a line of slope three halves; the difference form of the collision on a line of slope two, above them; single precision nine decades higher.
height = 8
load 'plots/style.gp'
file = 'build/data/02-reverse.dat'
# The scan and the difference form, in the mean of the logarithms.
stats file using (log($3/$1**1.5)) nooutput
scan = exp(STATS_mean)
stats file using (log($4/$1**2)) nooutput
difference = exp(STATS_mean)
eval powers
set xlabel 'collisions {/:Italic n}, and as many back'
set ylabel 'largest error of a position (m)' offset 0.5
set xrange [80:lecture ? 3e7 : 1.5e6]
set yrange [1e-15:1e6]
eval edges(0.13, 0.98, 0.15, 0.97)
set key at graph 0.98,0.98 right top samplen 1.5 spacing 1.1 maxrows 2 width -2
set label 1 '∝ {/:Italic n}^{3/2}' at 3e5,3e-10 tc rgb '#555555'
set label 2 '∝ {/:Italic n}^2' at 2e4,8e-9 right tc rgb '#555555'
plot scan*x**1.5 ls 9, difference*x**2 ls 9, \
     file using 1:5 with points ls 4 title 'single precision', \
     file using 1:4 with points ls 2 title 'difference form', \
     file using 1:2 with points ls 5 title 'naive', \
     file using 1:3 with points ls 1 title 'scan'
