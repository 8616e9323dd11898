# data: build/data/12-averages.dat
# command: build/bin/averages-studies --study digits -o build/data/12-averages.dat
# alt: Left, price of a pressure of 250 disks against tolerance: by events 0.04 s down to 0.01, then rising; by a chain 0.3 s at 0.1 and 2 s at 0.02. Right, price of a mean place of one of four disks: the chain is cheaper than events at every tolerance from 0.1 to 0.005; both rise about as the tolerance to the power of minus two, events more steeply at the end.
width = 14
height = 6.5
load 'plots/style.gp'
file = 'build/data/12-averages.dat'
set multiplot layout 1,2 margins 0.105,0.985,0.18,0.96 spacing 0.12,0
set logscale xy
set xrange [0.14:0.0035]
set xtics ('0.1' 0.1, '0.05' 0.05, '0.02' 0.02, '0.01' 0.01, '0.005' 0.005)
set format y '10^{%T}'
set yrange [0.003:10]
set xlabel 'tolerance {/:Italic e}'
set ylabel 'price  (s)'
set key at graph 0.03,0.97 left top samplen 1
plot file using 1:2 with linespoints ls 1 title 'events', \
     file using 1:3 with linespoints ls 2 title 'chain'
unset ylabel
set key samplen 1
plot 6e-6/x**2 ls 9 lw 2*thick title '{/:Italic e}^{-2}', \
     file using 1:4 with linespoints ls 1 title 'events', \
     file using 1:5 with linespoints ls 2 title 'chain'
unset multiplot
