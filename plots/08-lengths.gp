# data: build/data/08-lengths.dat
# command: build/bin/step-studies --study lengths -o build/data/08-lengths.dat
# alt: Three panels. Left: the tracks of three bodies from rest at the corners of a right triangle, tangled, for sixteen seconds. Middle: two of them about their common centre, in thousandths of a metre: two hairpins that turn back at two tenths from the centre. Right: the length of the steps against time, logarithmic; it falls from a tenth of a second to less than a millionth in a narrow notch at 15.83 seconds, and to between a ten-thousandth and a hundredth in several others; steps of dopri5 are shorter than those of radau15 by a factor of five.
height = 5.2
load 'plots/style.gp'
load 'plots/methods.gp'
file = 'build/data/08-lengths.dat'
set multiplot
eval edges(0.07, 0.36, 0.21, 0.96)
set size ratio -1
set xrange [-3.2:3.6]
set yrange [-2.2:3.7]
set tics 2
set xlabel '{/:Italic x}  (m)'
set ylabel '{/:Italic y}  (m)' offset 0.9
plot file index 0 using 2:3 with lines ls 1 lw thick notitle, \
     file index 0 using 4:5 with lines ls 2 lw thick notitle, \
     file index 0 using 6:7 with lines ls 3 lw thick notitle, \
     file index 0 every ::0::0 using 2:3 with points ls 1 ps 1.1*big notitle, \
     file index 0 every ::0::0 using 4:5 with points ls 2 ps 1.1*big notitle, \
     file index 0 every ::0::0 using 6:7 with points ls 3 ps 1.3*big notitle
set lmargin at screen 0.455
set rmargin at screen 0.65
set xrange [-1.7:1.7]
set yrange [-1.5:1.8]
set tics 1
set xlabel '{/:Italic x}  (mm)'
set ylabel '{/:Italic y}  (mm)' offset 0.9
plot file index 1 using (1e3*$1):(1e3*$2) with linespoints ls 2 ps 0.25*big lw thick notitle, \
     file index 1 using (1e3*$3):(1e3*$4) with linespoints ls 3 ps 0.3*big lw thick notitle
set size noratio
set lmargin at screen 0.77
set rmargin at screen 0.975
set logscale y
set format y '10^{%T}'
set xrange [0:20]
set yrange [1e-8:3]
set xtics 10
set ytics 100
set xlabel 'time  (s)'
set ylabel 'length of a step  (s)' offset 0.2
set key at graph 0.03,0.04 left bottom samplen 1.5 Left reverse
plot file index 2 using 1:2 with lines ls style_of('radau15') lw thick title name_of('radau15'), \
     file index 3 using 1:2 with lines ls style_of('dopri5') lw thick title name_of('dopri5')
