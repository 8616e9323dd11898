# alt: Two world lines, position across and time upwards. Body i last collided low on the left, body i+1 later and further to the right; beside each of these points stands a clock that shows its time. At the later of the two times a level arrow between the lines marks the gap; higher up the lines meet.
width = 12
height = 6.2
load 'plots/style.gp'
set border 3
unset tics
eval edges(0.06, 0.985, 0.1, 0.975)
set size ratio -1
set xrange [0:10]
set yrange [0:4.75]
set xlabel 'position' offset 0,0.2
set ylabel 'time' offset 1
# Body i is at (1.2, 0.9) with slope 1.4; body i+1 at (7.6, 2.1), to the left with 0.7.
xi = 2.2; ti = 0.8; v = 1.25
xj = 7.9; tj = 2.1; w = -0.55
p = xi + v*(tj-ti)
gap = xj - p
meet = tj + gap/(v-w)
set arrow 1 from xi-0.7,0.05 to xi,ti nohead dt 2 lc rgb grey
set arrow 2 from xj-1.2,0.4 to xj,tj nohead dt 2 lc rgb grey
set arrow 3 from xi,ti to xi+v*(meet-ti),meet nohead lw 2.2*thick lc rgb blue
set arrow 4 from xj,tj to xj+w*(meet-tj),meet nohead lw 2.2*thick lc rgb red
set arrow 5 from p,tj to xj,tj heads size 0.2,25 lw 1.2*thick lc rgb dark
set label 5 'gap' at (p+xj)/2,tj-0.24 center tc rgb dark
set arrow 6 from 0,tj to p,tj nohead dt 3 lc rgb grey
set label 6 'later of the two clocks' at 0.15,tj+0.22 left tc rgb '#555555'
set arrow 7 from 0,meet to xi+v*(meet-ti),meet nohead dt 3 lc rgb grey
set label 7 '{/:Italic t}_{gap}' at 0.15,meet+0.24 left tc rgb '#555555'
set object 1 circle at xi,ti size 0.1 fc rgb blue fs solid noborder front
set object 2 circle at xj,tj size 0.1 fc rgb red fs solid noborder front
set object 3 circle at xi+v*(meet-ti),meet size 0.1 fc rgb dark fs solid noborder front
set label 1 '{/:Italic x_i} , {/:Italic v_i} , {/:Italic t_i}' at xi+0.25,ti-0.12 left tc rgb blue
set label 2 '{/:Italic x}_{{/:Italic i}+1} , {/:Italic v}_{{/:Italic i}+1} , {/:Italic t}_{{/:Italic i}+1}' at xj+0.25,tj-0.12 left tc rgb red
# The clocks: a hand that turns once in 4 s.
set object 11 circle at xi-0.75,ti+0.45 size 0.36 fc rgb '#ffffff' fs solid border lc rgb blue lw 1.2*thick front
set arrow 11 from xi-0.75,ti+0.45 to xi-0.75+0.3*sin(pi/2*ti),ti+0.45+0.3*cos(pi/2*ti) size 0.12,25 lw 1.4*thick lc rgb blue front
set object 12 circle at xj+0.85,tj+0.55 size 0.36 fc rgb '#ffffff' fs solid border lc rgb red lw 1.2*thick front
set arrow 12 from xj+0.85,tj+0.55 to xj+0.85+0.3*sin(pi/2*tj),tj+0.55+0.3*cos(pi/2*tj) size 0.12,25 lw 1.4*thick lc rgb red front
plot 1/0
