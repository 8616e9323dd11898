# data: build/data/09-softening.dat
# command: build/bin/gravity-studies --study softening -o build/data/09-softening.dat
# alt: Logarithmic: by how much an ellipse of eccentricity 0.2 turns back in an orbit, and by how much the period of a circle is too long, against the softening from 0.001 to 0.3. Both rise with slope two; the points of the runs lie on the line of the theory up to a softening of about 0.1 and fall below it beyond.
height = 6.4
load 'plots/style.gp'
file = 'build/data/09-softening.dat'
eval edges(0.11, 0.985, 0.19, 0.97)
eval powers
set xlabel 'softening {/Symbol e}  (AU)'
set ylabel 'per orbit' offset -0.3
set xrange [7e-4:0.5]
set yrange [3e-7:5]
set key at graph 0.03,0.95 left top Left reverse samplen 2
plot 3*pi*x**2/0.64 ls 9 notitle, x**2*3/4 ls 9 notitle, \
     file using 1:(-$3) with points ls 1 title 'turn of the ellipse, backwards  (rad)', \
     file using 1:4 with points ls 2 title 'period too long'
