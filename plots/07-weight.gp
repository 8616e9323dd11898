# data: build/data/07-weight-4.dat
# command: build/bin/disks --disks 4 --radius 0.01 --box 1,0.5 --start random --seed 2 --warmup 0 --until 0 -o build/data/07-low-4.dat && build/bin/disks --start build/data/07-low-4.dat --box 1,2.5 --gravity 2 --every 0.5 --until 200000 --measure positions -o build/data/07-weight-4.dat
# data: build/data/07-weight-40.dat
# command: build/bin/disks --disks 40 --radius 0.002 --box 1,0.5 --start random --warmup 0 --until 0 -o build/data/07-low-40.dat && build/bin/disks --start build/data/07-low-40.dat --box 1,2.5 --gravity 2 --every 0.5 --until 6000 --measure positions -o build/data/07-weight-40.dat
# lecture: build/bin/disks --disks 40 --radius 0.002 --box 1,0.5 --start random --warmup 0 --until 0 -o build/data/07-low-40.dat && build/bin/disks --start build/data/07-low-40.dat --box 1,2.5 --gravity 2 --every 0.5 --until 24000 --measure positions -o build/data/07-weight-40.dat
# alt: Left, the density of the heights of four disks on a logarithmic scale: points with error bars on a curve that begins below the straight dashed line of the exponential, rises above it between one and three mean heights and falls off steeply behind five. Right, the deviation from the exponential in per cent: for four disks from minus 12 on the floor to plus 14 at two mean heights and down to minus 35 at four, for forty disks within four per cent; points on lines.
height = 7.5
load 'plots/style.gp'
H = 2.5 # the box, m
g = option('build/data/07-weight-4.dat', 'gravity') + 0.0
stats 'build/data/07-low-4.dat' index 0 using (($7**2+$8**2)/2+g*($6-0.01)) nooutput
few = STATS_sum/8 # kT, J
stats 'build/data/07-low-40.dat' index 0 using (($7**2+$8**2)/2+g*($6-0.002)) nooutput
many = STATS_sum/80
u(k,r,kT) = (k*H+H/200-r)*g/kT # the middle of a bin, in kT/mg
p(u,N) = u < 2*N ? (2*N-1.)/(2*N)*(1-u/(2*N))**(2*N-2) : NaN
set multiplot layout 1,2 margins 0.085,0.985,0.18,0.97 spacing 0.125,0
set samples 400
set xlabel 'height, in {/:Italic kT/mg}'
set ylabel 'density' offset 1
set xrange [0:6.4]
set yrange [0.0003:1.3]
set logscale y
set format y '10^{%T}'
set key top right samplen 1.5
plot p(x,4) ls 9 lw 1.6*thick, \
     exp(-x) dt 2 lc rgb dark lw 1.4*thick title 'exponential', \
     'build/data/07-weight-4.dat' every 2::1 using (u($1,0.01,few)):($4*few/g):($5*few/g) with yerrorbars ls 2 title '4 disks'
unset logscale y
set format y '%h'
set ylabel 'per cent above the exponential' offset 0.5
set xrange [0:4.2]
set yrange [-36:22]
set ytics 10
set key at graph 0.03,0.05 left bottom Left reverse samplen 1
above(f,u) = 100*(f*exp(u)-1)
plot 0 dt 2 lc rgb dark lw 1.4*thick, \
     above(p(x,4),x) ls 9 lw 1.4*thick, above(p(x,40),x) ls 9 lw 1.4*thick, \
     'build/data/07-weight-4.dat' every 2::1 using (t=u($1,0.01,few)):(above($4*few/g,t)):(100*$5*few/g*exp(t)) with yerrorbars ls 2 title '4 disks', \
     'build/data/07-weight-40.dat' every 4::1 using (t=u($1,0.002,many)):(above($4*many/g,t)):(100*$5*many/g*exp(t)) with yerrorbars ls 1 title '40 disks'
