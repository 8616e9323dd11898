# data: build/data/07-gas.dat
# command: build/bin/disks --disks 120 --box 10,10.392304845413264 --packing 0.30 --boundary periodic --every 0.12 --samples 60 -o build/data/07-gas.dat
# data: build/data/07-fluid.dat
# command: build/bin/disks --disks 120 --box 10,10.392304845413264 --packing 0.65 --boundary periodic --warmup 500 --every 0.12 --samples 60 -o build/data/07-fluid.dat
# data: build/data/07-solid.dat
# command: build/bin/disks --disks 120 --box 10,10.392304845413264 --packing 0.74 --boundary periodic --warmup 500 --every 0.12 --samples 60 -o build/data/07-solid.dat
# data: plots/data/07-phases.dat
# slides: 2
# alt: Above, three boxes of 120 disks. Five disks are coloured and have trails of coloured dots, their earlier places; the others have small grey dots. In the first box the trails run right through it; in the second each winds about in one place, some have gone a way; in the third each disk has one small heap of dots and all heaps form a lattice of triangles. Below, the compressibility factor against packing: a curve rises from 1 to 10, falls between 0.69 and 0.72, and rises again along another curve.
height = 12.5
load 'plots/style.gp'
gas = 'build/data/07-gas.dat'
Lx = system("echo ".option(gas, 'box')." | cut -d, -f1") + 0
Ly = system("echo ".option(gas, 'box')." | cut -d, -f2") + 0
# Five disks have trails of their own.
one(i) = i == 40 || i == 58 || i == 88 || i == 100 || i == 46
hue(i) = i == 40 ? 0x0072b2 : i == 58 ? 0xd55e00 : i == 88 ? 0x009e73 : i == 100 ? 0xaa4499 : 0xb07d00
set multiplot
set size ratio -1
unset xtics
unset ytics
set xrange [0:Lx]
set yrange [0:Ly]
do for [k=1:row(1) ? 3 : 0] {
  name = word('gas fluid solid', k)
  file = 'build/data/07-'.name.'.dat'
  eta = real(option(file, 'packing'))
  eval edges(0.01+(k-1)*0.335, 0.32+(k-1)*0.335, slide ? 0.16 : 0.545, slide ? 0.78 : 0.955)
  set label 1 sprintf('{/Symbol h} = %.2f', eta) at graph 0.5,1.05 center
  plot file index 60 using (one($2) ? NaN : $5):6:4 with circles fs solid 0.35 noborder lc rgb '#a9cfe6', \
       file using (one($2) ? NaN : $5):6 with points pt 7 ps 0.05*big lc rgb '#6f8797', \
       file using (one($2) ? $5 : NaN):6:(hue($2)) with points pt 7 ps 0.22*big lc rgb variable, \
       file index 60 using (one($2) ? $5 : NaN):6:4:(hue($2)) with circles lc rgb variable lw 1.5*thick fs empty
}
unset label 1
set size noratio
eval edges(0.08, 0.98, slide ? 0.15 : 0.095, slide ? 0.96 : 0.5)
set xtics 0.1
set ytics 2
set xlabel 'packing {/Symbol h}'
set ylabel '{/:Italic Z} = {/:Italic PV/NkT}' offset 1
set xrange [0:0.8]
set yrange [0:12.5]
set key at graph 0.03,0.95 left top Left reverse samplen 2
full = pi/sqrt(12)
if (row(2)) plot [0:0.8] (x < 0.71 ? (1+x**2/8)/(1-x)**2 : NaN) ls 9 lw 1.6*thick title 'fluid', \
     (x > 0.71 ? 1/(1-sqrt(x/full)) : NaN) ls 9 lw 1.6*thick dt 2 title 'crystal', \
     'plots/data/07-phases.dat' using 1:3 with points ls 1 title 'measured'
