# data: build/data/03-states.dat
# command: build/bin/bonkers --preset thermal --every 10 --samples 2000 -o build/data/03-states.dat
# alt: Scatter plot of velocity against position of the first ball: dense near the wall and near velocity zero, the same spread of velocities at every position. Contour lines of the product of the two laws follow the cloud.
load 'plots/style.gp'
file = 'build/data/03-states.dat'
fast = sqrt(10/mass(file, 1))
# The density, in units of its greatest value, is (1-x/11)^9 (1-(v/fast)^2)^3.5; where
# it is q, solved for v:
edge(x,q) = q/(1-x/11)**9 < 1 ? fast*sqrt(1-(q/(1-x/11)**9)**(1/3.5)) : NaN
set samples 2000
set xrange [0:5]
set yrange [-3.3:3.3]
set xlabel '{/:Italic x}_1  (m)'
set ylabel '{/:Italic v}_1  (m/s)' offset 1
eval edges(0.085, 0.985, 0.18, 0.97)
plot file every ::1 using 5:6 with points pt 7 ps 0.28*big lc rgb blue, \
     for [q in '0.5 0.1 0.01'] edge(x,q+0) lc rgb dark lw 1.2*thick, \
     for [q in '0.5 0.1 0.01'] -edge(x,q+0) lc rgb dark lw 1.2*thick
