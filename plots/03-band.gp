# data: plots/data/03-cost.dat
# alt: Left: a sphere of radius 1 with a narrow band around it between two planes at u and u plus du. The radius of the band is the root of one minus u squared; its width along the surface is larger than du, for the surface is slanted. Right: densities of u for 2, 3, 4, 5 and 10 dimensions: highest at the ends for 2, level for 3, a half circle for 4, a parabola for 5, a bell for 10.
height = 6.2
load 'plots/style.gp'
set multiplot layout 1,2 margins 0.01,0.985,0.19,0.97 spacing 0.1,0
u = 0.5; du = 0.13; flat = 0.22
r(u) = sqrt(1 - u*u)
eval drawing
set parametric
set samples 181
set xrange [-1.2:1.55]
set yrange [-1.2:1.3]
# The band: between the two planes, front and back.
set print $band
do for [k=0:40] { t = -pi/2 + pi*k/40; print u + flat*r(u)*cos(t), r(u)*sin(t) }
do for [k=0:10] { w = u + du*k/10; print w, r(w) }
do for [k=0:40] { t = pi/2 - pi*k/40; print u + du + flat*r(u+du)*cos(t), r(u+du)*sin(t) }
do for [k=0:10] { w = u + du - du*k/10; print w, -r(w) }
unset print
set arrow 1 from -1.2,0 to 1.45,0 lw 1*thick lc rgb '#555555' back
set label 1 '{/:Italic u}' at 1.5,0 center
set arrow 2 from 0,0 to u,r(u) lw 1.3*thick front
set label 2 '1' at 0.17,0.52 center front
set arrow 3 from u,0 to u,-r(u) nohead dt 2 lw 1*thick front
set label 3 '√(1 − {/:Italic u}^2)' at u-flat-0.06,-0.3 right front
set arrow 4 from u,-r(u) to u,-1.07 nohead dt 3 lw 0.8*thick
set arrow 5 from u+du,-r(u+du) to u+du,-1.07 nohead dt 3 lw 0.8*thick
set label 4 '{/:Italic du}' at u+du/2,-1.15 center front
set label 5 '{/:Italic du}/√(1 − {/:Italic u}^2)' at u+du+0.06,0.92 left front tc rgb red
plot [0:2*pi] cos(t),sin(t) with lines lc rgb dark lw 1.5*thick, \
     $band using 1:2 with filledcurves closed fc rgb '#f2b48a' lw 1, \
     u+flat*r(u)*cos(t),r(u)*sin(t) with lines lc rgb red lw 0.8*thick, \
     u+du+flat*r(u+du)*cos(t),r(u+du)*sin(t) with lines lc rgb red lw 0.8*thick
unset parametric
unset arrow
unset label
set border
set tics
set size noratio
set samples 801
set xrange [-1:1]
set yrange [0:1.6]
set tics 0.5
set xlabel '{/:Italic u}'
set ylabel 'density {/:Italic p}({/:Italic u})' offset 1
p(u,n) = gamma(n/2.0)/sqrt(pi)/gamma((n-1)/2.0)*(1 - u*u)**((n-3)/2.0)
set label 2 '{/:Italic n} = 10' at 0.24,1.1 tc rgb purple
set label 3 '5' at -0.03,0.81
set label 4 '4' at -0.58,0.6 tc rgb green
set label 5 '3' at -0.03,0.56 tc rgb red
set label 6 '2' at 0.0,0.26 tc rgb blue
plot (abs(x) < 0.9995 ? p(x,2) : NaN) with lines lc rgb blue lw 1.5*thick, p(x,3) with lines lc rgb red lw 1.5*thick, \
     p(x,4) with lines lc rgb green lw 1.5*thick, p(x,5) with lines lc rgb dark lw 1.5*thick, p(x,10) with lines lc rgb purple lw 1.5*thick
