# data: plots/data/06-reference.dat
# alt: Three copies of a square box with a smaller dashed square inside it, the room of the centres. In each there is one disk, with a shaded disk of twice its radius around it: in the middle it lies inside the dashed square, at a wall and in a corner a half and three quarters of it lie outside.
height = 5.2
load 'plots/style.gp'
r = 0.15
set multiplot layout 1,3 margins 0.01,0.99,0.02,0.9 spacing 0.03,0
eval drawing
set xrange [-0.16:1.02]
set yrange [-0.16:1.02]
array X[3]; array Y[3]; array T[3]
X[1] = 0.5; Y[1] = 0.5; T[1] = 'in the middle'
X[2] = r; Y[2] = 0.5; T[2] = 'at a wall'
X[3] = r; Y[3] = r; T[3] = 'in a corner'
do for [k=1:3] {
    set title T[k] offset 0,-0.6
    set object 1 circle at X[k],Y[k] size 2*r fc rgb '#f7d9c4' fs solid noborder
    # What lies outside the room of the centres costs nothing.
    set object 2 rectangle from -0.3,-0.3 to r,1.3 fc rgb 'white' fs solid noborder
    set object 3 rectangle from -0.3,-0.3 to 1.3,r fc rgb 'white' fs solid noborder
    set object 4 circle at X[k],Y[k] size 2*r fs empty border lc rgb red dt 3 lw 1*thick
    set object 5 circle at X[k],Y[k] size r fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.5*thick
    set object 6 rectangle from r,r to 1-r,1-r fs empty border lc rgb dark dt 2 lw 1*thick
    set object 7 rectangle from 0,0 to 1,1 fs empty border lc rgb dark lw 2*thick
    plot 1/0
}
