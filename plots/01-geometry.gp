# data: build/data/01-geometry.dat
# command: build/bin/collide --velocities 1,0,0,0 --inverse-masses 0.1,1 --normal 0.7,0.7 -o /dev/null --summary build/data/01-geometry.dat
# alt: A large disk touches a small one, up and to the right of it. A dashed arrow is the large disk's velocity before, to the right. A dotted line joins the centres. After the collision the small disk leaves along this line; the large one moves a little slower and slightly downwards.
width = 12
height = 6.6
load 'plots/style.gp'
stats 'build/data/01-geometry.dat' using (strcol(1) eq 'v1_x' ? (v1x = $2) : 0) nooutput
stats 'build/data/01-geometry.dat' using (strcol(1) eq 'v1_y' ? (v1y = $2) : 0) nooutput
stats 'build/data/01-geometry.dat' using (strcol(1) eq 'v2_x' ? (v2x = $2) : 0) nooutput
stats 'build/data/01-geometry.dat' using (strcol(1) eq 'v2_y' ? (v2y = $2) : 0) nooutput

# Disk 1 at the origin with radius 1, disk 2 touches it along (1,1).
r1 = 1.0
r2 = 0.5
x2 = (r1 + r2)/sqrt(2)
scale = 1.7  # length of an arrow of 1 m/s
unset border
unset tics
set size ratio -1
set xrange [-1.5:3.3]
set yrange [-1.25:2.75]
set margins 0,0,0,0
set object 1 circle at 0,0 size r1 fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.5*thick
set object 2 circle at x2,x2 size r2 fc rgb '#f7d9c4' fs solid border lc rgb red lw 1.5*thick
set arrow 1 from -0.55,-0.55 to x2*1.95,x2*1.95 nohead dt 3 lw 1*thick lc rgb '#555555' front
set label 1 'line of centres {/:Bold n}' at x2*1.62,x2*1.95 right tc rgb '#555555'
set arrow 2 from 0,0 to scale,0 dt 2 lw 2*thick lc rgb dark front
set label 2 '{/:Bold u}_1' at scale+0.08,0.16 tc rgb dark front
set arrow 3 from 0,0 to scale*v1x,scale*v1y lw 2.5*thick lc rgb blue front
set label 3 '{/:Bold v}_1' at scale*v1x-0.1,scale*v1y-0.2 tc rgb blue front
set arrow 4 from x2,x2 to x2+scale*v2x,x2+scale*v2y lw 2.5*thick lc rgb red front
set label 4 '{/:Bold v}_2' at x2+scale*v2x+0.12,x2+scale*v2y-0.12 tc rgb red front
set label 5 '{/:Italic m}_1 = 10 kg' at -0.5,0.4 center tc rgb blue front
set label 6 '{/:Italic m}_2 = 1 kg, {/:Bold u}_2 = 0' at x2+r2+0.12,x2-0.12 left tc rgb red front
set label 7 sprintf('{/:Bold v}_1 = (%.3f, %.3f) m/s', v1x, v1y) at 1.75,-0.85 left tc rgb blue
set label 8 sprintf('{/:Bold v}_2 = (%.3f, %.3f) m/s', v2x, v2y) at 1.75,-1.1 left tc rgb red
plot 1/0
