# data: build/data/03-sampling.dat
# command: f=$(mktemp); build/bin/bonkers --preset thermal --every 0.24 --until 96000 -o - | awk '!/^#/ { print $22 }' >$f; for n in 1 2 4 8 16 32 64 128 256 512; do awk -v n=$n '(NR - 1) % n == 0' $f | build/bin/histogram --skip 1 --block --column 1 --table columns -; done > build/data/03-sampling.dat && rm $f
# data: build/data/03-blocks.dat
# command: build/bin/bonkers --preset thermal --every 1 --samples 1000000 -o - | build/bin/histogram --skip 1 --block --column v9,v4 --table blocks -o build/data/03-blocks.dat -
# data: plots/data/03-cost.dat
# alt: Left: relative error of a mean kinetic energy against the number of samples from one run of fixed length, on logarithmic axes: the honest error falls until some twenty thousand samples and then stays level; the naive one goes on falling. Right: three estimates of an error over the true one against their cost: naive at a quarter, blocks near one, the sum of correlations below one and the most expensive.
height = 6.3
load 'plots/style.gp'
file = 'build/data/03-sampling.dat'
cost = 'plots/data/03-cost.dat'
T = 96000.
# What a run of 10^6 s, a sample each second, says of the ball 9: how many
# independent samples its energies are worth, and the naive error of their mean.
blocks = 'build/data/03-blocks.dat'
worth = real(system("awk '/ samples worth / { print $5; exit }' ".blocks))
stats blocks index 0 using 5 every ::0::0 nooutput
naive = STATS_min
tau = 1e6/worth/2
kappa = 2.5
coth(x) = 1/tanh(x)
set multiplot layout 1,2 margins 0.105,0.98,0.175,0.97 spacing 0.13,0
set logscale xy
set format x '10^{%T}'
set format y '%g'
set xrange [500:6e5]
set yrange [0.0015:0.06]
set ytics (0.002, 0.005, 0.01, 0.02, 0.05)
set xlabel 'samples'
set ylabel 'relative error of the kinetic energy' offset 0.5
set key at graph 0.98,0.98 right top samplen 1.2 spacing 1.1
plot sqrt((kappa-1)/x*coth(T/x/2/tau)) ls 9 lw 1.5*thick title 'law', \
     file using 2:(2*$6/$5):(2*$6/$5/sqrt(2*$2/$10)) with yerrorbars ls 1 title 'honest', \
     file using 2:(sqrt(($7-1)/$2)) with points ls 2 pt 4 title 'naive'
set xrange [1:100]
set yrange [0.1:2]
set xtics (1, 3, 10, 30, 100)
set ytics (0.1, 0.2, 0.5, 1, 2)
set format x '%g'
set xlabel 'processor time (ns a sample)'
set ylabel 'error found / true error'
# the error in a run of 10^6 s, for 96000 s
true = naive*sqrt(1e6/worth)*sqrt(1e6/T)
plot 1 ls 9, for [k=0:2] cost using 4:($2/true):($3/true) every ::k::k with yerrorbars ls k+1 ps 0.9*big, \
     cost using 4:($2/true):1 with labels offset 0,-1.2
