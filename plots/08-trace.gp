# data: build/data/08-trace.dat
# command: build/bin/step-studies --study trace -o build/data/08-trace.dat
# alt: Half the trace of a step against omega dt. All methods follow the cosine at first. Leapfrog crosses minus one at 2. Yoshida's fourth order turns away upwards and crosses plus one at 1.57, his sixth order crosses minus one at 2.27; PEFRL reaches minus one at 2.99, Kahan and Li's eighth order follows the cosine to 3.1.
width = 14
height = 7.5
load 'plots/style.gp'
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
     file using 1:2 with lines ls 1 title 'leapfrog', \
     file using 1:3 with lines ls 2 dt 2 title 'Yoshida 4', \
     file using 1:4 with lines ls 3 dt 3 lw 2*thick title 'PEFRL', \
     file using 1:5 with lines ls 4 dt 4 title 'Yoshida 6', \
     file using 1:6 with lines ls 5 title 'Kahan–Li 8'
