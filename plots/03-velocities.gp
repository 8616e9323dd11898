# data: build/data/03-few.dat
# command: build/bin/bonkers --preset thermal --every 1 --samples 1 | awk -f plots/beads.awk | build/bin/bonkers0 0.24 400 - | build/bin/histogram --skip 1 --column 10,20 --range=-3.2,3.2 --range=-1.52,1.52 --bins 16 -o build/data/03-few.dat -
# data: build/data/03-velocities.dat
# command: build/bin/bonkers --preset thermal --every 1 --samples 1 | awk -f plots/beads.awk | build/bin/bonkers0 2.4 1000000 - | sed 1d | build/bin/histogram0 32 10 -3.2 3.2 20 -1.52 1.52 > build/data/03-velocities.dat
# data: build/data/03-states.dat
# command: build/bin/bonkers --preset thermal --every 10 --samples 2000 -o build/data/03-states.dat
# alt: Two histograms of velocities, of the lightest and of the heaviest of ten balls. Four hundred samples scatter far from the law, with a hole in the middle for the light ball and a narrow peak for the heavy one; a million samples lie on the bell-shaped law.
load 'plots/style.gp'
few = 'build/data/03-few.dat'
many = 'build/data/03-velocities.dat'
# mass of movers 4 and 9, E = 5 J, n = 10
states = 'build/data/03-states.dat'
array m[2] = [mass(states, 4), mass(states, 9)]
top(k) = gamma(5.)/sqrt(pi)/gamma(4.5)*sqrt(m[k]/10)
p(v,k) = (v**2*m[k]/10 < 1) ? top(k)*(1-v**2*m[k]/10)**3.5 : 0
set samples 400
set multiplot layout 1,2 margins 0.085,0.985,0.18,0.97 spacing 0.105,0
set xlabel '{/:Italic v}_4  (m/s)'
set ylabel 'density  (s/m)' offset 1.5
set yrange [0:0.56]
set ytics 0.2
set xrange [-3.3:3.3]
set key at graph 0.98,0.98 right top samplen 1.2 spacing 1.1
set label 1 sprintf('%.2f kg', m[1]) at graph 0.04,0.93 left tc rgb '#333333'
plot p(x,1) ls 9 lw 1.6*thick title 'law', \
     few index 0 using 1:3:4 with yerrorbars ls 2 pt 4 ps 0.7*big lw 1*thick title '400', \
     many index 0 using 1:2:3 with yerrorbars ls 1 ps 0.45*big title '10^6'
set xlabel '{/:Italic v}_9  (m/s)'
set label 1 sprintf('%.2f kg', m[2])
unset ylabel
set yrange [0:1.7]
set ytics 0.5
set xrange [-1.6:1.6]
plot p(x,2) ls 9 lw 1.6*thick, \
     few index 1 using 1:3:4 with yerrorbars ls 2 pt 4 ps 0.7*big lw 1*thick, \
     many index 1 using 1:2:3 with yerrorbars ls 1 ps 0.45*big
