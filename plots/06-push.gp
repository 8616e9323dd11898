# data: plots/data/06-reference.dat
# alt: Three disks in a loose row, drawn dashed where they stood and solid where they end. The first moves right until it touches the second, the second goes on until it touches the third, which moves until the length of the chain is used up. Grey disks stand still.
height = 5.1
load 'plots/style.gp'
eval drawing
set xrange [-0.4:9.0]
set yrange [-1.1:2.3]
set margins 0,0,0,0
r = 0.5
array X[3] = [0.7, 3.1, 5.9]
array Y[3] = [0.45, 0.85, 0.35]
array E[3]
reach(a,b) = sqrt(4*r*r - (a-b)**2)
E[1] = X[2] - reach(Y[1],Y[2])
E[2] = X[3] - reach(Y[2],Y[3])
E[3] = X[3] + 1.35
array G[6] = [1.3, 3.6, 4.1, 6.7, 8.2, 8.35]
array H[6] = [1.75, -0.55, 1.75, -0.55, -0.35, 1.2]
do for [k=1:6] { set object 30+k circle at G[k],H[k] size r fc rgb '#eeeeee' fs solid border lc rgb grey lw 1*thick }
do for [k=1:3] {
    set object k circle at X[k],Y[k] size r fs empty border lc rgb blue dt 2 lw 1*thick
    set object 10+k circle at E[k],Y[k] size r fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.5*thick
    set arrow k from X[k],Y[k] to E[k],Y[k] lw 2*thick lc rgb dark front
}
set label 1 '{/:Italic i}' at X[1]-0.28,Y[1]+0.02 center front
set label 2 '{/:Italic j}' at X[2]-0.28,Y[2]+0.02 center front
set label 3 '{/:Italic k}' at X[3]-0.28,Y[3]+0.02 center front
# What the push gains by each touch.
set arrow 11 from E[1],Y[1]-0.62 to X[2],Y[1]-0.62 heads size 0.09,20 lw 1*thick lc rgb red front
set arrow 12 from E[1],Y[1]-0.05 to E[1],Y[1]-0.7 nohead dt 3 lw 0.8*thick lc rgb red front
set arrow 13 from X[2],Y[2]-0.05 to X[2],Y[1]-0.7 nohead dt 3 lw 0.8*thick lc rgb red front
set label 11 '{/:Italic x_j} − {/:Italic x_i}' at (E[1]+X[2])/2+0.02,Y[1]-0.86 center tc rgb red front
set arrow 14 from E[2],Y[2]+0.62 to X[3],Y[2]+0.62 heads size 0.09,20 lw 1*thick lc rgb red front
set arrow 15 from E[2],Y[2]+0.05 to E[2],Y[2]+0.7 nohead dt 3 lw 0.8*thick lc rgb red front
set arrow 16 from X[3],Y[3]+0.05 to X[3],Y[2]+0.7 nohead dt 3 lw 0.8*thick lc rgb red front
set label 12 '{/:Italic x_k} − {/:Italic x_j}' at (E[2]+X[3])/2,Y[2]+0.86 center tc rgb red front
plot 1/0
