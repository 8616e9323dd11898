# data: build/data/08-work.dat
# command: build/bin/step-studies --study work -o build/data/08-work.dat
# alt: Two panels, error against evaluations of the forces, both logarithmic; left an orbit of eccentricity one half after ten turns, right a chain of 32 masses. Each method falls with the slope of its order, but symplectic Euler on the orbit, whose slope is two as that of leapfrog and midpoint. Euler does not arrive on the orbit and needs most work on the chain. Of the explicit methods of order four PEFRL is best and Yoshida's worst. From an error of ten to the minus 8 on the adaptive rk8pd and Kahan and Li's order eight are the cheapest on both sides, down to ten to the minus 12 on the orbit and to less than ten to the minus 13 on the chain.
width = 14
height = 11
load 'plots/style.gp'
file = 'build/data/08-work.dat'
set multiplot
set logscale xy
set format '10^{%T}'
set yrange [1e-14:10]
set ytics 100
set lmargin at screen 0.105
set rmargin at screen lecture ? 0.425 : 0.535
set bmargin at screen lecture ? 0.15 : 0.27
set tmargin at screen 0.98
array part[11] = ['Euler', 'symplectic Euler', 'leapfrog', 'RK4', 'Yoshida 4', 'Yoshida 6', 'PEFRL', 'Kahan–Li 8', 'midpoint', 'Gauss 4', 'rk8pd (GSL)']
style(k) = word('2 3 1 4 5 5 3 2 1 4 9', k+1)
do for [k=0:1] {
  set xlabel 'evaluations of the forces'
  set ylabel k == 0 ? 'error at the end' : '' offset 0.5
  set format y (k == 0 ? '10^{%T}' : '')
  set xrange [k == 0 ? 400 : 100 : 1.5e6]
  if (k == 1) { set lmargin at screen lecture ? 0.445 : 0.555; set rmargin at screen lecture ? 0.765 : 0.99; }
  set label 1 (k == 0 ? 'orbit' : 'chain') at graph 0.04,0.06 left
  if (k == 0) { if (lecture) { set key at screen 0.775,0.97 left top samplen 2 Left reverse } else { set key at screen 0.52,0.01 center bottom maxrows 3 samplen 2 Left reverse width 1 } }
  if (k == 1) { unset key; }
  n = 11*k
  plot file index n using 1:2 with linespoints ls 2 ps 0.4*big title part[1], \
     file index n+1 using 1:2 with linespoints ls 3 ps 0.5*big title part[2], \
     file index n+2 using 1:2 with linespoints ls 1 ps 0.4*big title part[3], \
     file index n+8 using 1:2 with linespoints ls 1 pt 6 dt 2 ps 0.4*big title part[9], \
     file index n+3 using 1:2 with linespoints ls 4 ps 0.5*big title part[4], \
     file index n+4 using 1:2 with linespoints ls 5 ps 0.6*big title part[5], \
     file index n+5 using 1:2 with linespoints ls 5 pt 12 dt 2 ps 0.6*big title part[6], \
     file index n+6 using 1:2 with linespoints ls 3 pt 8 dt 2 ps 0.5*big title part[7], \
     file index n+7 using 1:2 with linespoints ls 2 pt 4 dt 2 ps 0.4*big title part[8], \
     file index n+9 using 1:2 with linespoints ls 4 pt 10 dt 2 ps 0.5*big title part[10], \
     file index n+10 using 1:2 with linespoints ls 9 pt 1 ps 0.5*big title part[11]
}
unset multiplot
