# alt: A sketch. A dotted circle of radius sigma around the centre of disk 1. A straight path enters it from the right at A and goes on to B inside. From A a blue path leaves outwards, reflected at the normal through A. A red normal from the centre through B leads to C on the circle, from where a red path leaves in a direction that is turned a little, and starts behind the blue one.
height = 7.2
load 'plots/style.gp'
eval drawing
set margins 0,0,0,0
set xrange [-3.2:9.4]
set yrange [-1.8:lecture ? 5.3 : 4.7]
s = 3.0
# The path comes from the right at an angle; A on the circle at 32 degrees.
ta = 38*pi/180
ax = s*cos(ta)
ay = s*sin(ta)
tv = 197*pi/180   # direction of flight
ux = cos(tv)
uy = sin(tv)
tau = 1.15
bx = ax + ux*tau
by = ay + uy*tau
db = sqrt(bx*bx + by*by)
nbx = bx/db
nby = by/db
cx = s*nbx
cy = s*nby
nax = cos(ta)
nay = sin(ta)
pa = ux*nax + uy*nay
vax = ux - 2*pa*nax
vay = uy - 2*pa*nay
pb = ux*nbx + uy*nby
vbx = ux - 2*pb*nbx
vby = uy - 2*pb*nby
set object 1 circle at 0,0 size 1.5 fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1.5*thick
set object 2 circle at 0,0 size s fs empty border lc rgb '#555555' lw 1*thick dt 3
set arrow 1 from ax-ux*5.2,ay-uy*5.2 to ax,ay nohead lw 1.5*thick lc rgb dark
set arrow 2 from ax-ux*5.2,ay-uy*5.2 to ax-ux*2.8,ay-uy*2.8 lw 1.5*thick lc rgb dark
set arrow 3 from ax,ay to bx,by nohead lw 1.5*thick lc rgb dark
set arrow 4 from 0,0 to ax,ay nohead dt 2 lw 1*thick lc rgb blue
set arrow 5 from 0,0 to cx,cy nohead dt 2 lw 1*thick lc rgb red
# after the time tau: true and pushed
set arrow 6 from ax,ay to ax+vax*2.9,ay+vay*2.9 lw 2*thick lc rgb blue
set arrow 7 from cx,cy to cx+vbx*1.75,cy+vby*1.75 lw 2*thick lc rgb red
set object 3 circle at ax,ay size 0.07 fc rgb blue fs solid noborder front
set object 4 circle at bx,by size 0.07 fc rgb dark fs solid noborder front
set object 5 circle at cx,cy size 0.07 fc rgb red fs solid noborder front
set object 6 circle at ax+vax*tau,ay+vay*tau size 0.07 fc rgb blue fs solid noborder front
set label 1 '{/:Italic A}' at ax+0.25,ay-0.15 left tc rgb blue
set label 2 '{/:Italic B}' at bx-0.15,by+0.22 right tc rgb dark front
set label 3 '{/:Italic C}' at cx-0.16,cy+0.32 right tc rgb red
set label 4 '1' at -0.15,-0.35 center tc rgb dark
set label 5 'σ' at 0.62*ax+0.2,0.62*ay-0.12 tc rgb '#333333'
set label 6 'found after τ' at bx-0.45,by+0.22 right tc rgb '#555555' front
set label 7 'by events, after τ' at ax+vax*tau+0.45,ay+vay*tau+0.55 left tc rgb blue
set label 8 'pushed out, after τ' at cx-0.16,cy+1.25 right tc rgb red
set label 9 '{/:Bold v}' at ax-ux*3.6,ay-uy*3.6+0.35 tc rgb dark
plot NaN
