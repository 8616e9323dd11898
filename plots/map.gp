# One map of the atlas on a page: error against cost, a curve for each way to
# carry the scene. A script sets scene; ways, less and stepless (plans without their steps: with
# all forces, with less of them, closed forms and events); the ranges; how deep
# a curve must come to have its name below, in what band; byhand, ways that
# the script has named itself; and loads this.
load 'plots/methods.gp'
if (!exists('less')) less = ''
if (!exists('stepless')) stepless = ''
if (!exists('byhand')) byhand = ''
if (!exists('airx')) { airx = 4; airy = -0.3 }
file = 'build/data/12-atlas.dat'
eval powers
set xlabel 'cost  (s by the price list)'
set ylabel 'true error  (share of the scene)' offset 1
set ytics 1e-15,1e3,1
eval edges(0.105, 0.985, lecture ? 0.15 : 0.065, 0.985)
set xrange [xlow:xhigh]
set yrange [ylow:20]
method(w) = w[1:(strstrt(w, ',') ? strstrt(w, ',')-1 : strlen(w))]
cut(w) = strstrt(w, ',') ? w[strstrt(w, ','):strlen(w)] : ''
words_of(w) = name_of(method(w)).(cut(w) eq ',no-light' ? ' without light pulls' : cut(w) eq ',rods' ? ' with rods' : cut(w))
curve(w) = sprintf("< awk -v want=curve -v scene=%s -v way=%s -f plots/map.awk %s", scene, w, file)
apart = (lecture ? 0.04 : 0.034)*log10(xhigh/xlow)
ends = sprintf("< awk -v want=ends -v scene=%s -v deep=%g -v band=%g -v apart=%g -v 'ways=%s %s' -f plots/map.awk %s", scene, deep, band, apart, ways, less, file)
airy_ways = ''
do for [w in ways.' '.less] { if (!strstrt(' '.byhand.' ', ' '.w.' ')) { airy_ways = airy_ways.' '.w } }
air = sprintf("< awk -v want=air -v scene=%s -v deep=%g -v 'ways=%s' -f plots/map.awk %s", scene, deep, airy_ways, file)
picks = sprintf("< awk -v want=picks -v scene=%s -f plots/map.awk %s", scene, file)
small = face.(lecture ? ',18' : ',8')
do for [k = 1:3] {
  e = 10.0**(-3*k)
  set arrow k from xlow,e to xhigh,e nohead ls 9 dt 3 back
}
plot for [w in ways] curve(w) using 1:2 with linespoints ls style_of(method(w)) ps 0.45*big, \
     for [w in less] curve(w) using 1:2 with linespoints ls style_of(method(w)) ps 0.45*big dt 3, \
     for [w in stepless] curve(w) using 1:2 with points pt 5 ps 1.0*big lc rgb dark, \
     for [w in stepless] curve(w) using 1:2:(words_of(w)) with labels font small left offset 2.2,0, \
     ends using 1:2:($3-$1):($4*2-$2) with vectors nohead ls 9 lw 0.6*thick, \
     ends using 3:4:(words_of(strcol(5))) with labels font small right rotate by 90, \
     air using 1:2:(words_of(strcol(3))) with labels font small center offset airx,airy, \
     picks using 1:2 with points lc rgb red pt 6 ps 1.9*big lw 2*thick, \
     picks using (xlow*1.12):(10.0**(-real(strcol(4)[4:4]))*0.42):3 with labels font small left tc rgb red
