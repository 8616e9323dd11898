# data: build/data/12-two.dat
# command: for e in 0.1 0.05 0.02 0.01 0.005 0.002 0.001 0.0005 0.0002 0.0001 0.00005 0.00002 0.00001; do build/bin/bonk0 $e; done > build/data/12-two.dat
# alt: Cost of the run that is taken against the tolerance, both logarithmic. From a tenth to a twentieth it is that of the ellipses, seven microseconds; below it is leapfrog's, which begins ten times higher and rises by a factor of ten for each hundredth of the tolerance. What all runs cost together lies above, between a millisecond and a tenth of a second.
load 'plots/style.gp'
load 'plots/methods.gp'
eval powers
set xrange [0.2:5e-6]
set yrange [2e-6:0.3]
set xlabel 'tolerance  (fraction of the scale)'
set ylabel 'cost  (s by the price list)' offset 1
set key at graph 0.02,0.97 left top Left reverse samplen 2
file = 'build/data/12-two.dat'
taken(m) = sprintf("< awk '/holds/ { t[$1] = $0 } END { for (e in t) print t[e] }' %s | grep %s | sort -g", file, m)
plot "< awk '{ s[$1] += $4 } END { for (e in s) print e, s[e] }' ".file." | sort -g" using 1:($2*1e-9) \
     with linespoints ls 9 pt 4 title 'all that is run', \
     taken('leapfrog') using 1:($4*1e-9) with linespoints ls style_of('leapfrog') title 'taken: leapfrog', \
     taken('ellipses') using 1:($4*1e-9) with linespoints pt 7 ps 0.9*big lc rgb dark lw thick title 'taken: ellipses'
