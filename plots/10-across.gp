# alt: Two sketches of a mass between two walls, raised by z above the line between them. Left, springs as long as the gaps: two short arrows F along the springs, the sum of their components along z tiny. Right, stretched springs: two long arrows T, tilted a little, and their sum down by 2 T z/d.
height = 4.3
load 'plots/style.gp'
unset border
unset tics
set size ratio -1
set margins 0,0,0,0
set xrange [-0.3:14.3]
set yrange [-1.35:3.13]
saw(u) = abs(u - floor(u + 0.5))*4 - 1
side(t, n, w) = t < 0.1 || t > 0.9 ? 0 : w*saw(n*(t - 0.1)/0.8 + 0.25)
len(x0, y0, x1, y1) = sqrt((x1 - x0)**2 + (y1 - y0)**2)
sx(t, x0, y0, x1, y1, n, w) = x0 + t*(x1 - x0) - side(t, n, w)*(y1 - y0)/len(x0, y0, x1, y1)
sy(t, x0, y0, x1, y1, n, w) = y0 + t*(y1 - y0) + side(t, n, w)*(x1 - x0)/len(x0, y0, x1, y1)
set samples 641
set parametric
set trange [0:1]
z = 1.1
d = 3.0
do for [k=0:1] {
  x = 0.35 + 7.5*k
  set arrow from x,0 to x+2*d,0 nohead dt 3 lc rgb '#777777' lw thick
  set arrow from x,-0.6 to x,0.6 nohead lc rgb dark lw 1.6*thick
  set arrow from x+2*d,-0.6 to x+2*d,0.6 nohead lc rgb dark lw 1.6*thick
  set arrow from x+d,0.06 to x+d,z-0.2 lc rgb '#555555' lw thick
  set label '{/:Italic z}' at x+d+0.12,0.42 left tc rgb '#555555'
  set arrow from x,-0.85 to x+d,-0.85 heads lc rgb '#555555' lw thick
  f = k ? 1.5 : 0.45
  l = sqrt(d*d + z*z)
  set arrow from x+d,z to x+d-f*d/l,z-f*z/l lc rgb red lw 2.2*thick front
  set arrow from x+d,z to x+d+f*d/l,z-f*z/l lc rgb red lw 2.2*thick front
  set label (k ? '{/:Italic T}' : '{/:Italic F}') at x+d+f*d/l+0.05,z-f*z/l+(k?0.42:0.38) left tc rgb red front
}
set label '{/:Italic d} = {/:Italic l}' at 0.35+d/2,-1.17 center tc rgb '#555555'
set label '{/:Italic d} > {/:Italic l}' at 7.85+d/2,-1.17 center tc rgb '#555555'
set label 'at rest length: {/:Italic F} ≈ {/:Italic Dz}^2/2{/:Italic l}' at 0.35+d,2.75 center
set label 'taut: {/:Italic T} = {/:Italic D}({/:Italic d} − {/:Italic l})' at 7.85+d,2.75 center
plot for [k=0:1] sx(t, 0.35+7.5*k, 0, 0.35+7.5*k+d, z, k ? 7 : 11, 0.16), sy(t, 0.35+7.5*k, 0, 0.35+7.5*k+d, z, k ? 7 : 11, 0.16) with lines lc rgb dark lw thick, \
     for [k=0:1] sx(t, 0.35+7.5*k+2*d, 0, 0.35+7.5*k+d, z, k ? 7 : 11, 0.16), sy(t, 0.35+7.5*k+2*d, 0, 0.35+7.5*k+d, z, k ? 7 : 11, 0.16) with lines lc rgb dark lw thick, \
     for [k=0:1] 0.35+7.5*k+d, z with points pt 7 ps 1.7*big lc rgb blue
