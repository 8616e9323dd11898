# data: build/data/08-area.dat
# command: build/bin/step-studies --study area -o build/data/08-area.dat
# alt: Three panels with the phase plane of a pendulum. In each a disk of states at the middle right is shown after 0, 3, 6 and 9 steps, going round clockwise and being drawn out. Under Euler it grows and leaves, under leapfrog and RK4 it becomes a long curved drop of the same area.
height = 6
load 'plots/style.gp'
file = 'build/data/08-area.dat'
array part[3] = ['Euler', 'leapfrog', 'RK4']
set multiplot layout 1,3 margins 0.085,0.985,0.18,0.97 spacing 0.03,0
set xrange [-3.6:3.6]
set yrange [-3.1:3.1]
set tics 1
set xlabel 'angle {/:Italic x}'
do for [k=0:2] {
  set format y (k == 0 ? '%g' : '')
  set ylabel k == 0 ? 'velocity {/:Italic v}  (1/s)' : '' offset 0.6
  set label 1 part[k+1] at graph 0.05,0.93
  plot for [j=0:3] file index 4*k+j using 1:2 with filledcurves closed fc rgb blue fs transparent solid 0.2+0.15*j border lc rgb blue
}
