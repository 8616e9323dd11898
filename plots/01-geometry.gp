# data: build/data/01-geometry.dat
# command: build/bin/collide --velocities 1,0,0,0 --inverse-masses 0.1,1 --normal 0.7,0.7 -o /dev/null --summary build/data/01-geometry.dat
# alt: A large disk touches a small one, up and to the right of it. A dashed arrow is the large disk's velocity before, to the right. A dotted line joins the centres. After the collision the small disk leaves along this line; the large one moves a little slower and slightly downwards.
width = 13
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
eval drawing
set xrange [-1.3:5.2]
set yrange [-1.1:2.75]
set margins 0,0,0,0
set object 1 circle at 0,0 size r1 fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.5*thick
set object 2 circle at x2,x2 size r2 fc rgb '#f7d9c4' fs solid border lc rgb red lw 1.5*thick
set arrow 1 from -0.55,-0.55 to x2*1.95,x2*1.95 nohead dt 3 lw 1*thick lc rgb '#555555' front
set label 1 'line of centres {/:Bold n}' at 1.75,2.05 right tc rgb '#555555'
# The dashes end where the head of the arrow begins.
set arrow 2 from 0,0 to scale-0.3,0 nohead dt 2 lw 2*thick lc rgb dark front
set arrow 5 from scale-0.3,0 to scale,0 lw 2*thick lc rgb dark front
set arrow 3 from 0,0 to scale*v1x,scale*v1y lw 2.5*thick lc rgb blue front
set arrow 4 from x2,x2 to x2+scale*v2x,x2+scale*v2y lw 2.5*thick lc rgb red front
number(x) = sprintf('%s%.3f', x < 0 ? '−' : '', abs(x))
vector(x,y) = sprintf(' = (%s, %s) m/s', number(x), number(y))
set label 2 '{/:Bold u}_1 = (1, 0) m/s' at scale+0.12,0.06 tc rgb dark front
set label 3 '{/:Bold v}_1'.vector(v1x,v1y) at scale*v1x+0.08,scale*v1y-0.2 tc rgb blue front
set label 4 '{/:Bold v}_2'.vector(v2x,v2y) at x2+scale*v2x+0.15,x2+scale*v2y-0.05 tc rgb red front
set label 5 '{/:Italic m}_1 = 10 kg' at -0.3,0.45 center tc rgb blue front
set label 6 '{/:Italic m}_2 = 1 kg, {/:Bold u}_2 = 0' at x2+r2+0.12,x2-0.12 left tc rgb red front
plot 1/0
