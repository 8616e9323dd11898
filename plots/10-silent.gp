# data: build/data/10-silent.dat
# command: build/bin/springs-studies --study silent -o build/data/10-silent.dat
# alt: Stretch of the upper spring over the first three seconds. With a small step it oscillates fast between zero and a millimetre and a half round a slow curve. RK4 with a step of 0.025 seconds starts like that and within half a second shows the slow curve alone.
height = 6.5
load 'plots/style.gp'
load 'plots/methods.gp'
eval edges(0.085, 0.985, 0.17, 0.97)
set xlabel 'time  (s)'
set ylabel 'stretch of the upper spring  (mm)' offset 1
set xrange [0:3]
set yrange [-0.2:2.4]
set key at graph 0.98,0.97 right top samplen 1.5
plot 'build/data/10-silent.dat' using 1:($4*1e3) with linespoints ls style_of('yoshida4') ps 0.4*big title 'small step', \
     '' using 1:($2*1e3) with linespoints ls style_of('rk4') title name_of('rk4').', {/:Italic dt} = 0.025 s'
