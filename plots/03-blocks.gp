# data: build/data/03-blocks.dat
# command: build/bin/bonkers --preset thermal --every 1 --samples 1000000 -o - | build/bin/histogram --skip 1 --block --column v9,v4 --table blocks -o build/data/03-blocks.dat -
# alt: Error of a mean, in units of the naive error, against block length on logarithmic axes. For the kinetic energies it rises from one to about two, faster at first than later, and levels off at blocks of some hundred seconds, with error bars that grow to the right; for the velocity of the heaviest ball it falls below one half. A line for exponential correlations levels off earlier.
height = 7.5
load 'plots/style.gp'
file = 'build/data/03-blocks.dat'
stats file index 0 using 3 every ::0::0 nooutput
naive = STATS_min
stats file index 0 using 5 every ::0::0 nooutput
naive9 = STATS_min
stats file index 1 using 5 every ::0::0 nooutput
naive4 = STATS_min
# The plateau, from a thousand seconds on: the mean by the weights of the errors.
stats file index 0 using ($1 > 1000 ? 1/$6**2 : NaN) nooutput
weight = STATS_sum
stats file index 0 using ($1 > 1000 ? $5/$6**2 : NaN) nooutput
plateau = (STATS_sum/weight/naive9)**2
# exponential correlations of inefficiency g seen through blocks of length b
phi(g) = (g-1)/(g+1)
seen(b,g) = sqrt(g-(g**2-1)/(2*b)*(1-phi(g)**b))
set logscale x
set xrange [0.8:4e4]
set yrange [0:3]
set format x '10^{%T}'
set xlabel 'block length  (s)'
set ylabel 'error / naive error' offset 1
set key at graph 0.02,0.97 left top reverse Left samplen 1.2 spacing 1.1
eval edges(0.085, 0.985, 0.165, 0.97)
plot seen(x,plateau) ls 9 lw 1.4*thick title sprintf('exponential, {/:Italic g} = %.1f', plateau), \
     file index 0 using 1:($5/naive9):($2 > 15 ? $6/naive9 : NaN) with yerrorbars ls 1 title 'kinetic energy of 9', \
     file index 1 using 1:($5/naive4):($2 > 15 ? $6/naive4 : NaN) with yerrorbars ls 2 title 'kinetic energy of 4', \
     file index 0 using 1:($3/naive):($2 > 15 ? $4/naive : NaN) with yerrorbars ls 3 title 'velocity of 9'
