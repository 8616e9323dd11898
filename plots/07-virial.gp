# alt: Two sketches of a vertical plane in a gas. Left, a disk flies through the plane with its momentum. Right, two disks that touch, their centres on either side of the plane; an arrow shows that the momentum J jumps from the centre of the one to the centre of the other, over the distance sigma.
width = 12
height = 4.2
load 'plots/style.gp'
eval drawing
set margins 0,0,0,0
set xrange [0:12]
set yrange [-2.1:2.1]
set arrow 1 from 2.9,-1.7 to 2.9,1.7 nohead dt 2 lw 1.2*thick lc rgb '#555555'
set arrow 2 from 9,-1.7 to 9,1.7 nohead dt 2 lw 1.2*thick lc rgb '#555555'
set object 1 circle at 1.5,-0.35 size 0.7 fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.5*thick
set object 2 circle at 4.1,0.3 size 0.7 fs empty border lc rgb blue lw 1.0*thick dt 2
set arrow 3 from 1.5,-0.35 to 4.0,0.275 lw 2*thick lc rgb dark front
set label 1 '{/:Italic m }{/:Bold v}' at 2.45,0.3 center front
set object 3 circle at 8.45,-0.3 size 0.7 fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.5*thick
set object 4 circle at 9.76,0.193 size 0.7 fc rgb '#f7d9c4' fs solid border lc rgb red lw 1.5*thick
set arrow 4 from 7.0,-0.85 to 8.0,-0.47 lw 1.5*thick lc rgb blue
set arrow 5 from 8.45,-0.3 to 9.76,0.193 lw 2.5*thick lc rgb dark front
set arrow 6 from 8.24,0.26 to 9.55,0.753 heads size 0.1,20 lw 0.8*thick lc rgb '#555555' front
set label 2 '{/:Bold J}' at 9.5,-0.2 center front
set label 3 '{/:Italic σ}' at 8.7,0.8 front tc rgb '#555555'
set label 4 'carried' at 2.9,-1.95 center tc rgb '#555555'
set label 5 'handed on' at 9,-1.95 center tc rgb '#555555'
plot 1/0
