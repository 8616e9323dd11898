# data: build/data/02-collapse.dat
# command: build/bin/bonkers-studies --study collapse -o build/data/02-collapse.dat
# alt: Number of collisions of two equal balls and a wall until they part, against the restitution from 0.1 to 0.6. The points follow the line two pi over phi, fall from 74 beside the dashed border at 0.1716 to 4 at 0.5, and there are none to the left of the border.
width = 12
load 'plots/style.gp'
file = 'build/data/02-collapse.dat'
set logscale y
set xlabel 'restitution {/:Italic e}'
set ylabel 'collisions' offset 0.8
set xrange [0.08:0.6]
set yrange [2:120]
set ytics (2, 3, 5, 10, 20, 30, 50, 100)
eval edges(0.115, 0.98, 0.165, 0.97)
border = 3 - 2*sqrt(2)
set arrow 1 from border,2 to border,120 nohead ls 9 dt 2
set label 1 "without\nend" at 0.126,15 center tc rgb '#555555'
phi(e) = acos((1-e)**2/(4*e))
set samples 2000
plot (x > border+1e-4 ? 2*pi/phi(x) : NaN) ls 9, \
     file using 1:($2 > 0 ? $2 : NaN) every 2 with points ls 1
