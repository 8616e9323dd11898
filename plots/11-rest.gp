# data: build/data/11-swing.dat
# command: build/bin/scene cradle --string 1 --gap 0.001 --restitution 0.9 --dt 0.001 -o build/data/11-swing.plist && build/bin/step build/data/11-swing.plist --until 20 --every 0.02 --rule approaching --shift back --order deepest --observe t,x:0,x:1,x:2,x:3,x:4,energy -o build/data/11-swing.dat
# data: build/data/11-rest.dat
# command: build/bin/spheres-studies --study rest -o build/data/11-rest.dat
# alt: Left, places of five balls on strings against time: at first the outer two swing in turn and the others hardly move; within ten seconds the swings become alike, and from then on all five swing together. Right, energies on a logarithmic scale: on strings it falls in stairs to one fifth and stays there; between walls it falls in stairs to less than a hundredth within a minute, points by steps on the line by events.
load 'plots/style.gp'
swing = 'build/data/11-swing.dat'
rest = 'build/data/11-rest.dat'
set multiplot layout 1,2 margins 0.085,0.985,0.17,0.96 spacing 0.125,0
stats swing using 8 every ::0::0 nooutput
strings = STATS_min
stats rest using 2 every ::0::0 nooutput
walls = STATS_min
set xlabel 'time  (s)'
set xrange [0:20]
set ylabel '{/:Italic x}  (m)' offset 1.5
set yrange [-0.6:1.35]
plot swing using 1:3 with lines ls 1, swing using 1:4 with lines ls 9, \
     swing using 1:5 with lines ls 9, swing using 1:6 with lines ls 9, \
     swing using 1:7 with lines ls 2
set logscale y
set format y '10^{%T}'
set ylabel '{/:Italic E} / {/:Italic E}_0' offset 0.5
set xrange [0:60]
set yrange [5e-3:1.3]
set key at graph 0.97,0.97 right top samplen 2
set label 1 '1/5' at 54,0.165 center tc rgb '#555555'
plot swing using 1:($8/strings) with lines ls 1 title 'on strings', \
     (x > 20 ? 0.2 : NaN) with lines ls 9, \
     rest using 1:($2/walls) with lines ls 5 title 'walls, by events', \
     rest using 1:($3/walls) every 30 with points ls 2 title 'walls, by steps'
