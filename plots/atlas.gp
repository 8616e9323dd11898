# The panels of the atlas, one for each of the scenes named: error against
# cost for all ways to carry it. The scripts 12-line.gp and its like set
# names, titles and rows, and load this. A slide has one row, the key beside.
file = 'plots/data/12-atlas.dat'
columns = 2
if (!exists('keyx')) { keyx = 0.03; keyy = 0.04 }
set multiplot layout slide ? 1 : rows,columns margins 0.095,slide ? 0.82 : 0.985,slide ? 0.15 : 1.3/height,slide ? 0.965 : 1-0.15/height spacing 0.015,0.12/height
set logscale xy
set xrange [2e-7:0.4]
set yrange [5e-18:1e4]
set ytics 1e-15,1e3
set xtics 100
scenes = words(names)
do for [i=1:scenes] {
  if (!row((i + 1) / columns)) { continue }
  s = word(names, i)
  last = slide || i > scenes - columns
  set format x (last ? '10^{%T}' : '')
  set xlabel (last ? 'cost  (s)' : '')
  set format y (i % columns == 1 ? '10^{%T}' : '')
  set ylabel (i % columns == 1 ? 'error' : '') offset 1
  set label 1 titles[i] at graph 0.97,0.93 right front
  unset key
  if (slide && i % columns == 1) { set key at screen 0.835,0.965 left top samplen 0.7 Left reverse }
  if (!slide && i == keyed) { set key at graph keyx,keyy left bottom samplen 0.7 Left reverse maxrows 4 width 0 }
  plot 1e-3 ls 9 dt 3, 1e-6 ls 9 dt 3, 1e-9 ls 9 dt 3, \
       file index s.' order2' using 1:2 with points lc rgb grey pt 1 ps 0.5*big title 'order 1, 2', \
       file index s.' order4' using 1:2 with points lc rgb orange pt 4 ps 0.45*big title 'order 4', \
       file index s.' order8' using 1:2 with points ls 3 ps 0.5*big title 'order 6, 8', \
       file index s.' less' using 1:2 with points ls 4 pt 10 ps 0.5*big title 'less', \
       file index s.' closed' using 1:2 with points ls 5 ps 0.9*big title 'closed', \
       file index s.' events' using 1:2 with points ls 1 ps 0.7*big title 'events', \
       file index s.' front' using 1:2 with steps lc rgb dark lw 0.8*thick, \
       file index s.' picked' using 1:2 with points lc rgb red pt 6 ps 1.5*big lw 2*thick title 'pick'
}
unset multiplot
