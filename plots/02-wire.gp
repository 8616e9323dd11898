# alt: Above, four beads of different sizes on a wire between two stops; the distance between the surfaces of the second and the third is marked as gap i, and arrows show their velocities. Below, the same gaps joined end to end: each bead has become a point, and the wire is shorter by the sum of their diameters.
height = 4.4
load 'plots/style.gp'
unset border
unset tics
set margins 0,0,0,0
set size ratio -1
set xrange [-1.1:14.2]
set yrange [-3.25:1.8]
array X = [1.6, 4.2, 7.0, 9.9]
array A = [0.5, 0.8, 0.35, 0.6]
array P = [1.1, 2.4, 4.05, 6.0]
array V = [0.9, 1.25, -0.8, 1.0]
set arrow 1 from 0,0 to 13,0 nohead lc rgb grey lw 1.5*thick back
set arrow 2 from 0,-2.5 to 8.5,-2.5 nohead lc rgb grey lw 1.5*thick back
set object 1 rectangle from -0.16,-0.55 to 0,0.55 fc rgb '#555555' fs solid noborder
set object 2 rectangle from 13,-0.55 to 13.16,0.55 fc rgb '#555555' fs solid noborder
set object 3 rectangle from -0.16,-2.85 to 0,-2.15 fc rgb '#555555' fs solid noborder
set object 4 rectangle from 8.5,-2.85 to 8.66,-2.15 fc rgb '#555555' fs solid noborder
do for [i=1:4] {
    set object 10+i circle at X[i],0 size A[i] fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.5*thick
    set arrow 10+i from X[i],0 to X[i]+V[i],0 lw 1.8*thick lc rgb dark front
    set arrow 20+i from X[i]-A[i],-0.05 to P[i],-2.42 nohead dt 3 lc rgb grey
    set arrow 30+i from X[i]+A[i],-0.05 to P[i],-2.42 nohead dt 3 lc rgb grey
    set object 20+i circle at P[i],-2.5 size 0.1 fc rgb blue fs solid noborder front
}
set arrow 51 from 13,-0.55 to 8.5,-2.1 nohead dt 3 lc rgb grey
set arrow 41 from 5.0,1.02 to 6.65,1.02 heads size 0.18,25 lw 1*thick lc rgb red
set arrow 42 from 5.0,0.1 to 5.0,1.15 nohead dt 3 lc rgb red
set arrow 43 from 6.65,0.1 to 6.65,1.15 nohead dt 3 lc rgb red
set label 1 'gap {/:Italic i}' at 5.825,1.42 center tc rgb red
set arrow 44 from 2.4,-2.93 to 4.05,-2.93 heads size 0.18,25 lw 1*thick lc rgb red
set label 2 'gap {/:Italic i}' at 4.25,-2.98 left tc rgb red
set label 3 'body {/:Italic i}' at 4.2,1.12 right tc rgb dark
set label 4 'body {/:Italic i}+1' at 7.05,0.85 left tc rgb dark
set label 5 'body 0' at -0.1,0.85 center tc rgb dark
set label 6 'body {/:Italic N}+1' at 13,0.85 center tc rgb dark
set arrow 45 from 4.2,0 to 4.2-0.566,-0.566 size 0.15,25 lw 1*thick lc rgb '#333333' front
set label 7 '{/:Italic a_i}' at 4.08,-0.42 left tc rgb '#333333' front
set label 8 '{/:Italic x_i}' at 2.3,-2.12 right tc rgb blue
set label 9 '{/:Italic x}_{{/:Italic i}+1}' at 4.2,-2.12 left tc rgb blue
set label 10 'without the radii' at 9.0,-2.5 left tc rgb '#555555'
plot 1/0
