# data: plots/data/06-cost.dat
# alt: Three panels, error of a density against processor time, both logarithmic, each with three parallel falling lines. At radius 0.05 direct sampling has the least error; at 0.15 the three are within a factor of two; at 0.2 direct sampling lies ten times above the chain and the dynamics.
load 'plots/style.gp'
file = 'plots/data/06-cost.dat'
list = 'direct markov dynamics'
name(k) = k == 1 ? 'direct' : k == 2 ? 'chain' : 'dynamics'
set multiplot layout 1,3 margins 0.085,0.985,0.17,0.9 spacing 0.015,0
set logscale xy
set format x '10^{%T}'
set xrange [1.2e-4:3]
set xtics 100
set yrange [2e-4:2]
set xlabel 'processor time  (s)'
do for [r in '0.05 0.15 0.2'] {
    set title '{/:Italic r} = '.r.' m' offset 0,-0.6
    if (r eq '0.05') { set ylabel 'error of the density' offset 1; set format y '10^{%T}' } else { unset ylabel; set format y '' }
    if (r eq '0.05') { set key at graph 0.97,0.97 right top samplen 1 } else { unset key }
    plot for [k=1:3] file using (strcol(1) eq word(list,k).'-'.r ? $3 : NaN):4 with linespoints ls k lw 1*thick title name(k)
}
