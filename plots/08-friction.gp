# data: build/data/08-friction.dat
# command: build/bin/step-studies --study friction -o build/data/08-friction.dat
# alt: Factor by which a step changes a velocity under friction alone, against c dt from 0 to 6. The truth falls exponentially. Implicit midpoint falls to zero at 2 and rises slowly towards one. Gauss 4 stays near the truth and rises slowly from 3.5 on. Leapfrog leaves the truth early and exceeds one at 1, PEFRL at 2.15, Yoshida 4 at 2.34, RK4 at 2.79, Yoshida 6 at 3.1, Kahan and Li at 4.8.
load 'plots/style.gp'
load 'plots/methods.gp'
file = 'build/data/08-friction.dat'
set xrange [0:6]
set yrange [0:1.6]
set xlabel '{/:Italic c dt}'
set ylabel 'factor of a velocity, a step' offset 1
eval edges(0.09, 0.755, 0.16, 0.97)
set key at screen 0.99,0.97 right top samplen 3 Left reverse
plot exp(-x) ls 9 lw 4*thick title 'truth', 1 ls 9, \
     for [m in columns(file, '!euler !symplectic-euler leapfrog rk4')] \
     file using 1:column_of(file, m) with lines ls style_of(m) title name_of(m)
