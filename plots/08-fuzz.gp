# data: plots/data/08-fuzz.dat
# alt: Against the number of texts on a logarithmic axis, 1 to ten million: branches that the reader has taken rise from 200 to 300 within ten thousand texts and to 346 at the end; texts that were kept rise from 3 to 330, most of them after the first thousand.
height = 6.5
load 'plots/style.gp'
set lmargin at screen 0.1
set rmargin at screen 0.985
set logscale x
set format x '10^{%T}'
set xlabel 'texts tried'
set ylabel 'number' offset 1
set xrange [1:2e7]
set yrange [0:380]
set key left top
plot 'plots/data/08-fuzz.dat' using 1:2 with steps ls 1 title 'branches taken', \
     'plots/data/08-fuzz.dat' using 1:3 with steps ls 2 title 'texts kept'
