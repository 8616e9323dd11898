# data: build/data/08-fails.dat
# command: build/bin/step-studies --study fails -o build/data/08-fails.dat
# alt: Three panels, size against the number of steps, logarithmic. Left: leapfrog wavers about one, Yoshida 4 rises on a straight line to ten to the thirty-fourth. Middle: RK4 falls on a straight line to ten to the minus eighteen. Right: under friction RK4 falls slowly, leapfrog rises slowly, Yoshida 4 a little faster.
height = 6.5
load 'plots/style.gp'
load 'plots/methods.gp'
file = 'build/data/08-fails.dat'
set multiplot layout 1,3 margins 0.095,0.985,0.17,0.96 spacing 0.09,0
set format y '10^{%g}'
set xrange [0:60]
set xtics 20
set xlabel 'steps'
set ylabel 'size' offset 1
set yrange [-2:42]
set ytics 10
set key at graph 0.97,0.97 right top samplen 1
plot 0 ls 9 lw 1.5*thick, \
     file using 1:(log10($3)) with points ls style_of('yoshida4') title name_of('yoshida4'), \
     file using 1:(log10($2)) with points ls style_of('leapfrog') title name_of('leapfrog')
set ylabel ''
set yrange [-20:2]
set ytics 5
plot x/2*log10(1-2.5**6/72+2.5**8/576) ls 9 lw 1.5*thick, file using 1:(log10($4)) with points ls style_of('rk4') title name_of('rk4').', 2.5'
set yrange [-14:17]
set ytics 5
plot 0 ls 9, \
     file using 1:(log10($6)) with points ls style_of('yoshida4') title name_of('yoshida4').', 2.5', \
     file using 1:(log10($7)) with points ls style_of('leapfrog') title name_of('leapfrog').', 1.2', \
     file using 1:(log10($5)) with points ls style_of('rk4') title name_of('rk4').', 2.5'
