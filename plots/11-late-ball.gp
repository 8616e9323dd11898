# data: build/data/11-late-ball.dat
# command: build/bin/spheres-studies --study late -o build/data/11-late-ball.dat
# alt: Two panels with logarithmic axes against the step from 0.0005 to 4 diameters. Left, pushed apart: the error of the velocities stays at 1e-16 up to about 0.7 diameters and jumps to 1 above; the error of the last ball's place rises in proportion to the step, from 1e-4 to 0.1 metres. Right, going back: both are rounding errors, below 1e-12, up to about one diameter, and of order one above.
load 'plots/style.gp'
file = 'build/data/11-late-ball.dat'
set multiplot layout 1,2 margins 0.1,0.985,0.17,0.9 spacing 0.09,0
eval powers
set xrange [4e-4:5]
set yrange [1e-17:10]
set xlabel '{/:Italic v dt} / 2{/:Italic r}'
set ylabel 'error of places (m), of velocities (m/s)' offset 1
set title 'pushed apart' offset 0,-0.6
set key at graph 0.03,0.6 left top samplen 1
tiny(x) = x > 1e-17 ? x : 2e-17
plot file using ($1/0.2):(tiny($5)) with points ls 2 title 'place', \
     file using ($1/0.2):(tiny($4)) with points ls 1 title 'velocities'
set title 'going back'
set ylabel ''
plot file using ($1/0.2):(tiny($7)) with points ls 2, \
     file using ($1/0.2):(tiny($6)) with points ls 1
