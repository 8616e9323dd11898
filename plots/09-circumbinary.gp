# data: build/data/09-circumbinary.dat
# command: build/bin/gravity-studies --study circumbinary -o build/data/09-circumbinary.dat
# alt: Paths of two stars and a planet. Left, planet at 0.7048 astronomical units: two small circles of the stars inside one large, nearly round orbit. Right, planet begun at 0.445: irregular loops between 0.4 and 0.8, then a wider one, and it leaves.
height = 7.2
load 'plots/style.gp'
file = 'build/data/09-circumbinary.dat'
set multiplot layout 1,2 margins 0.085,0.985,0.16,0.97 spacing 0.11,0
set size ratio -1
set xlabel '{/:Italic x}  (AU)'
set ylabel '{/:Italic y}  (AU)' offset 1
set xrange [-1:1]
set yrange [-1:1]
plot file index 0 using 2:3 with lines ls 2, \
     file index 0 using 4:5 with lines lc rgb orange lw 1.5*thick, \
     file index 0 using 6:7 with lines ls 1, \
     file index 0 every ::0::0 using 2:3 with points ls 2 ps 1.2*big, \
     file index 0 every ::0::0 using 4:5 with points pt 7 lc rgb orange ps 0.8*big, \
     file index 0 every ::0::0 using 6:7 with points ls 1
set xrange [-2.5:2.5]
set yrange [-2.5:2.5]
plot file index 1 using 2:3 with lines ls 2, \
     file index 1 using 4:5 with lines lc rgb orange lw 1.5*thick, \
     file index 1 using 6:7 with lines ls 1
