# data: build/data/10-path.dat
# command: build/bin/springs-studies --study path -o build/data/10-path.dat
# data: build/data/10-errors.dat
# command: build/bin/springs-studies --study errors -o build/data/10-errors.dat
# alt: Two panels. Left, the paths of the two bodies in ten seconds: the upper one swings on an arc of a circle, the lower one draws a winding curve below it. Right, error of the place after ten seconds against the step, with logarithmic axes, for ten methods: lines of slopes one, two, four, six and eight, each ending on the right at its step limit, PEFRL's and Kahan and Li's one point beyond it, but for the two implicit methods, which go on to a fifth of a second.
height = 8
load 'plots/style.gp'
load 'plots/methods.gp'
set multiplot
eval edges(0.09, 0.375, 0.14, 0.97)
set size ratio -1
set xrange [-1.5:1.5]
set yrange [-1.9:1.15]
set xlabel '{/:Italic x}  (m)'
set ylabel '{/:Italic z}  (m)' offset 0.6
set xtics 1
file = 'build/data/10-path.dat'
plot file using 4:5 with lines lc rgb blue lw 0.8*thick, file using 2:3 with lines lc rgb red lw 1.5*thick, \
     '+' using (0):(1) every ::0::0 with points pt 7 ps 0.8*big lc rgb dark, \
     file every ::0::0 using (0):(1):2:($3-1) with vectors nohead lc rgb dark lw thick, \
     file every ::0::0 using 2:3:($4-$2):($5-$3) with vectors nohead lc rgb dark lw thick, \
     file every ::0::0 using 2:3 with points pt 7 ps big lc rgb red, file every ::0::0 using 4:5 with points pt 7 ps big lc rgb blue
set size noratio
set lmargin at screen 0.49
set rmargin at screen 0.805
eval powers
set xtics auto
set xrange [5e-5:0.5]
set yrange [1e-13:3]
set xlabel 'step  (s)'
set ylabel 'error after 10 s  (m)' offset 0
set key at screen 0.815,0.97 left top Left reverse samplen 1.5
errors = 'build/data/10-errors.dat'
plot for [m in methods(errors, known)] errors index at(errors, m) using 1:3 \
     with linespoints ls style_of(m) title name_of(m)
