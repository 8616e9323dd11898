# data: build/data/04-energy.dat
# command: build/bin/bonkers --preset piston --until 2000 --every 0.1 | build/bin/piston --study gases --table - -o build/data/04-energy.dat
# data: build/data/04-swing.dat
# command: build/bin/piston --gas-masses 0,0 -o build/data/04-swing.dat
# slides: 3
# alt: Three panels in which the energies of left gas, piston and right gas are stacked up to 26.7 joules, against time. First 40 seconds: the piston has 20 joules, gives nearly all to the right gas at 6 seconds, and gets about half of it back; dotted lines of the model, where it gets all of it back. 200 seconds: the left and the right gas swell in turn, the piston in between has less and less. 2000 seconds, means over a swing: the band of the piston narrows towards two dashed lines, one eleventh of all.
height = 11
load 'plots/style.gp'
file = 'build/data/04-energy.dat'
model = 'build/data/04-swing.dat'
# The three energies stand on top of each other: left gas, piston, right gas.
total = 80.0/3
soft = '#9ecae8'; warm = '#c994c7'; fresh = '#a8dcc9'
# The last panel shows means over one swing, 20 s.
set table $mean
plot file using (20*floor($1/20)+10):5 smooth unique
set table $upper
plot file using (20*floor($1/20)+10):($5+$4) smooth unique
unset table
set multiplot layout slide ? 1 : 3,1 margins 0.085,0.965,slide ? 0.15 : 0.11,slide ? 0.91 : 0.94 spacing 0,0.085
if (slide) set xlabel 'time {/:Italic t}  (s)'
set yrange [0:total]
set ytics 10
set ylabel 'energy  (J)' offset 1
set key at screen 0.52,0.995 center top horizontal samplen 1.5 maxrows 1
do for [k=1:2] {
    last = k == 1 ? 40 : 200
    set xrange [0:last]
    if (k == 2 && !slide) { unset key }
    if (row(k)) {
        plot file using ($1 <= last ? $1 : NaN):5:(0) with filledcurves lc rgb soft title 'left gas', \
             file using ($1 <= last ? $1 : NaN):5:($5+$4) with filledcurves lc rgb warm title 'piston', \
             file using ($1 <= last ? $1 : NaN):($5+$4):(total) with filledcurves lc rgb fresh title 'right gas', \
             model using (k == 1 ? $1 : NaN):4 with lines lc rgb dark dt 3 lw 1.5*thick title 'model', \
             model using (k == 1 ? $1 : NaN):($4+$6) with lines lc rgb dark dt 3 lw 1.5*thick
    }
}
set xlabel 'time {/:Italic t}  (s)'
set xrange [10:1990]
set xtics 0,500
if (row(3)) plot total lc rgb warm with filledcurves y1=0 title 'piston', \
     $mean using 1:2:(0) with filledcurves lc rgb soft title 'left gas', \
     $upper using 1:2:(total) with filledcurves lc rgb fresh title 'right gas', \
     total*5/11 with lines lc rgb dark dt 2 lw 1.2*thick, total*6/11 with lines lc rgb dark dt 2 lw 1.2*thick
