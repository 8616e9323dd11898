# data: plots/data/06-chains.dat
# alt: Two panels, error of the pressure Z against processor time, both logarithmic, for packing 0.3 and 0.65. In each, event chains and dynamics fall together, and the random walk lies ten times higher.
load 'plots/style.gp'
file = 'plots/data/06-chains.dat'
list = 'markov dynamics chains'
name(k) = k == 1 ? 'walk, slides' : k == 2 ? 'dynamics' : 'event chains'
set multiplot layout 1,2 margins 0.1,0.985,0.17,0.9 spacing 0.03,0
set logscale xy
set format x '10^{%T}'
set xrange [2.5e-3:1.7]
set yrange [1e-3:20]
set xlabel 'processor time  (s)'
do for [p in '0.3 0.65'] {
    set title 'packing '.p offset 0,-0.6
    if (p eq '0.3') { set ylabel 'error of {/:Italic Z}' offset 1; set format y '10^{%T}' } else { unset ylabel; set format y '' }
    if (p eq '0.3') { set key at graph 0.97,0.97 right top samplen 1 } else { unset key }
    plot for [k=1:3] file using (strcol(1) eq word(list,k).'-'.p ? $2 : NaN):3 with linespoints ls (k == 1 ? 2 : k == 2 ? 3 : 4) lw 1*thick title name(k)
}
