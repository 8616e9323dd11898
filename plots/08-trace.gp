# data: build/data/08-trace.dat
# command: build/bin/step-studies --study trace -o build/data/08-trace.dat
# alt: Half the trace of a step against omega dt. All methods follow the cosine at first. Leapfrog crosses minus one at 2. Yoshida's fourth order turns away upwards and crosses plus one at 1.57, his sixth order crosses minus one at 2.27; PEFRL reaches minus one at 2.99, Kahan and Li's eighth order follows the cosine to 3.1. A second panel has the lower edge near pi: the cosine touches it, Kahan and Li's curve is below it from 3.096 to pi, by less than a thousandth.
height = 7.5
load 'plots/style.gp'
load 'plots/methods.gp'
file = 'build/data/08-trace.dat'
set ylabel 'half the trace of a step' offset 1
set xlabel '{/Symbol w}{/:Italic dt}'
set multiplot layout 1,2
set bmargin at screen 0.15
set tmargin at screen 0.97
set xrange [0:3.5]
set yrange [-1.6:1.6]
set lmargin at screen 0.09
set rmargin at screen 0.635
set key at graph 0.02,0.68 left top reverse Left samplen 3 width -1
plot 1 ls 9, -1 ls 9, cos(x) ls 9 lw 4*thick title 'cosine', \
     for [m in columns(file, known)] \
     file using 1:column_of(file, m) with lines ls style_of(m) title name_of(m)
set xrange [2.95:3.25]
set yrange [-1.0012:-0.9988]
set xtics 0.1
set ytics ('−1.001' -1.001, '−1' -1, '−0.999' -0.999)
unset ylabel
set lmargin at screen 0.725
set rmargin at screen 0.985
plot -1 ls 9, cos(x) ls 9 lw 4*thick, \
     for [m in columns(file, known)] \
     file using 1:column_of(file, m) with lines ls style_of(m)
