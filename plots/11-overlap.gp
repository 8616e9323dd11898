# alt: Three sketches of two disks. Left, the second disk has flown into the first from the right; a dotted circle shows where it touched, a time tau earlier. Middle, both have been pushed apart along the line of their centres. Right, they have gone back to where they touched and on from there with their new velocities; the places and the arrows differ a little from those of the middle.
height = 4.1
load 'plots/style.gp'
unset border
unset tics
set size ratio -1
set margins 0,0,0,0
set xrange [-1.9:14.1]
set yrange [-1.75:2.93]
apart = 5.4   # of two sketches
r = 1.0
h = 0.9       # how far the path passes the centre
tau = 0.55
# A: they touch, B: they are found; the second flies to the left with speed 1.
ax = sqrt(4*r*r - h*h)
bx = ax - tau
d = sqrt(bx*bx + h*h)
mx = bx/d     # the normal at B
my = h/d
nx = ax/(2*r) # the normal at A
ny = h/(2*r)
deep = 2*r - d
# found
set object 1 circle at ax,h size r fs empty border lc rgb '#777777' lw 1*thick dt 3
set object 2 circle at 0,0 size r fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.5*thick
set object 3 circle at bx,h size r fc rgb '#f3d3c2' fs transparent solid 0.6 border lc rgb red lw 1.5*thick
set arrow 1 from 0,0 to bx,h nohead dt 2 lw 1*thick lc rgb dark front
set arrow 2 from bx,h to bx-0.9,h lw 2*thick lc rgb red front
set label 1 'found' at 0.7,2.6 center tc rgb dark
set label 2 '{/:Bold v}' at bx-0.75,h+0.3 center tc rgb red front
set label 3 '{/:Bold n}' at 0.3,-0.12 center tc rgb dark front
set label 4 'τ ago' at ax+1.12,h left tc rgb '#555555'
# pushed apart: by half the depth each
px = apart - mx*deep/2
py = -my*deep/2
qx = apart + bx + mx*deep/2
qy = h + my*deep/2
set object 4 circle at px,py size r fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.5*thick
set object 5 circle at qx,qy size r fc rgb '#f3d3c2' fs solid border lc rgb red lw 1.5*thick
set arrow 3 from px,py to qx,qy nohead dt 2 lw 1*thick lc rgb dark front
set arrow 4 from px,py to px-0.9*mx*mx,py-0.9*mx*my lw 2*thick lc rgb blue front
set arrow 5 from qx,qy to qx-0.9*(1-mx*mx),qy+0.9*mx*my lw 2*thick lc rgb red front
set label 5 'pushed apart' at apart+0.7,2.6 center tc rgb dark
# gone back to A, and on from there
px = 2*apart - tau*nx*nx
py = -tau*nx*ny
qx = 2*apart + ax - tau*(1-nx*nx)
qy = h + tau*nx*ny
set object 6 circle at 2*apart,0 size r fs empty border lc rgb '#777777' lw 1*thick dt 3
set object 7 circle at 2*apart+ax,h size r fs empty border lc rgb '#777777' lw 1*thick dt 3
set object 8 circle at px,py size r fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.5*thick
set object 9 circle at qx,qy size r fc rgb '#f3d3c2' fs solid border lc rgb red lw 1.5*thick
set arrow 6 from 2*apart,0 to 2*apart+ax,h nohead dt 2 lw 1*thick lc rgb dark front
set arrow 7 from px,py to px-0.9*nx*nx,py-0.9*nx*ny lw 2*thick lc rgb blue front
set arrow 8 from qx,qy to qx-0.9*(1-nx*nx),qy+0.9*nx*ny lw 2*thick lc rgb red front
set label 6 'gone back' at 2*apart+0.7,2.6 center tc rgb dark
plot NaN
