# data: plots/data/11-cost.dat
# slides: 2
# alt: Four panels for packings 0.1, 0.3, 0.5 and 0.7, logarithmic axes: relative error of the pressure against processor time for a second of the gas, from 0.15 milliseconds to one second. Errors of pushing apart fall in proportion to the time, those of going back as its square, until they end in noise; a vertical line at 0.4, 1, 2 and 5 milliseconds marks the cost of events, where steps have errors from one per cent at the lowest packing to a half at the highest. Located contact, in green, has errors of a few thousandths at most, no more than its bars, at 20 milliseconds, at 0.1 and at half a second, and is not in the last panel.
height = 9.5
load 'plots/style.gp'
file = 'plots/data/11-cost.dat'
do for [i=0:3] { stats file index i using 4 name sprintf('E%d', i) nooutput }
set multiplot layout slide ? 1 : 2,2 margins 0.105,0.985,slide ? 0.15 : 0.125,slide ? 0.915 : 0.935 spacing 0.02,0.03
set logscale xy
set xrange [4e-5:2]
set yrange [2e-4:2]
what(i) = sprintf('packing %s', word('0.1 0.3 0.5 0.7', i + 1))
low(d,e) = d > 1.2*e ? d - e : 2e-4
do for [i=slide == 2 ? 2 : 0:slide == 1 ? 1 : 3] {
  set label 1 what(i) at graph 0.96,0.92 right
  if (i < 2 && !slide) { set format x ''; set xlabel '' } else { set format x '10^{%T}'; set xlabel 'processor time for a second  (s)' }
  if (i % 2) { set format y ''; set ylabel '' } else { set format y '10^{%T}'; set ylabel '|Δ{/:Italic Z}| / {/:Italic Z}' offset 0 }
  set arrow 1 from value(sprintf('E%d_mean', i)), graph 0 to value(sprintf('E%d_mean', i)), graph 1 nohead lc rgb dark lw 1.2*thick
  if (i == 0) { set label 2 'events' at value(sprintf('E%d_mean', i))*0.9,5e-4 right rotate by 0 } else { unset label 2 }
  unset label 3
  if (i == 0) { set label 3 'located' at 0.02,7e-3 center tc rgb green }
  if (i == 2) { set label 3 'located' at 0.4,1.2e-2 center tc rgb green }
  if (i == 0 || slide == 2 && i == 2) { set key at screen 0.55,0.995 center top horizontal maxrows 1 samplen 1 } else { unset key }
  plot file index i using 7:8:(low($8,$9)):($8+$9) with yerrorbars ls 2 title 'pushed apart', \
       file index i using 10:11:(low($11,$12)):($11+$12) with yerrorbars ls 1 title 'going back', \
       for [m=1:(i < 3)] file index i using 13:14:(low($14,$15)):($14+$15) with yerrorbars ls 3
}
