# data: build/data/03-states.dat
# command: build/bin/bonkers --preset thermal --every 10 --samples 2000 -o build/data/03-states.dat
# alt: Two scatter plots of pairs of velocities on one scale, two light balls on the left and two heavy balls on the right. Both clouds are round; the second is half as wide. Ellipses hold half and nine tenths of the law, and all of it.
height = 7.2
load 'plots/style.gp'
file = 'build/data/03-states.dat'
# masses of movers 1, 2, 9 and 10, E = 5 J: the fastest has sqrt(2E/m)
fast(m) = sqrt(10/m)
array m[4] = [mass(file, 1), mass(file, 2), mass(file, 9), mass(file, 10)]
radius(q) = sqrt(1-(1-q)**0.25)
set parametric
set trange [0:2*pi]
set samples 200
set size square
set multiplot layout 1,2 margins 0.085,0.985,0.18,0.97 spacing 0.12,0
set xrange [-3.4:3.4]
set yrange [-3.4:3.4]
set tics 1
set xlabel '{/:Italic v}_1  (m/s)'
set ylabel '{/:Italic v}_2  (m/s)' offset 1
dot = 0.22*big
plot file every ::1 using 6:8 with points pt 7 ps dot lc rgb blue, \
     for [q in '0.5 0.9 1'] fast(m[1])*radius(q)*cos(t), fast(m[2])*radius(q)*sin(t) lc rgb dark lw 1.1*thick
set xlabel '{/:Italic v}_9  (m/s)'
set ylabel '{/:Italic v}_{10}  (m/s)' offset 0.4
plot file every ::1 using 22:24 with points pt 7 ps dot lc rgb red, \
     for [q in '0.5 0.9 1'] fast(m[3])*radius(q)*cos(t), fast(m[4])*radius(q)*sin(t) lc rgb dark lw 1.1*thick
