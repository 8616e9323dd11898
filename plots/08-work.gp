# data: build/data/08-work.dat
# command: build/bin/step-studies --study work -o build/data/08-work.dat
# alt: Two panels, error against evaluations of the forces, both logarithmic; left an orbit of eccentricity one half after ten turns, right a chain of 32 masses. Each method falls with the slope of its order, but symplectic Euler on the orbit, whose slope is two as that of leapfrog and midpoint. Euler does not arrive on the orbit and needs most work on the chain. Of the explicit methods of order four PEFRL is best and Yoshida's worst. From an error of ten to the minus 8 on the adaptive rk8pd and Kahan and Li's order eight are the cheapest on both sides, down to ten to the minus 12 on the orbit and to less than ten to the minus 13 on the chain.
height = 11
load 'plots/style.gp'
size = 0.7
load 'plots/methods.gp'
file = 'build/data/08-work.dat'
set multiplot
eval powers
set yrange [1e-14:10]
set ytics 100
eval edges(0.105, lecture ? 0.425 : 0.535, lecture ? 0.15 : 0.27, 0.98)
names = methods(file, known)
do for [k=0:1] {
  set xlabel 'evaluations of the forces'
  set ylabel k == 0 ? 'error at the end' : '' offset 0.5
  set format y (k == 0 ? '10^{%T}' : '')
  set xrange [k == 0 ? 400 : 100 : 1.5e6]
  from = k == 0 ? 100 : 1000
  set xtics from,10
  if (k == 1) { set lmargin at screen lecture ? 0.445 : 0.555; set rmargin at screen lecture ? 0.765 : 0.99; }
  set label 1 (k == 0 ? 'orbit' : 'chain') at graph 0.04,0.06 left
  if (k == 0) { if (lecture) { set key at screen 0.775,0.97 left top samplen 2 Left reverse } else { set key at screen 0.52,0.01 center bottom maxrows 3 samplen 2 Left reverse width 1 } }
  if (k == 1) { unset key; }
  plot for [m in names] file index words(names)*k + at(file, m) using 1:2 \
       with linespoints ls style_of(m) title name_of(m)
}
