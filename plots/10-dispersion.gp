# data: build/data/10-dispersion.dat
# command: build/bin/springs-studies --study dispersion -o build/data/10-dispersion.dat
# alt: Angular frequency against the number of half waves, one to six. Two rows of points, motion across the membrane from 2 to 6.3 and along it from 3.4 to 13.9 radians a second, lie on the curves of the discrete formula, which bend; the straight dashed curve of the continuous membrane leaves the lower row from the third half wave on.
width = 11
load 'plots/style.gp'
eval edges(0.12, 0.985, 0.16, 0.97)
set xlabel 'half waves {/:Italic r}  (one along {/:Italic y})'
set ylabel 'angular frequency  (rad/s)' offset 0.5
set xrange [0:7]
set yrange [0:16]
set key at graph 0.03,0.97 left top samplen 1.5
s(r) = sin(pi*r/14)**2
set samples 200
plot sqrt(40*(s(x) + s(1))) ls 9, 2*sqrt(50*s(x) + 10*s(1)) ls 9, \
     sqrt(40*(pi/14)**2*(x**2 + 1)) ls 9 dt 2 title 'continuous membrane', \
     'build/data/10-dispersion.dat' using 1:3 with points ls 2 title 'motion along {/:Italic x}', \
     '' using 1:2 with points ls 1 title 'motion across'
