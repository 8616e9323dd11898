# data: build/data/10-spin.dat
# command: build/bin/springs-studies --study spin -o build/data/10-spin.dat
# alt: Two panels over five seconds. Left, angular momentum of a spinning dumbbell on a logarithmic axis: constant with the axial dashpot, a straight line down to seven thousandths of the start with the printed one. Right, energy: with the axial dashpot it oscillates down to a plateau of about 1.2 joules, the rotation that is left; with the printed one it goes to zero.
height = 6.5
load 'plots/style.gp'
set multiplot layout 1,2 margins 0.1,0.985,0.17,0.97 spacing 0.11,0
file = 'build/data/10-spin.dat'
stats file using 3 every ::0::0 nooutput
start = STATS_min
set xlabel 'time  (s)'
set xrange [0:5]
set logscale y
set yrange [5e-3:2]
set ylabel 'angular momentum  (kg m^2/s)' offset 1
set key at graph 0.03,0.05 left bottom samplen 1.5
plot start*exp(-x) ls 9, start ls 9, \
     file every 4 using 1:2 with points ls 2 title 'dashpot as printed', \
     '' every 4 using 1:3 with points ls 1 title 'along the axis'
unset logscale
set yrange [0:1.7]
set ylabel 'energy  (J)' offset 1
set key at graph 0.97,0.5 right center
plot file using 1:4 with lines ls 2 title 'as printed', \
     '' using 1:5 with lines ls 1 title 'along the axis'
