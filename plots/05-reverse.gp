# data: build/data/05-reverse.dat
# command: build/bin/disks-studies --study reverse -o build/data/05-reverse.dat
# lecture: build/bin/disks-studies --study reverse --starts 1001 -o build/data/05-reverse.dat
# alt: Median miss of the start against the time there, logarithmic upwards. The points for both energies lie on a straight line, from ten to the minus 15 at one second to ten to the minus 4 at eight.
load 'plots/style.gp'
file = 'build/data/05-reverse.dat'
# The slope from the third point to the last but one, as the text has it.
stats file using 1:(log($3)) every ::2::2 nooutput
t3 = STATS_min_x; miss3 = STATS_min_y
stats file using 1:(log($3)) every ::14::14 nooutput
rise = STATS_min_y - miss3
rate = rise/(STATS_min_x - t3)
set logscale y
set format y '10^{%T}'
set xrange [0:8.4]
set yrange [1e-16:1e-2]
set ytics 100
set xlabel 'time there, and as long back  (s)'
set ylabel 'miss of the start  (m)' offset 0.5
eval edges(0.11, 0.985, 0.17, 0.97)
set key at graph 0.03,0.96 left top reverse Left samplen 1.5
set label 1 sprintf('{/:Italic e}^{ %.1f {/:Italic t}}', rate) at 5.5,4e-10 left tc rgb '#555555'
plot exp(miss3 + rate*(x - t3)) ls 9 lw 1.5*thick, \
     file using 1:3 with points ls 1 ps 0.9*big title '{/:Italic E} = 1 J', \
     file using 1:4 with points pt 4 ps 0.9*big lw 1.5*thick lc rgb red title '{/:Italic E} = 4 J, twice the time'
