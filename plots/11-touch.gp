# data: build/data/11-touch.dat
# command: build/bin/spheres-studies --study touch -o build/data/11-touch.dat
# alt: Three panels with the velocities of five balls against time, Linear springs, touching: the velocity of the first falls to minus 0.13, those of the next three rise one after the other to about 0.7 and fall, and the last rises to 0.94, the last but one keeps 0.3. Hertz's springs, touching: similar humps, but the last ball ends at 0.99 and the others near zero. Linear springs with gaps: each ball in turn takes the whole velocity, 1, and gives it to the next; the last keeps it.
height = 6.2
load 'plots/style.gp'
set style line 11 lc rgb dark lw 2*thick
set style line 12 lc rgb blue lw 1.4*thick dt 2
set style line 13 lc rgb green lw 1.4*thick dt 3
set style line 14 lc rgb purple lw 1.4*thick dt 4
set style line 15 lc rgb red lw 2*thick
file = 'build/data/11-touch.dat'
set multiplot layout 1,3 margins 0.095,0.985,0.18,0.89 spacing 0.025,0
set yrange [-0.2:1.12]
set xlabel 'time  (s)'
set ylabel 'velocity  (m/s)' offset 0.4
set xrange [0:0.14]
set xtics 0.05
set title 'linear springs, touching' offset 0,-0.6
plot for [b=1:5] file index 0 using 1:(column(b + 1)) with lines ls (10 + b)
set format y ''
set ylabel ''
set title 'Hertz’s springs, touching' offset 0,-0.6
plot for [b=1:5] file index 1 using 1:(column(b + 1)) with lines ls (10 + b)
set xrange [0:0.28]
set xtics 0.1
set key at graph 0.99,0.5 right center samplen 1.2 spacing 0.9
set title 'linear springs, with gaps' offset 0,-0.6
plot for [b=1:5] file index 2 using 1:(column(b + 1)) with lines ls (10 + b) title sprintf('%d', b)
