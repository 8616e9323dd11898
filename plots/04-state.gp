# data: build/data/04-energy.dat
# command: build/bin/bonkers --preset piston --until 2000 --every 0.1 | build/bin/piston --study gases --table - -o build/data/04-energy.dat
# data: build/data/04-heavy.dat
# command: build/bin/bonkers --preset adiabatic --particles 11 --mass-ratio 3000 --until 404 --every 4 | build/bin/piston --study gases --table - -o build/data/04-heavy.dat
# alt: Four logarithmic panels: temperature and pressure of both gases against their length, above for the piston of 40 kg, below for one of 4000 kg. The heavy piston's points lie on two straight lines, slope minus 2 for temperature and minus 3 for pressure. The light piston's points begin there and soon scatter, those of the left gas far above, those of the right one below.
width = 14
height = 11
load 'plots/style.gp'
light = 'build/data/04-energy.dat'
heavy = 'build/data/04-heavy.dat'
set multiplot layout 2,2 columnsfirst margins 0.085*room,0.985,0.105*room,0.98 spacing 0.1*room,0.05*room
set logscale xy
set xrange [1:11]
set xtics (1,2,3,5,10)
set ylabel 'temperature {/:Italic kT}  (J)' offset 1
set yrange [0.2:40]
set label 1 '{/:Italic M} = 40 kg, 40 s' at graph 0.05,0.1
set format x ''
# C = 120 J m^2; kT = 2 C / (5 l^2), P = 2 C / l^3
unset key
plot 48/x**2 ls 9 lw 1.5*thick, \
     light every 4 using ($1 <= 40 ? $2 : NaN):7 with points pt 7 ps 0.35*big lc rgb blue, \
     light every 4 using ($1 <= 40 ? 12-$2 : NaN):8 with points pt 8 ps 0.45*big lc rgb green
set format x '%g'
set xlabel 'length {/:Italic l}  (m)'
set key at graph 0.97,0.96 right top samplen 1
set label 1 '{/:Italic M} = 4000 kg, 400 s'
plot 48/x**2 ls 9 lw 1.5*thick title 'adiabat', \
     heavy using 2:7 with points pt 7 ps 0.35*big lc rgb blue title 'left gas', \
     heavy using (12-$2):8 with points pt 8 ps 0.45*big lc rgb green title 'right gas'
unset key
set ylabel 'pressure {/:Italic P}  (N)' offset 1
set yrange [0.1:200]
set format x ''
set xlabel ''
set label 1 '{/:Italic M} = 40 kg, 40 s'
plot 240/x**3 ls 9 lw 1.5*thick, \
     light every 4 using ($1 <= 40 ? $2 : NaN):9 with points pt 7 ps 0.35*big lc rgb blue, \
     light every 4 using ($1 <= 40 ? 12-$2 : NaN):10 with points pt 8 ps 0.45*big lc rgb green
set format x '%g'
set xlabel 'length {/:Italic l}  (m)'
set label 1 '{/:Italic M} = 4000 kg, 400 s'
plot 240/x**3 ls 9 lw 1.5*thick, \
     heavy using 2:9 with points pt 7 ps 0.35*big lc rgb blue, \
     heavy using (12-$2):10 with points pt 8 ps 0.45*big lc rgb green
unset multiplot
