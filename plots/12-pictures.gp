# alt: Two sketches. Left, place against time of three equal bodies between two walls: straight lines that cross and are reflected at the walls, thin and white, full, dashed and dotted; around them, thick and in colour, the ways of the left, the middle and the right body, which change from one line to another at each crossing and never cross. Right, a heavy body, a light one near it and one farther away; an arrow leads from the heavy body to the first light one, and one from a small cross near the heavy body, the centre of these two, to the second light one; another cross beside it is the centre of all three.
width = 14
height = 6
load 'plots/style.gp'
set multiplot layout 1,2
set samples 801
# Three points that fly freely, folded back at 0 and 1.
fold(u) = abs(u - 2*floor(u/2 + 0.5))
p(t) = fold(0.15 + 0.9*t)
q(t) = fold(0.50 - 0.55*t)
s(t) = fold(0.85 + 0.25*t)
least(a,b) = a < b ? a : b
most(a,b) = a > b ? a : b
low(t) = least(p(t), least(q(t), s(t)))
high(t) = most(p(t), most(q(t), s(t)))
mid(t) = p(t) + q(t) + s(t) - low(t) - high(t)
set xrange [0:3]
set yrange [-0.02:1.02]
set xlabel 'time' offset 0,0.4
set ylabel 'place' offset 1,0
unset tics
set object 1 rectangle from 0,-0.02 to 3,0 fc rgb '#bbbbbb' fs solid noborder
set object 2 rectangle from 0,1 to 3,1.02 fc rgb '#bbbbbb' fs solid noborder
set lmargin 5
set rmargin 2
plot low(x) lc rgb blue lw 3.5*thick, mid(x) lc rgb red lw 3.5*thick, \
     high(x) lc rgb green lw 3.5*thick, \
     p(x) lc rgb 'white' lw 1.0*thick, q(x) lc rgb 'white' lw 1.0*thick dt 2, \
     s(x) lc rgb 'white' lw 1.0*thick dt 3
# Jacobi's coordinates.
unset object
unset xlabel
unset ylabel
unset border
set size ratio -1
set lmargin 1
set rmargin 1
set xrange [-1.9:8.3]
set yrange [-2.6:3.8]
hx = 0; hy = 0
ax = 3; ay = 2.6
bx = 7; by = -1
cx = 0.28*ax; cy = 0.28*ay
dx = cx + 0.18*(bx - cx); dy = cy + 0.18*(by - cy)
set object 1 circle at hx,hy size 0.75 fc rgb '#f0e0b0' fs solid border lc rgb orange lw 1.5*thick
set object 2 circle at ax,ay size 0.35 fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.5*thick
set object 3 circle at bx,by size 0.3 fc rgb '#f7d9c4' fs solid border lc rgb red lw 1.5*thick
set arrow 1 from hx,hy to ax,ay lc rgb blue lw 2*thick size 0.3,20 front
set arrow 2 from cx,cy to bx,by lc rgb red lw 2*thick size 0.3,20 front
set label 1 '{/:Bold c}_0' at hx-0.15,hy-0.3 right front
set label 2 '{/:Bold c}_1' at cx-0.2,cy+0.3 right front
set label 3 '{/:Bold c}_2' at dx+0.1,dy+0.45 left front
set label 4 '{/:Bold η}_1' at 1.75,2.0 right tc rgb blue front
set label 5 '{/:Bold η}_2' at 4.3,-0.75 center tc rgb red front
set label 6 '{/:Italic M}_0' at hx-0.9,hy+0.5 right tc rgb '#555555'
set label 7 '{/:Italic m}_1' at ax+0.5,ay+0.35 left tc rgb '#555555'
set label 8 '{/:Italic m}_2' at bx+0.4,by+0.45 left tc rgb '#555555'
$centres << EOD
0 0
0.84 0.728
1.949 0.417
EOD
plot $centres using 1:2 with points pt 2 ps 0.9*big lw 1.5*thick lc rgb dark
unset multiplot
