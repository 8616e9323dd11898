# alt: Two sketches. Left, a disk of radius r flies towards a wall; a dashed line one radius before the wall is as far as its centre may go, and there a pale outline of the disk touches the wall. Right, disk 1 at rest with a dotted circle of radius sigma around its centre; the centre of disk 2 flies along a straight line that passes the first centre at the distance b and enters the circle where the two disks touch.
height = 5.6
load 'plots/style.gp'
eval drawing
set margins 0,0,0,0
set xrange [0:15]
set yrange [-3:3]
pale = '#cfe3f1'
# The wall, and a disk that flies to it.
w = 5.6
r = 0.9
x0 = 1.25
y0 = -0.2
slope = 0.28
xc = w - r
yc = y0 + slope*(xc - x0)
set object 1 rectangle from w,-2.6 to w+0.3,2.6 fc rgb '#bbbbbb' fs solid noborder
set object 2 circle at x0,y0 size r fc rgb pale fs solid border lc rgb blue lw 1.5*thick
set object 3 circle at xc,yc size r fs empty border lc rgb blue lw 1.0*thick dt 2
set arrow 1 from xc,-2.6 to xc,2.6 nohead dt 2 lc rgb '#555555' lw 1*thick
set arrow 2 from x0,y0 to x0+1.7,y0+1.7*slope lw 2*thick lc rgb dark front
set arrow 3 from x0+1.7,y0+1.7*slope to xc,yc nohead dt 3 lc rgb '#555555' lw 1*thick
set arrow 4 from xc,-2.1 to w,-2.1 heads size 0.18,20 lc rgb '#555555' lw 0.8*thick
set arrow 5 from x0,-1.75 to xc,-1.75 heads size 0.18,20 lc rgb '#555555' lw 0.8*thick
set label 1 '{/:Italic r}' at (xc+w)/2,-2.5 center tc rgb '#555555'
set label 2 '{/:Italic L} − {/:Italic r} − {/:Italic x}' at (x0+xc)/2,-2.15 center tc rgb '#555555'
set label 3 '{/:Bold v}' at x0+1.35,y0+0.75 tc rgb dark
set label 4 '{/:Italic L}' at w+0.15,2.85 center tc rgb '#555555'
# Disk 1 at rest, disk 2 on its way.
ax = 9.1
ay = 0.0
r1 = 1.0
r2 = 0.75
s = r1 + r2
b = 1.05
bx = 13.7
along = sqrt(s*s - b*b)
set object 4 circle at ax,ay size r1 fc rgb pale fs solid border lc rgb blue lw 1.5*thick
set object 5 circle at ax,ay size s fs empty border lc rgb '#555555' lw 1*thick dt 3
set object 6 circle at bx,ay+b size r2 fc rgb '#f7d9c4' fs solid border lc rgb red lw 1.5*thick
set object 7 circle at ax+along,ay+b size r2 fs empty border lc rgb red lw 1*thick dt 2
set arrow 6 from bx,ay+b to bx-1.6,ay+b lw 2*thick lc rgb dark front
set arrow 7 from bx-1.6,ay+b to ax-2.2,ay+b nohead dt 3 lc rgb '#555555' lw 1*thick
set arrow 8 from ax,ay to ax,ay+b nohead lc rgb '#555555' lw 0.8*thick front
set arrow 9 from ax,ay to ax+along,ay+b nohead lc rgb '#555555' lw 1.2*thick front
set arrow 10 from ax,ay to bx,ay+b dt 2 lc rgb '#555555' lw 1*thick front
set label 5 '{/:Italic b}' at ax-0.12,ay+0.45 right tc rgb '#333333' front
set label 6 '{/:Italic σ}' at ax+0.44,ay+0.62 right tc rgb '#333333' front
set label 7 'Δ{/:Bold x}' at ax+3.1,ay+0.35 tc rgb '#333333' front
set label 8 'Δ{/:Bold v}' at bx-1.3,ay+b+0.4 tc rgb dark front
set label 9 '1' at ax-0.55,ay-0.45 center tc rgb blue front
set label 10 '2' at bx+0.3,ay+b+0.05 center tc rgb red front
plot 1/0
