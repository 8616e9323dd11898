# data: build/data/06-steps.dat
# command: build/bin/sample-studies --study memory --step 0.025,0.035,0.05,0.07,0.1,0.14,0.2,0.28,0.4,0.57,0.8 --samples 1000000 -o build/data/06-steps.dat
# lecture: build/bin/sample-studies --study memory --step 0.025,0.035,0.05,0.07,0.1,0.14,0.2,0.28,0.4,0.57,0.8 --samples 10000000 -o build/data/06-steps.dat
# alt: Inefficiency in sweeps against the longest step, both logarithmic. That of the place of one disk falls from 5000 at a step of 0.025 to 120 at 0.57. That of the share at the walls has its least value, 8, at 0.14 and rises to 60 at either end. The acceptance, written above, falls from 87 to 4 per cent.
load 'plots/style.gp'
file = 'build/data/06-steps.dat'
eval edges(0.105, 0.985, 0.16, 0.85)
set label 1 'share of tries that succeed:' at graph 0,1.16 left
do for [k=0:5] {
    stats file every ::2*k::2*k using (X = $2):(A = sprintf('%.0f %%', 100*$3), 0) nooutput
    set label k+2 A at first X,graph 1.06 center
}
set logscale xy
set xrange [0.022:0.9]
set xtics (0.025,0.05,0.1,0.2,0.4,0.8)
set yrange [4:10000]
set xlabel 'longest step δ  (m)'
set ylabel 'inefficiency {/:Italic g}  (sweeps)' offset 1
set key at graph 0.98,0.96 right top samplen 1
plot file using 2:4 with linespoints ls 1 lw 1*thick title 'place of one disk', \
     file using 2:5 with linespoints ls 2 lw 1*thick title 'share at the walls'
