# data: build/data/06-thrown.dat
# command: build/bin/throw0 1e6 > build/data/06-thrown.dat
# lecture: build/bin/throw0 1e7 > build/data/06-thrown.dat
# data: build/data/06-markov.dat
# command: build/bin/sample --method markov --samples 1e6 -o build/data/06-markov.dat
# lecture: build/bin/sample --method markov --samples 1e7 -o build/data/06-markov.dat
# data: build/data/06-flying.dat
# command: build/bin/disks0 0.01 1000000 | awk -v columns=2,4,6,8 -v bins=100 -v high=1 -v block=10000 -f plots/density.awk > build/data/06-flying.dat
# lecture: build/bin/disks0 0.01 10000000 | awk -v columns=2,4,6,8 -v bins=100 -v high=1 -v block=100000 -f plots/density.awk > build/data/06-flying.dat
# data: plots/data/06-reference.dat
# alt: Above, density of a coordinate of four disks in a box: highest at both walls, 2.7, falling to 0.97 with a small hump of 1.1 in the middle. Points of three methods lie on one curve. Below, their deviations from the reference in units of their errors scatter between minus 3 and 3.
height = 9.5
load 'plots/style.gp'
reference = 'plots/data/06-reference.dat'
array P[100]
do for [i=1:100] { P[i] = NaN }
stats reference using (P[int($1*100+0.5)+1] = $2, $2) nooutput
data = 'build/data/06-thrown.dat build/data/06-markov.dat build/data/06-flying.dat'
array title[3]
title[1] = 'direct sampling'
title[2] = 'Markov chain'
title[3] = 'molecular dynamics'
set multiplot
set lmargin at screen 0.085
set rmargin at screen 0.985
set xrange [0:1]
set format x ''
set ylabel 'density {/:Italic p}  (1/m)' offset 1
set yrange [0:2.9]
set tmargin at screen 0.98
set bmargin at screen 0.47
set key at graph 0.5,0.96 center top samplen 1 opaque noautotitle
plot reference using ($1+0.005):2 with lines ls 9 lw 2*thick, \
     for [k=1:3] word(data,k) every 3::14+k::84 using ($1+0.005):2:3 with yerrorbars ls k title title[k]
unset key
set format x '%g'
set xlabel 'position {/:Italic x}  (m)'
set ylabel 'deviation / error' offset 0.2
set yrange [-4:4]
set ytics 2
set grid y
set tmargin at screen 0.43
set bmargin at screen lecture ? 0.15 : 0.13
inside(i) = i >= 15 && i < 85
plot for [k=1:3] word(data,k) using ($1+0.002+0.003*(k-1)):(inside($0) ? ($2-P[int($0)+1])/$3 : NaN) with points ls k ps 0.4*big
