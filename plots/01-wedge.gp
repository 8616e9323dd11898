# data: build/data/01-wedge.dat
# command: build/bin/galperin0 9 > build/data/01-wedge.dat
# alt: Left: a wedge between a horizontal wall and a slanted line; a path comes in from the right, parallel to the wall, is reflected to and fro between both sides towards the corner and out again, nine reflections in all. Right: the wedge unfolded into a fan of ten copies, and the same path as one straight line that crosses nine of their edges.
height = 5
load 'plots/style.gp'
m1 = 1.0; m2 = 9.0
theta = atan(sqrt(m1/m2))
h = 0.42          # the light ball's scaled place
r(p) = h/sin(p)
set multiplot layout 1,2 margins 0.01,0.99,0.05,0.89 spacing 0.03,0
eval drawing
set parametric
set samples 4001
set title 'what happens' offset 0,-0.5
set xrange [-0.12:2.55]
set yrange [-0.3:1.0]
set object 1 polygon from 0,0 to 2.5,0 to 2.5,2.5*tan(theta) to 0,0 fc rgb '#eef4f8' fs solid noborder behind
set arrow 1 from 0,0 to 2.5,0 nohead lw 2*thick lc rgb blue
set arrow 2 from 0,0 to 2.5,2.5*tan(theta) nohead lw 2*thick lc rgb red
set label 1 'the light ball at the wall' at 2.45,-0.13 right tc rgb blue
set label 2 'the balls touch' at 1.75,0.75 right tc rgb red
set label 3 '{/:Italic θ}' at 0.22,0.035 front
set arrow 3 from 2.35,h to 1.95,h lw 2*thick lc rgb dark front
plot 'build/data/01-wedge.dat' using 1:2 with lines lc rgb dark lw 1.3*thick
unset object 1
unset arrow; unset label
set title 'unfolded' offset 0,-0.5
set xrange [-2.6:2.6]
set yrange [-0.3:2.6]
do for [k=0:9] { set arrow 10+k from 0,0 to 2.2*cos(k*theta),2.2*sin(k*theta) nohead lw (k < 1 ? 2 : 1.2)*thick lc rgb (k % 2 ? red : blue) }
do for [k=1:9] { set label 10+k sprintf('%d', k) at 2.36*cos(k*theta),2.36*sin(k*theta) center }
set arrow 3 from 2.2,h to 1.7,h lw 2*thick lc rgb dark front
set trange [asin(h/2.4):pi-asin(h/2.4)]
plot r(t)*cos(t),r(t)*sin(t) lc rgb dark lw 1.3*thick
