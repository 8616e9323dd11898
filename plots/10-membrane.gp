# data: build/data/10-membranes.dat
# command: build/bin/springs-studies --study membranes -o build/data/10-membranes.dat
# data: build/data/10-quartic.dat
# command: build/bin/springs-studies --study quartic -o build/data/10-quartic.dat
# alt: Three panels. Top left, taut membrane: the amplitude of the first mode follows a cosine for forty seconds, the other modes stay at zero. Bottom left, springs at rest length: a slower oscillation with sharper turns, in which the other modes grow to a sixth of the amplitude. Right, period against amplitude for one mass between two springs at rest length: it falls as one over the amplitude.
height = 8.5
load 'plots/style.gp'
file = 'build/data/10-membranes.dat'
set multiplot
eval edges(0.075, 0.6, 0.59, 0.97)
set xrange [0:40]
set yrange [-1.25:1.7]
set ytics 1
set format x ''
set xzeroaxis ls 9
set ylabel 'amplitude' offset 0.5
set key at graph 0.99,0.98 right top horizontal samplen 1.5
# The first mode, as the lower curve of 10-dispersion.gp has it.
omega = sqrt(80)*sin(pi/14)
plot cos(omega*x) ls 9, \
     file using 1:6 with points ls 1 ps 0.3*big title 'taut, mode (1, 1)', file using 1:7 with lines ls 2 title 'other modes'
set tmargin at screen 0.55
set bmargin at screen 0.15
set format x '%g'
set xlabel 'time  (s)'
plot file using 1:2 with lines ls 1 title 'at rest length, mode (1, 1)', file using 1:3 with lines ls 2 title 'other modes'
set lmargin at screen 0.735
set rmargin at screen 0.985
set tmargin at screen 0.97
set logscale xy
eval decades
set ytics auto
set format '10^{%T}'
set xrange [2e-3:0.6]
set yrange [0.5:200]
set xlabel 'amplitude {/:Italic A}  (m)'
set ylabel 'period  (s)' offset 0.8
set label 1 '∝ 1/{/:Italic A}' at 0.02,25 tc rgb '#555555'
# A T, with l = 2/7 m, m = 1 kg and D = 50 N/m.
period = sqrt(2)*gamma(0.25)**2/sqrt(2*pi)*2/7/sqrt(50)
plot period/x ls 9, 'build/data/10-quartic.dat' using 1:2 with points ls 1
