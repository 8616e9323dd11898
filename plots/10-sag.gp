# data: build/data/10-sag.dat
# command: build/bin/springs-studies --study sag -o build/data/10-sag.dat
# alt: Height of the middle of a membrane over sixty seconds after gravity and friction have ended: it starts at minus 0.44 metres and oscillates with a period of seven seconds, almost regularly, together with the amplitude of the mode (1, 1); all other modes together stay between two and eight centimetres.
height = 6
load 'plots/style.gp'
eval edges(0.085, 0.985, 0.19, 0.97)
set xlabel 'time since gravity and friction ended  (s)'
set ylabel 'displacement  (m)' offset 1
set xrange [0:60]
set yrange [-0.55:0.72]
set xzeroaxis ls 9
set key at graph 0.99,0.97 right top horizontal samplen 1.5
plot 'build/data/10-sag.dat' using 1:2 with lines ls 1 title 'middle', \
     '' using 1:3 with lines ls 3 title 'mode (1, 1)', '' using 1:4 with lines ls 2 title 'all other modes'
