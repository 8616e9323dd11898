# data: build/data/11-moment.dat
# command: build/bin/spheres-studies --study moment -o build/data/11-moment.dat
# data: build/data/11-moment-located.dat
# command: printf 'pos 0 0 0 1 1 0 0.1\ngrav 0 0 -2\nbox 0 0 0 0 -0.1 9\nwalls open open hard\ncontact\nrestitution 0.8\ndt 0.2\n' | build/bin/step - --contact located --until 12 --observe z:0 --every 0.2 -o build/data/11-moment-located.dat
# data: build/data/11-moment-stepwise.dat
# command: printf 'pos 0 0 0 1 1 0 0.1\ngrav 0 0 -2\nbox 0 0 0 0 -0.1 9\nwalls open open hard\ncontact\nrestitution 0.8\ndt 0.2\n' | build/bin/step - --until 12 --observe z:0 --every 0.2 -o build/data/11-moment-stepwise.dat
# data: build/data/11-moment-path.dat
# command: printf 'pos 0 0 0 1 1 0 0.1\ngrav 0 0 -2\nbox 0 0 0 0 -0.1 9\nwalls open open hard\ncontact\nrestitution 0.8\ndt 0.01\n' | build/bin/step - --contact located --until 12 --observe z:0 --every 0.01 -o build/data/11-moment-path.dat
# alt: Two panels. Left: the height of a bouncing ball against time, ever lower arches that end at nine seconds. Circles, located contacts, lie on the arches and on the floor after them; squares, stepwise, leave the arches after some bounces and go on jumping. Right, logarithmic: the error of three balls against the step. Stepwise it falls in proportion to the step and scatters; located it falls with slope 2 by leapfrog, 4 by RK4 and 8 by Kahan and Li's method down to rounding.
load 'plots/style.gp'
load 'plots/methods.gp'
set multiplot layout 1,2 margins 0.08,0.985,0.165,0.9 spacing 0.1,0
set xrange [0:12]
set yrange [-0.05:1.35]
set ytics 0.2
set xtics 3
set xlabel 'time  (s)'
set ylabel 'height  (m)' offset 1.2
set key at graph 0.98,0.97 right top samplen 1
plot 'build/data/11-moment-path.dat' using 1:2 with lines ls 9, \
     'build/data/11-moment-stepwise.dat' using 1:2 with points lc rgb dark pt 4 ps 0.5*big title 'stepwise', \
     'build/data/11-moment-located.dat' using 1:2 with points lc rgb blue pt 7 ps 0.4*big title 'located'
eval powers
set xrange [2e-4:0.3]
set yrange [1e-14:3]
set xtics autofreq
set ytics 1e-14,100
set xlabel 'step  (s)'
set ylabel 'error  (m)' offset 1.2
set label 1 'stepwise' at 5e-4,0.9
set label 2 name_of('leapfrog') at 3e-3,2e-5
set label 3 name_of('rk4') at 6e-3,2e-10
set label 4 name_of('kahan-li8') at 2.2e-2,2e-13
file = 'build/data/11-moment.dat'
plot file using 1:2 with points lc rgb dark pt 4 ps 0.5*big, \
     for [name in 'leapfrog rk4 kahan-li8'] file using 1:column_of(file, name) with points ls style_of(name)
