# alt: Place against time of three equal bodies between two walls: straight lines that cross and are reflected at the walls, thin and white, full, dashed and dotted; around them, thick and in colour, the ways of the left, the middle and the right body, which change from one line to another at each crossing and never cross.
width = 11
height = 4.8
load 'plots/style.gp'
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
