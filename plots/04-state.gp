# data: build/data/04-energy.dat
# command: build/bin/bonkers --preset piston --until 2000 --every 0.1 | build/bin/piston --study gases --table - -o build/data/04-energy.dat
# data: build/data/04-heavy.dat
# command: build/bin/bonkers --preset adiabatic --particles 11 --mass-ratio 3000 --until 404 --every 4 | build/bin/piston --study gases --table - -o build/data/04-heavy.dat
# slides: 2
# alt: To part the two gases, the right one is drawn five times lower. Four logarithmic panels: temperature and pressure of both gases against their length, above for the piston of 40 kg, below for one of 4000 kg. The heavy piston's points lie on two straight lines, slope minus 2 for temperature and minus 3 for pressure. The light piston's points begin there and soon scatter, those of the left gas far above, those of the right one below.
height = 11
load 'plots/style.gp'
light = 'build/data/04-energy.dat'
heavy = 'build/data/04-heavy.dat'
set multiplot layout slide ? 1 : 2,2 columnsfirst margins 0.085,0.985,slide ? 0.15 : 0.11,slide ? 0.91 : 0.98 spacing 0.1,0.05
set logscale xy
set xrange [1:11]
set xtics (1,2,3,5,10)
if (slide) { set key at screen 0.52,0.995 center top horizontal maxrows 1 samplen 0.6 width -2 } else { unset key }
do for [side=1:2] {
    power = side + 1
    set ylabel (side == 1 ? 'temperature {/:Italic kT}  (J)' : 'pressure {/:Italic P}  (N)') offset 1
    if (side == 1) { set yrange [0.05:40] } else { set yrange [0.02:200] }
    c = side == 1 ? 48 : 240
    set label 1 '{/:Italic M} = 40 kg, 40 s' at graph 0.05,0.1
    if (!slide) { set format x ''; set xlabel '' } else { set xlabel 'length {/:Italic l}  (m)' }
    if (side == 2) { unset key }
    if (row(1)) {
        plot c/x**power ls 9 lw 1.5*thick title 'adiabats', c/x**power/5 ls 9 lw 1.5*thick, \
             light every 4 using ($1 <= 40 ? $2 : NaN):(column(5+2*side)) with points pt 7 ps 0.35*big lc rgb blue title 'left gas', \
             light every 4 using ($1 <= 40 ? 12-$2 : NaN):(column(6+2*side)/5) with points pt 8 ps 0.45*big lc rgb green title 'right gas / 5'
    }
    set format x '%g'
    set xlabel 'length {/:Italic l}  (m)'
    set label 1 '{/:Italic M} = 4000 kg, 400 s'
    if (!slide && side == 1) { set key top right samplen 0.8 } else { unset key }
    if (row(2)) {
        plot c/x**power ls 9 lw 1.5*thick title 'adiabats', c/x**power/5 ls 9 lw 1.5*thick, \
             heavy using 2:(column(5+2*side)) with points pt 7 ps 0.35*big lc rgb blue title 'left gas', \
             heavy using (12-$2):(column(6+2*side)/5) with points pt 8 ps 0.45*big lc rgb green title 'right gas / 5'
    }
}
