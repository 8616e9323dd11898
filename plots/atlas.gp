# The panels of the atlas, one for each of the scenes named: error against
# cost for all ways to carry it. The scripts 12-maps-hard.gp and -forces.gp set
# names, titles and rows, and load this. A slide has one row, the key beside.
file = 'build/data/12-atlas.dat'
columns = 3
set multiplot layout slide ? 1 : rows,columns margins slide ? 0.12 : 0.1,slide ? 0.84 : 0.985,slide ? 0.15 : 1.1/height,slide ? 0.965 : 1-0.15/height spacing 0.012,0.12/height
set logscale xy
set xrange [2e-7:0.9]
set yrange [5e-18:1e4]
set ytics 1e-15,1e5
set xtics 100
set tics front
like(what) = "< awk -v scene=".s." -v want=like -v 'plan=".what."' -f plots/map.awk ".file
other(what) = "< awk -v scene=".s." -v want=".what." -f plots/map.awk ".file
scenes = words(names)
do for [i=1:scenes] {
  if (!row((i + columns - 1) / columns)) { continue }
  s = word(names, i)
  last = slide || i > scenes - columns
  set format x (last ? '10^{%T}' : '')
  set xlabel (last ? 'cost  (s)' : '')
  set format y (i % columns == 1 ? '10^{%T}' : '')
  set ylabel (i % columns == 1 ? 'error' : '') offset lecture ? 1 : 0.5
  set label 1 titles[i] at graph 0.96,0.92 right front
  unset key
  if (slide && i % columns == 1) { set key at screen 0.855,0.965 left top samplen 0.7 Left reverse }
  if (!slide && i == scenes) { set key at graph keyx,0.78 left top samplen 0.7 Left reverse }
  plot 1e-3 ls 9 dt 3, 1e-6 ls 9 dt 3, 1e-9 ls 9 dt 3, \
       like('^(euler|symplectic-euler|leapfrog|implicit-midpoint|wisdom-holman):[0-9]+$') using 1:2 with points lc rgb grey pt 1 ps 0.4*big title 'order 1, 2', \
       like('^(rk4|yoshida4|pefrl|gauss4|sbab4):[0-9]+$') using 1:2 with points lc rgb orange pt 4 ps 0.35*big title 'order 4', \
       like('^(yoshida6|kahan-li8|rk8pd):[0-9]+$') using 1:2 with points ls 3 ps 0.4*big title 'order 6, 8', \
       like('^(dopri5|radau15):[^,]+$') using 1:2 with points ls 2 pt 6 ps 0.35*big title 'own steps', \
       like(',') using 1:2 with points ls 4 pt 10 ps 0.4*big title 'less', \
       like('^(free|kepler|oscillator|relabel|modes)$') using 1:2 with points ls 5 ps 0.8*big title 'closed', \
       like('^(line|disks)$') using 1:2 with points ls 1 ps 0.6*big title 'events', \
       other('front') using 1:2 with steps lc rgb dark lw 0.8*thick, \
       other('picks') using 1:2 with points lc rgb red pt 6 ps 1.4*big lw 2*thick title 'pick'
}
unset multiplot
