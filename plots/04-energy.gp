# data: build/data/04-energy.dat
# command: build/bin/bonkers --preset piston --until 2000 --every 0.1 | build/bin/piston --study gases --table - -o build/data/04-energy.dat
# data: build/data/04-swing.dat
# command: build/bin/piston --gas-masses 0,0 -o build/data/04-swing.dat
# slides: 3
# alt: Three panels of energy against time. First 40 seconds: the piston's energy falls from 20 joules to almost nothing at 6 seconds, when the right gas holds nearly everything, and comes back partly; the smooth curves of the model come back wholly. 200 seconds: the exchange goes on with smaller swings. 2000 seconds: noise, the two gases around 12 joules each, the piston around 2 to 3.
width = 14
height = 11
load 'plots/style.gp'
file = 'build/data/04-energy.dat'
model = 'build/data/04-swing.dat'
set multiplot layout slide ? 1 : 3,1 margins 0.085,0.965,slide ? 0.15 : 0.11,slide ? 0.91 : 0.94 spacing 0,0.085
if (slide) set xlabel 'time {/:Italic t}  (s)'
set yrange [0:27]
set ytics 10
set ylabel 'energy  (J)' offset 1
set key at screen 0.52,0.995 center top horizontal samplen 1.5 maxrows 1
set xrange [0:40]
if (row(1)) plot file using 1:($1 <= 40 ? $5 : NaN) with lines lw 1.5*thick lc rgb blue title 'left gas', \
     file using 1:($1 <= 40 ? $6 : NaN) with lines lw 1.5*thick lc rgb green dt (6,2) title 'right gas', \
     file using 1:($1 <= 40 ? $4 : NaN) with lines lw 2.5*thick lc rgb purple title 'piston', \
     model using 1:6 with lines ls 9 dt 3 lw 2*thick title 'piston, model'
if (!slide) unset key
set xrange [0:200]
if (row(2)) plot file using 1:($1 <= 200 ? $5 : NaN) with lines lw 0.7*thick lc rgb blue title 'left gas', \
     file using 1:($1 <= 200 ? $6 : NaN) with lines lw 0.7*thick lc rgb green dt (6,2) title 'right gas', \
     file using 1:($1 <= 200 ? $4 : NaN) with lines lw 1.5*thick lc rgb purple title 'piston'
set xlabel 'time {/:Italic t}  (s)'
set xrange [0:2000]
if (row(3)) plot file every 10 using 1:5 with lines lw 0.5*thick lc rgb blue title 'left gas', \
     file every 10 using 1:6 with lines lw 0.5*thick lc rgb green title 'right gas', \
     file every 10 using 1:4 with lines lw 0.8*thick lc rgb purple title 'piston', \
     80.0/33 with lines ls 5 lw 1*thick dt 2
unset multiplot
