# data: plots/data/06-reference.dat
# alt: Left: two big disks, each with a shaded zone around it; the zones overlap in a dark lens between the disks. Small disks lie outside. Right: a big disk near a wall; its zone overlaps the zone along the wall in a dark segment.
height = 5
load 'plots/style.gp'
R = 1.0; d = 0.3; Z = R + d; s = 2.25; x = 1.15
eval drawing
set xrange [-1.5:8.2]
set yrange [-1.55:1.55]
set margins 0,0,0,0
big = '#cfe3f1'; zone = '#f7d9c4'; both = '#d55e00'
# The lens between two zones; the segment that a wall's zone cuts off.
set print $lens
c = acos(s/2/Z)
do for [k=-20:20] { print Z*cos(c*k/20.0), Z*sin(c*k/20.0) }
do for [k=-20:20] { print s-Z*cos(c*k/20.0), -Z*sin(c*k/20.0) }
unset print
w = 5.2; X = w + x; h = x - d; c = acos(h/Z)
set print $segment
do for [k=-20:20] { print X-Z*cos(c*k/20.0), Z*sin(c*k/20.0) }
unset print
set object 1 circle at 0,0 size Z fc rgb zone fs solid border lc rgb red lw 1*thick
set object 2 circle at s,0 size Z fc rgb zone fs solid border lc rgb red lw 1*thick
set object 3 rectangle from w,-1.5 to w+d,1.5 fc rgb zone fs solid border lc rgb red lw 1*thick
set object 4 circle at X,0 size Z fc rgb zone fs solid border lc rgb red lw 1*thick
set object 11 circle at 0,0 size R fc rgb big fs solid border lc rgb blue lw 1.5*thick front
set object 12 circle at s,0 size R fc rgb big fs solid border lc rgb blue lw 1.5*thick front
set object 13 circle at X,0 size R fc rgb big fs solid border lc rgb blue lw 1.5*thick front
set object 14 rectangle from w-0.25,-1.5 to w,1.5 fc rgb '#999999' fs solid noborder
array A[8] = [1.12, 3.9, 4.25, 3.75, 4.5, 7.85, 7.8, 4.4]
array B[8] = [1.2, 0.9, -0.4, -1.1, 0.35, 1.1, -1.05, -1.15]
do for [k=1:8] { set object 20+k circle at A[k],B[k] size d fs empty border lc rgb green lw 1.5*thick front }
set arrow 1 from 0,0 to s,0 heads lw 1*thick front
set label 1 '{/:Italic s}' at 0.35,0.18 front
set arrow 2 from w,-0.0 to X,0 heads lw 1*thick front
set label 2 '{/:Italic x}' at X-0.3,0.18 front
set arrow 3 from 0,0 to -Z*0.8,Z*0.6 lw 1*thick front
set label 3 '{/:Italic R_d}' at -0.5,0.7 front
plot $lens using 1:2 with filledcurves closed fc rgb both, $segment using 1:2 with filledcurves closed fc rgb both
