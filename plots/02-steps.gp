# data: plots/data/02-steps.dat
# data: plots/data/05-weight.dat
# alt: Error of the positions after ten seconds against processor time, both axes logarithmic. Time steps fall slowly from an error of two metres to a tenth of a metre, drop tenfold, and then follow a line of slope minus one down to a fifth of a millimetre, at some ten thousand times the time of the event-driven engine, a single point at ten to the minus fourteen metres. Open points, ten beads upright: steps on nearly the same line, events some ten times farther to the right and with as small an error.
width = 12
height = 7.6
load 'plots/style.gp'
file = 'plots/data/02-steps.dat'
# The steps that keep the collisions in order.
stats file using ($1 > 0 && $1 < 1e-4 ? log($2*$3) : NaN) nooutput
steps = exp(STATS_mean)
eval powers
set xlabel 'processor time of the run (s)'
set ylabel 'error of the positions (m)' offset 0.5
set xrange [1e-6:1]
set yrange [1e-15:100]
eval edges(0.14, 0.97, 0.155, 0.97)
set label 1 'time steps' at 1e-3,3 tc rgb red
set label 2 'events' at 2e-5,3e-13 center tc rgb blue
upright = 'plots/data/05-weight.dat'
plot steps/x ls 9, \
     upright using 2:($1 > 0 ? $3 : NaN) with points ls 2 pt 4, \
     upright using 2:($1 == 0 ? $3 : NaN) with points ls 1 pt 6 ps 1.2*big, \
     file using 2:($1 > 0 ? $3 : NaN) with points ls 2, \
     file using 2:($1 == 0 ? $3 : NaN) with points ls 1 ps 1.2*big
