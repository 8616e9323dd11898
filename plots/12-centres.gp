# alt: A heavy body, a light one near it and one farther away; an arrow leads from the heavy body to the first light one, and one from a small cross near the heavy body, the centre of these two, to the second light one; another cross beside it is the centre of all three.
width = 9
height = 5.2
load 'plots/style.gp'
# Jacobi's coordinates.
eval drawing
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
