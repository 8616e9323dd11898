# data: build/data/12-patience.dat
# command: build/bin/averages-studies --study patience -o build/data/12-patience.dat
# alt: Mean place of a heavy piston against the time of the run, on a logarithmic axis. Up to 4000 s it stays close to 5 m, the place that two springs give (lower line); then it climbs, to 5.8 m at 131000 s, towards the 6 m of the law of places. Answers with error bars only at 256, 2048 and 4096 s.
width = 12
height = 7
load 'plots/style.gp'
set logscale x 2
set xrange [180:190000]
set xtics ('256' 256, '1024' 1024, '4096' 4096, '16384' 16384, '65536' 65536)
set yrange [4.7:6.15]
set xlabel 'time {/:Italic T}  (s)'
set ylabel 'mean place of the piston  (m)'
set key left top at graph 0.03,0.88 samplen 1.5 Left reverse
set label 1 'law of places' at 200,6.085 left
set label 2 'two springs' at 150000,4.82 right
plot 6 ls 9 lw 2*thick, 'build/data/12-patience.dat' using 1:6 with lines ls 9 lw 2*thick, \
     '' using 1:2 with linespoints ls 1 title 'events, to {/:Italic T}', \
     '' using 1:($5 > 0 ? $3 : 1/0):4 with yerrorbars ls 2 title 'answers'
