# data: build/data/05-grazing.dat
# command: build/bin/disks-studies --study contact -o build/data/05-grazing.dat
# lecture: build/bin/disks-studies --study contact --starts 20000 -o build/data/05-grazing.dat
# alt: Two panels, both axes logarithmic. Left, the relative error of the time of contact grows as one over the gap up to 0.2 at a gap of ten to the minus 15, for the textbook's root and, with places of random digits, for both. With exact places ours stays below ten to the minus 15 down to a gap of ten to the minus 8, jumps there to ten to the minus 8 and falls again. Right, the error of the time of a grazing contact grows as one over the root of what lacks to sigma, up to four hundred-millionths; the error of the distance stays at ten to the minus 15.
load 'plots/style.gp'
file = 'build/data/05-grazing.dat'
set multiplot layout 1,2 margins 0.1,0.985,0.17,0.97 spacing 0.115,0
set logscale xy
set format y '10^{%T}'
set xrange [1:3e-16] reverse
set xtics ('1' 1, '10^{-5}' 1e-5, '10^{-10}' 1e-10, '10^{-15}' 1e-15)
set xlabel 'gap {/:Italic s}  ({/:Italic σ})'
set ylabel 'relative error of the time' offset 1
set yrange [1e-16:10]
set key at graph 0.03,0.96 left top reverse Left samplen 1.5
eps = 2.0**-52
plot eps/x ls 9, \
     file using 1:6 with points pt 4 ps 0.8*big lw 1.2*thick lc rgb red title "textbook's", \
     file using 1:7 with points ls 1 title "ours", file using 1:5 with points ls 3 ps 0.6*big title "random digits"
set xlabel '1 − {/:Italic b}/{/:Italic σ}'
set ylabel 'error  ({/:Italic σ}/{/:Italic v}, {/:Italic σ})' offset -0.6
set yrange [1e-16:1e-5]
plot eps/sqrt(x) ls 9, \
     file using 1:2 with points ls 1 title "of the time", \
     file using 1:3 with points ls 3 title "of the distance"
