# data: build/data/02-islands.dat
# command: build/bin/bonkers-studies --study islands --until 0.8 -o build/data/02-islands.dat
# alt: Sixty upright lines, one for each body, time upwards. Each collision is a short level bar that joins two neighbours. The bars stand in nine groups of one to five, and each group has a shaded strip of its own; between two strips there is always at least one line that no bar touches.
height = 6.4
load 'plots/style.gp'
file = 'build/data/02-islands.dat'
stats file index 1 using 3 nooutput
islands = int(STATS_max)
do for [k=1:islands] {
    stats file index 1 using ($3 == k ? $4 : NaN) nooutput
    set object k rectangle from STATS_min-0.35,0 to STATS_max+1.35,0.8 fc rgb k%2 ? '#cfe3f1' : '#f7d9c4' fs solid noborder behind
}
set xlabel 'body'
set ylabel 'time {/:Italic t} (s)' offset 0.8
set xrange [-0.8:61.8]
set yrange [0:0.8]
set border 3
set xtics nomirror
set ytics nomirror
eval edges(0.085, 0.985, 0.185, 0.97)
do for [k=0:61] { set arrow 100+k from k,0 to k,0.8 nohead lc rgb grey lw (k%61 ? 0.8 : 4)*thick back }
plot file index 1 using 4:2:(1):(0) with vectors nohead lw 2.6*thick lc rgb dark
