# data: build/data/09-jacobi.dat
# command: build/bin/gravity-studies --study ellipses -o build/data/09-jacobi.dat
# alt: Two panels with logarithmic axes, the largest error of the energy of eight planets in a century. Left, against the days from kick to kick, a quarter to sixteen: leapfrog rises from 1e-7 to 1e-4; Kahan and Li's method is below 1e-10 at a quarter of a day and useless beyond one; Wisdom and Holman's runs parallel to leapfrog, twenty thousand times lower; SBAB4 lies at 1e-13, the level of rounding, up to two days, and then rises steeply. Right, against a factor on the planets' masses from 0.01 to 10: leapfrog is level, Wisdom and Holman's rises in proportion, and SBAB4 from rounding as the square.
height = 7.5
load 'plots/style.gp'
file = 'build/data/09-jacobi.dat'
load 'plots/methods.gp'
set multiplot layout 1,2 margins 0.1,0.98,0.15,0.97 spacing 0.12,0
set logscale xy
eval decades
set format y '10^{%T}'
set xlabel 'days from kick to kick'
set ylabel 'largest error of the energy' offset 0.8
set xrange [0.2:20]
set yrange [1e-14:1]
set label 1 name_of('kahan-li8') at 1.4,0.15 right
list = 'leapfrog kahan-li8 wisdom-holman sbab4'
plot for [i=1:4] file index i-1 using 1:3 with linespoints \
     ls style_of(word(list, i))
unset ylabel
unset label 1
set label 2 name_of('leapfrog') at 0.01,5e-5
set label 3 name_of('wisdom-holman') at 0.01,5e-10
set label 4 name_of('sbab4') at 0.01,2e-13
set xlabel 'factor on the masses of the planets'
set xrange [0.007:14]
set format x '10^{%T}'
plot for [i=1:4] file index i+3 using (i == 2 ? NaN : $2):3 with linespoints \
     ls style_of(word(list, i))
