# data: build/data/03-three.dat
# command: build/bin/bonkers --masses 1,1.618,2.414 --positions 1,2,3 --velocities 1.7320508,0,0 --walls 0,4 --every 5 --samples 200000 -o - | build/bin/histogram --skip 1 --block --column v1 --range=-1.7320508,1.7320508 --bins 14 --law microcanonical:3,1.5,1 -o build/data/03-three.dat -
# data: build/data/03-four.dat
# command: build/bin/bonkers --masses 1,1.618,2.414,3.303 --positions 1,2,3,4 --velocities 2,0,0,0 --walls 0,5 --every 5 --samples 200000 -o - | build/bin/histogram --skip 1 --block --column v1 --range=-2,2 --bins 16 --law microcanonical:4,2,1 -o build/data/03-four.dat -
# data: build/data/03-many.dat
# command: build/bin/bonkers --preset thermal --every 2.4 --samples 1000000 -o - | build/bin/histogram --skip 1 --block --column v4,v9,x1,x2,x5,x9,x10 --range=-3.2,3.2 --range=-1.52,1.52 --range 0,11 --range 0,11 --range 0,11 --range 0,11 --range 0,11 --bins 32 --law microcanonical:10,5,0.978265720408381 --law microcanonical:10,5,4.2937219878148802 --law beta:1,10,0,11 --law beta:2,10,0,11 --law beta:5,10,0,11 --law beta:9,10,0,11 --law beta:10,10,0,11 -o build/data/03-many.dat -
# data: build/data/03-states.dat
# command: build/bin/bonkers --preset thermal --every 10 --samples 2000 -o build/data/03-states.dat
# alt: Left: densities of a velocity in units of its standard deviation: flat for three balls, a half circle for four, a bell for ten, each with points on its line. Right: the law for ten balls on a logarithmic scale, with points on it, ends at 3.16 standard deviations; the Gaussian goes on.
load 'plots/style.gp'
three = 'build/data/03-three.dat'
four = 'build/data/03-four.dat'
many = 'build/data/03-many.dat'
# z = u sqrt(n) has standard deviation 1
p(z,n) = z**2 < n ? gamma(n/2.)/sqrt(pi*n)/gamma((n-1)/2.)*(1-z**2/n)**((n-3)/2.) : NaN
sd = sqrt(1/mass('build/data/03-states.dat', 4))
set samples 801
set multiplot layout 1,2 margins 0.085,0.985,0.18,0.97 spacing 0.115,0
set xlabel 'velocity / standard deviation'
set ylabel 'density' offset 1.5
set yrange [0:0.52]
set xrange [-3.4:3.4]
set ytics 0.1
set key at graph 0.02,0.98 left top reverse Left samplen 1.2 spacing 1.1
plot p(x,3) ls 9, p(x,4) ls 9, p(x,10) ls 9, \
     three using 1:3:4 with yerrorbars ls 1 title '{/:Italic N} = 3', \
     four using 1:3:4 with yerrorbars ls 2 title '4', \
     many index 0 using ($1/sd):($3*sd):($4*sd) with yerrorbars ls 3 title '10'
set logscale y
set yrange [1e-6:1]
set xrange [0:4]
set xtics 1
set format y '10^{%T}'
set ytics auto
unset ylabel
set label 1 'canonical' at 2.95,2e-2 left tc rgb red
set label 2 '{/:Italic N} = 10' at 2.8,3e-5 right tc rgb '#555555'
plot exp(-x**2/2)/sqrt(2*pi) lc rgb red dt 2 lw 1.3*thick, \
     many index 0 using ($1 > 0 ? $1/sd : NaN):($5*sd) with histeps ls 9 lw 1.4*thick, \
     many index 0 using ($1 > 0 ? $1/sd : NaN):($2 > 0 ? $3*sd : NaN):($4*sd) with yerrorbars ls 3
