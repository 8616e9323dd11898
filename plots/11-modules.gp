# alt: The modules of part III in rows, an arrow from each to those that it uses. Above, the program step points to observables, checkpoint and reference; the first two point to motion. Motion points to gravity, springs and spheres, which do not point to each other. Below them are stepping, to which gravity, springs and reference point, and scene, to which springs and spheres point. No arrow leads upwards.
load 'plots/style.gp'
unset border
unset tics
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set xrange [0:14]
set yrange [0:7]
n = 10
array name[n] = ['step', 'observables', 'checkpoint', 'reference', 'motion', 'gravity', 'springs', 'spheres', 'stepping', 'scene']
array X[n] = [4.7, 4.7, 7.5, 1.15, 6.1, 3.55, 6.1, 8.65, 3.55, 7.4]
array Y[n] = [6.4, 5.0, 5.0, 2.1, 3.6, 2.1, 2.1, 2.1, 0.6, 0.6]
half = 1.05
tall = 0.32
# from, to: the corners where an arrow begins and ends
arrow(a, b) = sprintf("set arrow from %f,%f to %f,%f size screen 0.012,20 filled back lc rgb '#777777' lw %f", \
    X[a] + (X[b] - X[a]) * 0.12, Y[a] - tall, X[b] - (X[b] - X[a]) * 0.10, Y[b] + tall, 0.9 * thick)
do for [pair in "1-2 1-3 1-4 2-5 3-5 5-6 5-7 5-8 6-9 7-9 7-10 8-10 4-9"] {
    cut = strstrt(pair, '-')
    eval arrow(int(pair[1:cut - 1]), int(pair[cut + 1:]))
}
fill(k) = k == 1 ? '#ffffff' : k <= 5 ? '#dcebf5' : k <= 8 ? '#fbe3d3' : '#e6e6e6'
do for [k=1:n] {
    set object k rectangle center X[k],Y[k] size 2 * half,2 * tall front fc rgb fill(k) fs solid border lc rgb '#555555'
    set label k name[k] at X[k],Y[k] center front
}
set label 20 'the program' at 13.8,6.4 right tc rgb '#555555'
set label 21 'puts together' at 13.8,4.3 right tc rgb '#555555'
set label 22 'says what acts' at 13.8,2.1 right tc rgb '#555555'
set label 23 'says nothing of forces' at 13.8,0.6 right tc rgb '#555555'
plot NaN
