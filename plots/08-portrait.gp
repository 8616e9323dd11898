# data: build/data/08-portrait.dat
# command: for m in euler symplectic-euler leapfrog rk4; do t=200; [ $m != euler ] || t=7; for x in 0.6 1.2 1.8 2.4; do build/bin/pendulum0 $m 0.5 $t $x; echo; echo; done; done > build/data/08-portrait.dat
# alt: Four panels, angular velocity against angle of a pendulum, each with the points of four swings of different size. Euler's points leave their curves outwards at once. Symplectic Euler's lie on closed curves that lean to one side, leapfrog's on closed upright ones, RK4's on spirals that wind inwards a little.
height = 8.5
load 'plots/style.gp'
file = 'build/data/08-portrait.dat'
array part[4] = ['Euler', 'symplectic Euler', 'leapfrog', 'RK4']
set multiplot layout 2,2 margins 0.1,0.985,0.15,0.93 spacing 0.09,0.085
set xrange [-3.3:3.3]
set yrange [-2.9:2.9]
set tics 1
set samples 400
do for [k=0:3] {
  set format x (k > 1 ? '%g' : '')
  set xlabel k > 1 ? 'angle {/:Italic x}' : ''
  set ylabel k % 2 == 0 ? 'velocity {/:Italic v}  (1/s)' : '' offset 0.6
  set title part[k+1] offset 0,-0.7
  plot for [j=1:4] sqrt(2*(cos(x) - cos(0.6*j))) ls 9, \
       for [j=1:4] -sqrt(2*(cos(x) - cos(0.6*j))) ls 9, \
       for [j=0:3] file index 4*k+j using 2:3 with points pt 7 ps 0.25*big lc rgb (j % 2 ? red : blue)
}
