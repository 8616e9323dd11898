# data: build/data/01-rounding.dat
# command: build/bin/collide-forms --study rounding --mass-ratio 3.1622776601683795,1e6 -o build/data/01-rounding.dat
# lecture: build/bin/collide-forms --study rounding --mass-ratio 3.1622776601683795,1e6 --tests 3000000 -o build/data/01-rounding.dat
# data: plots/data/01-cost.dat
# alt: Root mean square energy error of one collision against its cost in nanoseconds for five forms, in two panels. For mass ratios up to 3 all errors lie between 0.6 and 1.2 machine epsilons. For mass ratios up to a million the complement form stands out with an error ten times larger; the form called smaller has the smallest error in both.
height = 7.2
load 'plots/style.gp'
rounding = 'build/data/01-rounding.dat'
cost = 'plots/data/01-cost.dat'

# Row k of both files is form k: 0 cm to 4 smaller.
array ns[5]
array similar[5]
array extreme[5]
do for [k=0:4] {
    stats cost using 2 every ::k::k nooutput
    ns[k+1] = STATS_min
    stats rounding using 4 every ::k::k nooutput
    similar[k+1] = STATS_min
    stats rounding using 4 every ::(k+5)::(k+5) nooutput
    extreme[k+1] = STATS_min
}
names = 'cm difference impulse complement smaller'
# Two forms all but coincide: one is drawn as a frame around the other.
set style line 2 pt 4 ps 0.95*big lw 2*thick

set multiplot layout 1,2 margins 0.105,0.985,0.175,0.895 spacing 0.1,0
set logscale y
set xlabel 'processor time (ns a collision)'
set ylabel 'rms |Δ{/:Italic E}| / {/:Italic E}  (2^{–52})' offset 1
set yrange [0.3:20]
set ytics ('0.3' 0.3, '0.5' 0.5, '1' 1, '2' 2, '5' 5, '10' 10, '20' 20)
stats cost using 2 nooutput
set xrange [floor(0.8*STATS_min):1.1*STATS_max]
set title 'mass ratio to 3.2' offset 0,-0.5
set key at graph 0.95,0.97 right top reverse Left samplen 0.5
plot for [k=1:5] similar using (ns[k]):($1 == k ? $2 : NaN) with points ls k ps 1.3*big title word(names, k)
unset ylabel
set title 'mass ratio to 10^6'
plot for [k=1:5] extreme using (ns[k]):($1 == k ? $2 : NaN) with points ls k ps 1.3*big
