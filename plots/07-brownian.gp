# data: build/data/07-brownian.dat
# command: build/bin/disks --disks 400 --radius 0.5 --heavy 40,2 --start random --temperature 1 --box 39.79149,39.79149 --boundary periodic --warmup 20 --measure brownian --every 0.1 --until 6000 -o build/data/07-brownian.dat
# lecture: build/bin/disks --disks 400 --radius 0.5 --heavy 40,2 --start random --temperature 1 --box 39.79149,39.79149 --boundary periodic --warmup 20 --measure brownian --every 0.1 --until 20000 -o build/data/07-brownian.dat
# data: build/runs/gas-heavy.summary
# command: build/bin/disks --disks 400 --radius 0.5 --heavy 40,2 --start random --temperature 1 --box 39.79149,39.79149 --boundary periodic --warmup 20 --measure brownian --every 0.1 --until 6000 -o /dev/null --summary build/runs/gas-heavy.summary
# alt: Left, the correlation of the velocity on a logarithmic scale falls from 0.023 along the dashed initial slope and then lies above the exponential. Right, the mean square displacement on logarithmic scales: free flight with slope 2 up to a second, then bending to slope 1; the points end a little above the line.
height = 7.2
load 'plots/style.gp'
file = 'build/data/07-brownian.dat'
C0 = result('gas-heavy', 'V2_exact')
slope = result('gas-heavy', 'slope_exact')
g = slope/C0
set multiplot layout 1,2 margins 0.115,0.985,0.17,0.97 spacing 0.125,0
set logscale y
set xlabel 'lag {/:Italic t}  (s)'
set ylabel '{/:Italic C}  (m^2/s^2)' offset 0.5
set ytics (0.001, 0.002, 0.005, 0.01, 0.02)
set xrange [0:25]
set yrange [8e-4:0.03]
plot C0*exp(-g*x) ls 9 lw 1.5*thick, \
     [0:7] C0-slope*x ls 9 dt 2 lw 1.5*thick, \
     file using 1:2:3 with yerrorbars ls 1 ps 0.4*big
set logscale x
set ytics autofreq
set format '10^{%T}'
set ylabel 'mean square displacement (m^2)' offset 0.5
set xrange [0.08:200]
set yrange [1e-4:300]
plot 2*C0*x**2 ls 9 dt 2 lw 1.5*thick, \
     4*C0/g**2*(g*x-1+exp(-g*x)) ls 9 lw 1.5*thick, \
     file using 1:($1 > 0 ? $4 : NaN):5 with yerrorbars ls 1 ps 0.4*big
