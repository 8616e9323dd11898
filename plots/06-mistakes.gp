# data: build/data/06-mistakes.dat
# command: build/bin/sample-studies --study mistakes --samples 500000 -o build/data/06-mistakes.dat
# lecture: build/bin/sample-studies --study mistakes --samples 5000000 -o build/data/06-mistakes.dat
# data: plots/data/06-reference.dat
# alt: Ratio of a density to the right one against position. Keeping the disks that fitted gives 0.88 at the walls and 1.12 near the middle; counting only moves gives 0.96 at the walls, 1.07 a quarter of the way in and 0.88 in the middle; the right chain stays at one.
height = 6.8
load 'plots/style.gp'
file = 'build/data/06-mistakes.dat'
eval edges(0.095, 0.985, 0.17, 0.97)
set xrange [0.15:0.85]
set yrange [0.84:1.16]
set xlabel 'position {/:Italic x}  (m)'
set ylabel 'density / right density' offset 1
set key at graph 0.5,0.03 center bottom horizontal samplen 1
array P[14]
do for [i=1:14] { P[i] = 0 }
stats 'plots/data/06-reference.dat' using (P[int(($1-0.15)/0.05+0.01)+1] = P[int(($1-0.15)/0.05+0.01)+1] + $2/5, $2) nooutput
right(i) = P[int(i)+1]
plot 1 ls 9 lw 1.5*thick, \
     file using 1:($4/right($0)):($5/right($0)) with yerrorlines ls 2 lw 1*thick title 'what fitted is kept', \
     file using 1:($8/right($0)):($9/right($0)) with yerrorlines ls 3 lw 1*thick title 'only moves counted', \
     file using 1:($6/right($0)):($7/right($0)) with yerrorbars ls 1 title 'every try counted'
