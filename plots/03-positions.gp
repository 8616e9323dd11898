# data: build/data/03-many.dat
# command: build/bin/bonkers --preset thermal --every 2.4 --samples 1000000 -o - | build/bin/histogram --skip 1 --block --column v4,v9,x1,x2,x5,x9,x10 --range=-3.2,3.2 --range=-1.52,1.52 --range 0,11 --range 0,11 --range 0,11 --range 0,11 --range 0,11 --bins 32 --law microcanonical:10,5,0.978265720408381 --law microcanonical:10,5,4.2937219878148802 --law beta:1,10,0,11 --law beta:2,10,0,11 --law beta:5,10,0,11 --law beta:9,10,0,11 --law beta:10,10,0,11 -o build/data/03-many.dat -
# alt: Densities of the positions of balls 1, 2, 5, 9 and 10 of ten in a box of 11 metres: the outermost are highest at the walls, the others are bells; points lie on the curves, which are symmetric although the masses are not.
load 'plots/style.gp'
file = 'build/data/03-many.dat'
p(x,k) = x < 0 || x > 11 ? NaN : exp(lgamma(11)-lgamma(k)-lgamma(11-k))*(x/11)**(k-1)*(1-x/11)**(10-k)/11
set samples 500
set xrange [0:11]
set yrange [0:0.85]
set xlabel 'position  (m)'
set ylabel 'density  (1/m)' offset 1
set key at graph 0.5,0.97 center top horizontal samplen 1 width 1
eval edges(0.085, 0.985, 0.18, 0.97)
plot for [k in '1 2 5 9 10'] p(x,k) ls 9 lw 1.3*thick, \
     for [i=1:5] file index i+1 using 1:3:4 with yerrorbars ls i ps 0.5*big title '{/:Italic x}_{'.word('1 2 5 9 10',i).'}'
