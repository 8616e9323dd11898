# data: build/data/08-trace.dat
# command: build/bin/step-studies --study trace -o build/data/08-trace.dat
# alt: Half the trace of a step against omega dt. All methods follow the cosine at first. Leapfrog crosses minus one at 2. Yoshida's fourth order turns away upwards and crosses plus one at 1.57, his sixth order crosses minus one at 2.27; PEFRL reaches minus one at 2.99, Kahan and Li's eighth order follows the cosine to 3.1.
width = 14
height = 7.5
load 'plots/style.gp'
load 'plots/methods.gp'
file = 'build/data/08-trace.dat'
set xrange [0:3.5]
set yrange [-1.6:1.6]
set xlabel '{/Symbol w}{/:Italic dt}'
set ylabel 'half the trace of a step' offset 1
set lmargin at screen 0.09
set rmargin at screen 0.98
set bmargin at screen 0.15
set tmargin at screen 0.97
set key at graph 0.02,0.68 left top reverse Left samplen 3 width -1
plot 1 ls 9, -1 ls 9, cos(x) ls 9 lw 4*thick title 'cosine', \
     for [m in columns(file, known)] \
     file using 1:column_of(file, m) with lines ls style_of(m) title name_of(m)
