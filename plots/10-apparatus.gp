# alt: Four sketches. A block on a zigzag spring and a dashpot, both fixed to a wall on its left, with an arrow for its displacement q. A double pendulum that hangs from a ceiling: a thick short-pitched spring to the first body, a thin one to the second, both at an angle to the dotted vertical. A net of eight by eight bodies seen from above at an angle, its rim black and flat, its inside blue and bulging upwards. A beam of five braced cells, bent downwards, its two left bodies black at a hatched wall.
height = 9.6
load 'plots/style.gp'
unset border
unset tics
set size ratio -1
set margins 0,0,0,0
set xrange [-0.4:14.2]
set yrange [-0.6:9.4]
# A spring of n zigzags and width w from (x0, y0) to (x1, y1), t from 0 to 1:
# straight for an eighth of its length at either end.
saw(u) = abs(u - floor(u + 0.5))*4 - 1
side(t, n, w) = t < 0.125 || t > 0.875 ? 0 : w*saw(n*(t - 0.125)/0.75 + 0.25)
len(x0, y0, x1, y1) = sqrt((x1 - x0)**2 + (y1 - y0)**2)
sx(t, x0, y0, x1, y1, n, w) = x0 + t*(x1 - x0) - side(t, n, w)*(y1 - y0)/len(x0, y0, x1, y1)
sy(t, x0, y0, x1, y1, n, w) = y0 + t*(y1 - y0) + side(t, n, w)*(x1 - x0)/len(x0, y0, x1, y1)
set parametric
set trange [0:1]
# walls
do for [i=0:5] { set arrow from 0.4,6.2+0.36*i to 0.15,5.98+0.36*i nohead lc rgb '#777777' lw thick }
set arrow from 0.4,6.0 to 0.4,8.2 nohead lc rgb dark lw 1.6*thick
do for [i=0:5] { set arrow from 8.7+0.36*i,8.9 to 8.92+0.36*i,9.15 nohead lc rgb '#777777' lw thick }
set arrow from 8.6,8.9 to 10.8,8.9 nohead lc rgb dark lw 1.6*thick
do for [i=0:5] { set arrow from 7.55,0.55+0.36*i to 7.3,0.33+0.36*i nohead lc rgb '#777777' lw thick }
set arrow from 7.55,0.35 to 7.55,2.55 nohead lc rgb dark lw 1.6*thick
# the oscillator: a block, its spring above and its dashpot below
set object 1 rect from 3.4,6.45 to 4.6,7.75 fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.4*thick
set label 1 '{/:Italic m}' at 4.0,7.1 center
set label 2 '{/:Italic D}' at 1.9,7.85 center
set label 3 '{/:Italic c}' at 1.9,6.1 center
set arrow from 0.4,6.6 to 1.75,6.6 nohead lc rgb dark lw 1.2*thick
set arrow from 1.75,6.48 to 1.75,6.72 nohead lc rgb dark lw 1.6*thick
set arrow from 2.05,6.42 to 1.4,6.42 nohead lc rgb dark lw 1.2*thick
set arrow from 2.05,6.78 to 1.4,6.78 nohead lc rgb dark lw 1.2*thick
set arrow from 2.05,6.42 to 2.05,6.78 nohead lc rgb dark lw 1.2*thick
set arrow from 2.05,6.6 to 3.4,6.6 nohead lc rgb dark lw 1.2*thick
set arrow from 4.0,5.75 to 5.2,5.75 lc rgb red lw 1.6*thick
set arrow from 4.0,5.9 to 4.0,5.6 nohead lc rgb red lw 1.2*thick
set label 4 '{/:Italic q}' at 5.35,5.75 left tc rgb red
set label 5 'oscillator' at 2.5,9.1 center tc rgb '#555555'
# the pendulum
ax = 9.7; ay = 8.9
bx = ax + 1.75*sin(0.6); by = ay - 1.75*cos(0.6)
ex = bx + 1.75*sin(0.6); ey = by - 1.75*cos(0.6)
set arrow from ax,ay to ax,ay-2.9 nohead lc rgb '#777777' dt 3 lw thick
set label 6 '0.6 rad' at ax-0.12,ay-1.5 right
set label 7 '{/:Italic D}_1 = 5000 N/m' at bx-0.05,by+1.0 left
set label 8 '{/:Italic D}_2 = 5 N/m' at ex-0.15,ey+1.0 left
set label 9 'double pendulum' at 12.6,9.1 center tc rgb '#555555'
# the membrane, in a projection of its own
zz(i, j) = 1.0*sin(pi*i/7)*sin(pi*j/7)
mx(i, j) = 0.15 + 0.62*i + 0.3*j
my(i, j) = 0.55 - 0.06*i + 0.33*j + zz(i, j)
set label 10 'membrane' at 2.5,4.75 center tc rgb '#555555'
# the beam, bent
cx(i, j) = 7.95 + 0.98*i + 0.010*i*i*(j - 0.5)*2
cy(i, j) = 1.0 + 0.95*j - 0.036*i*i
set label 11 'cantilever' at 10.5,4.0 center tc rgb '#555555'
set arrow from 13.5,1.9 to 13.5,1.0 lc rgb red lw 1.6*thick
set label 12 '{/:Italic g}' at 13.65,1.45 left tc rgb red
seg(f0, f1, t) = f0 + t*(f1 - f0)
# The springs have their corners at 64ths and at 112ths, all else is smooth.
set multiplot
set samples 449
plot sx(t, 0.4, 7.4, 3.4, 7.4, 7, 0.2), sy(t, 0.4, 7.4, 3.4, 7.4, 7, 0.2) with lines lc rgb dark lw 1.2*thick, \
     sx(t, ax, ay, bx, by, 12, 0.13), sy(t, ax, ay, bx, by, 12, 0.13) with lines lc rgb dark lw 2.2*thick, \
     sx(t, bx, by, ex, ey, 6, 0.16), sy(t, bx, by, ex, ey, 6, 0.16) with lines lc rgb dark lw thick
unset label
unset arrow
unset object
set samples 29
plot for [j=0:7] mx(7*t, j), my(7*t, j) with lines lc rgb (j % 7 ? blue : dark) lw 0.8*thick, \
     for [i=0:7] mx(i, 7*t), my(i, 7*t) with lines lc rgb (i % 7 ? blue : dark) lw 0.8*thick, \
     for [j=0:1] for [i=0:4] seg(cx(i, j), cx(i+1, j), t), seg(cy(i, j), cy(i+1, j), t) with lines lc rgb blue lw 1.2*thick, \
     for [i=1:5] seg(cx(i, 0), cx(i, 1), t), seg(cy(i, 0), cy(i, 1), t) with lines lc rgb blue lw 1.2*thick, \
     for [i=0:4] seg(cx(i, 0), cx(i+1, 1), t), seg(cy(i, 0), cy(i+1, 1), t) with lines lc rgb blue lw 0.8*thick, \
     for [i=0:4] seg(cx(i, 1), cx(i+1, 0), t), seg(cy(i, 1), cy(i+1, 0), t) with lines lc rgb blue lw 0.8*thick, \
     for [i=0:5] for [j=0:1] cx(i, j), cy(i, j) with points pt 7 ps 0.9*big lc rgb (i ? blue : dark), \
     for [i=0:7] for [j=0:7] mx(i, j), my(i, j) with points pt 7 ps 0.5*big lc rgb (i % 7 && j % 7 ? blue : dark), \
     ax, ay with points pt 7 ps big lc rgb dark, bx, by with points pt 7 ps 1.5*big lc rgb blue, \
     ex, ey with points pt 7 ps 1.5*big lc rgb blue
