# data: build/data/09-survival.dat
# command: build/bin/gravity-studies --study survival -o build/data/09-survival.dat
# lecture: build/bin/gravity-studies --study survival --orbits 10000 -o build/data/09-survival.dat
# data: plots/data/kepler16_scan.dat
# alt: How many of eight starting phases survive a thousand periods of the stars against the distance at which the planet begins, from 1.8 to 2.6 distances of the stars. None or few below 1.95, some from there on, all from 2.24 on. Open circles, ten times as long, agree but for single phases. A vertical line at 2.27, the published fit, stands just right of the step.
height = 6.4
load 'plots/style.gp'
eval edges(0.09, 0.985, 0.2, 0.97)
set xlabel 'distance at which the planet begins  (distances of the stars)'
set ylabel 'phases that survive' offset 1
set xrange [1.78:2.62]
set yrange [-0.5:8.7]
set key at graph 0.03,0.95 left top Left reverse samplen 2
mu = 0.2026/(0.6897 + 0.2026)
law = 1.6 + 4.12*mu - 5.09*mu**2
set arrow from law,-0.5 to law,8.7 nohead ls 9
set label 'Holman and Wiegert' at law+0.007,1.2 left tc rgb '#555555'
plot 'build/data/09-survival.dat' using 1:3 with steps lc rgb '#cccccc' notitle, \
     'build/data/09-survival.dat' using 1:3 with points ls 1 title '1000 periods', \
     'plots/data/kepler16_scan.dat' using 1:3 with points pt 6 ps 1.1*big lw 1.2*thick lc rgb red title '10 000 periods (reference)'
