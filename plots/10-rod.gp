# data: build/data/10-rod.dat
# command: build/bin/springs-studies --study rod -o build/data/10-rod.dat
# data: build/data/10-errors.dat
# command: build/bin/springs-studies --study errors -o build/data/10-errors.dat
# alt: Two panels with logarithmic axes. Left, error against step, for the leapfrog with the stiff spring, which ends at 0.028 seconds, for the implicit midpoint rule and for the rod, which goes on to half a second; all three fall as the square of the step. Right, how far the pendulum with a spring ends from the one with a rod, against the stiffness: it falls as one over the stiffness.
height = 6.5
load 'plots/style.gp'
load 'plots/methods.gp'
set multiplot layout 1,2 margins 0.09,0.985,0.17,0.97 spacing 0.13,0
# The rod at short steps, and stiff springs.
rod = 'build/data/10-rod.dat'
stats rod index 0 using ($1 < 0.1 ? log($2/$1**2) : NaN) nooutput
square = exp(STATS_mean)
stats rod index 1 using ($1 > 1000 ? log($1*$2) : NaN) nooutput
stiff = exp(STATS_mean)
eval powers
set xlabel 'step  (s)'
set ylabel 'error after 10 s  (m)' offset 0.5
set xrange [4e-4:1]
set yrange [1e-7:3]
set key at graph 0.985,0.03 right bottom samplen 1.5
errors = 'build/data/10-errors.dat'
plot square*x**2 ls 9, \
     for [m in 'leapfrog implicit-midpoint'] errors index at(errors, m) using 1:3 \
     with linespoints ls style_of(m) title 'spring, '.name_of(m), \
     rod index 0 using 1:2 with linespoints ls 2 title 'rod'
set xlabel 'stiffness of the upper spring  (N/m)'
set ylabel 'distance of spring from rod  (m)' offset 0
set xrange [60:3e6]
set yrange [5e-6:2]
set label 1 '∝ 1/{/:Italic D}_1' at 2e5,4e-4 tc rgb '#555555'
plot stiff/x ls 9, rod index 1 using 1:2 with points ls 2
