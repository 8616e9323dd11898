# data: build/data/10-shapes.dat
# command: build/bin/springs-studies --study shapes -o build/data/10-shapes.dat
# alt: Three beams of five cells, held at the left. With two diagonals in each cell the end hangs by a metre and a quarter at rest and twice as much at the turning point; with one diagonal somewhat more; without diagonals the cells fold up, and the beam hangs down at the wall.
height = 7.8
load 'plots/style.gp'
set multiplot layout 1,3 margins 0.075,0.99,0.17,0.9 spacing 0.035,0
set size ratio -1
set xrange [-0.6:5.6]
set yrange [-5.4:1.5]
set xlabel '{/:Italic x}  (m)'
set tics 2
array T[3] = ['two diagonals', 'one diagonal', 'none']
do for [k=0:2] {
  set title T[k+1] offset 0,-0.5
  if (k == 0) { set ylabel '{/:Italic y}  (m)' offset 0.3 } else { unset ylabel; set format y '' }
  set key at graph 0.03,0.03 left bottom samplen 1.5
  plot for [i=0:5] '+' using (0):(0) every ::0::0 with dots notitle, \
       'build/data/10-shapes.dat' index 2*k using 1:2 with linespoints ls 2 ps 0.35*big lw 0.8*thick title (k == 0 ? 'turning point' : ''), \
       '' index 2*k+1 using 1:2 with linespoints ls 1 ps 0.35*big lw 0.8*thick title (k == 0 ? 'at rest' : '')
}
