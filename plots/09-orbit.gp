# alt: Left, two ellipses of the same shape, one half as large as the other, with a common focus at the centre of mass; a heavy body on the smaller and a light one on the larger, on opposite sides of the focus. Right, an ellipse inside its circle, the Sun in a focus; from the body a vertical line leads to the circle, from where a radius leads to the centre and makes the angle E with the axis; the area between the Sun, the nearest point and the body is shaded.
height = 5.6
load 'plots/style.gp'
unset border
unset tics
set size ratio -1
set margins 0,0,0,0
set xrange [-3.25:11.75]
set yrange [-2.85:3.15]
e = 0.6
b(a) = a*sqrt(1 - e*e)
set samples 400
set parametric
set trange [0:2*pi]
# left: the focus of both at (0, 0), the light body's ellipse to the left
a1 = 1.0
a2 = 2.0
E0 = 2.25
px = a2*(cos(E0) - e)
py = b(a2)*sin(E0)
c = 0.75
set arrow from px+c,py to -px/2+c,-py/2 nohead dt 3 lc rgb '#777777' lw thick
# right: centre at (8.6, 0)
m = 8.6
A = 2.6
E1 = 1.15
bx = m + A*cos(E1)
by = b(A)*sin(E1)
cy = A*sin(E1)
set arrow from m-A,0 to m+A,0 nohead lc rgb '#777777' lw 0.8*thick
set arrow from m,0 to bx,cy nohead lc rgb dark lw 1.2*thick
set arrow from bx,0 to bx,cy nohead dt 2 lc rgb dark lw thick
set arrow from m+A*e,0 to bx,by nohead lc rgb red lw 1.6*thick
set object 1 circle at m,0 size 0.6 arc [0:E1*180/pi] nowedge fs empty border lc rgb dark lw thick front
set label 1 '{/:Italic E}' at m+0.68,0.42 left front
set label 2 '{/:Italic r}' at (bx+m+A*e)/2+0.12,by/2+0.1 left tc rgb red front
set label 3 '{/:Italic ae}' at m+A*e/2,-0.28 center front
set label 4 '{/:Italic a}' at m-A/2,-0.28 center front
set label 5 '{/:Italic b}' at m-0.15,-b(A)/2 right front
set arrow from m,0 to m,-b(A) nohead lc rgb '#777777' lw 0.8*thick
set label 6 '{/:Italic m}_1 = 2' at -px/2+c+0.25,-py/2-0.5 center front
set label 7 '{/:Italic m}_2 = 1' at px+c-0.1,py+0.45 center front
set label 8 '×' at c,0 center front
set label 9 'seen from the centre of mass' at -0.4,2.85 center tc rgb '#555555'
set label 10 '{/:Italic m}_2 seen from {/:Italic m}_1' at m,3.0 center tc rgb '#555555'
# from the nearest point to the body, t from 0 to 1
u(t) = E1*t/(2*pi)
plot m + A*cos(u(t)), b(A)*sin(u(t)) with filledcurves xy=m+A*e,0 fc rgb '#f3d3c2' fs solid, \
     c + a2*(cos(t) - e), b(a2)*sin(t) with lines lc rgb blue lw 1.2*thick, \
     c - a1*(cos(t) - e), b(a1)*sin(t) with lines lc rgb red lw 1.2*thick, \
     m + A*cos(t), A*sin(t) with lines lc rgb '#777777' dt 2 lw thick, \
     m + A*cos(t), b(A)*sin(t) with lines lc rgb blue lw 1.4*thick, \
     c + px, py with points pt 7 ps 1.3*big lc rgb blue, c - px/2, -py/2 with points pt 7 ps 1.8*big lc rgb red, \
     m + A*e, 0 with points pt 7 ps 2*big lc rgb orange, bx, by with points pt 7 ps 1.3*big lc rgb blue
