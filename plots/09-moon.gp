# data: build/data/09-moon.dat
# command: build/bin/gravity-studies --study ring --moon 1e-4 --mixed 2 --orbits 3 -o build/data/09-moon.dat
# alt: The ring unrolled: distance against the angle from the moon, from minus 180 to 180 degrees. Before the moon the outer edge is straight at 2.5. Behind it the edge rises and falls in waves of about 55 degrees that become sharp crests, and at the moon's own distance particles are drawn out of the ring.
height = 6.6
load 'plots/style.gp'
file = 'build/data/09-moon.dat'
eval edges(0.085, 0.97, 0.19, 0.97)
stats file index 0 every ::3073 using (atan2($2,$1)) nooutput
moon = STATS_min
set xlabel 'angle from the moon  (degrees)'
set ylabel '{/:Italic r}  (AU)' offset 1
set xrange [-180:180]
set yrange [1.9:2.8]
set xtics 60
turn(a) = (a - moon - 2*pi*floor((a - moon)/2/pi + 0.5))/pi*180
plot file index 0 every ::1::3072 using (turn(atan2($2,$1))):(sqrt($1**2+$2**2)):(5*$3**0.2*big) \
     with points pt 7 ps variable lc rgb '#333333', \
     file index 0 every ::3073 using (0):(sqrt($1**2+$2**2)) with points ls 2 ps 1.5*big
