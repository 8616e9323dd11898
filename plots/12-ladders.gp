# data: build/data/12-ladders.dat
# command: build/bin/scene solar-system | build/bin/bonk - --until 3650 --tolerance 1e-3 --chart build/data/12-ladders.dat -o /dev/null
# alt: Error against cost for the solar system over ten years, both logarithmic. Methods with steps are ladders of points, most of which fall to the right, the steeper the higher their order; with the tolerance of one thousandth as a line across. Eight ellipses that leave out what the planets do to each other stand as one point below the line, more than ten times to the left of where the first ladder crosses it, and are taken.
width = 14
height = 8
load 'plots/style.gp'
load 'plots/methods.gp'
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set xlabel 'cost  (s by the price list)'
set ylabel 'error  (share of the scale)' offset 1
set xrange [1e-5:0.1]
set yrange [1e-5:10]
set lmargin at screen 0.115
set bmargin at screen 0.145
set tmargin at screen 0.97
set rmargin at screen 0.965
set key at graph 0.985,0.97 right Right spacing 1.1 samplen 2
file = 'build/data/12-ladders.dat'
ladder(name) = sprintf("< awk '!/^#/ && $4 ~ /^%s:[0-9]*$/ && $3 == 0' %s", name, file)
set label 1 'tolerance' at 1.3e-5,1.45e-3 tc rgb '#555555'
set label 2 'kepler, no-light' at 5.2e-5,3.6e-4
plot 1e-3 ls 9, \
     for [m in 'leapfrog rk4 yoshida4 pefrl kahan-li8 gauss4'] ladder(m) using 2:1 \
     with linespoints ls style_of(m) title m, \
     "< awk '!/^#/ && $3 == 1' ".file using 2:1 with points pt 3 ps 1.6*big lw 2*thick lc rgb dark
