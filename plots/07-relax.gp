# data: build/data/07-relax-250.dat
# command: build/bin/disks --disks 250 --radius 0.1 --box 7.5,5 --measure relaxation --every 0.05 --until 4 -o build/data/07-relax-250.dat
# data: build/data/07-relax-100000.dat
# command: build/bin/disks --disks 100000 --radius 0.1 --box 150,100 --measure relaxation --every 0.05 --until 4 -o build/data/07-relax-100000.dat
# lecture: build/bin/disks --disks 1000000 --radius 0.1 --box 474.3416490252569,316.2277660168379 --measure relaxation --every 0.05 --until 4 -o build/data/07-relax-100000.dat
# alt: Left, the mean fourth power of the speed against collisions of a disk: from 1 it rises along a straight dashed line at first and then bends towards 2, which it has reached after some twelve collisions; the points of 250 disks scatter about those of 100000. Right, Boltzmann's H falls from one half to minus 2.14 in about four collisions and stays there; that of 250 disks fluctuates a little above.
height = 6.8
load 'plots/style.gp'
few = 'build/data/07-relax-250.dat'
many = 'build/data/07-relax-100000.dat'
set multiplot layout 1,2 margins 0.085,0.985,0.18,0.97 spacing 0.11,0
set xlabel 'collisions of a disk {/:Italic c}'
set ylabel '<{/:Italic v}^4>  (m^4/s^4)' offset 1.5
set xrange [0:15]
set yrange [0.9:2.3]
set ytics 0.2
set key at graph 0.97,0.05 right bottom samplen 1.5
plot (x < 5 ? 1+x*64/225 : NaN) ls 9 dt 2 lw 1.6*thick title 'first collisions', \
     2 ls 9 lw 1.6*thick title 'equilibrium', \
     few using 2:3 with points pt 6 ps 0.4*big lc rgb red title '250', \
     many using 2:3 with points ls 1 ps 0.4*big title '100 000'
set ylabel '{/:Italic H}' offset 1
set yrange [-2.4:0.8]
set ytics 0.5
plot -1-log(pi) ls 9 lw 1.6*thick, \
     few using 2:4 with points pt 6 ps 0.4*big lc rgb red, \
     many using 2:4 with points ls 1 ps 0.4*big
