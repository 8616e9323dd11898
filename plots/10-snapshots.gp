# data: build/data/10-snapshots.dat
# command: for rest in 0.8 1; do build/bin/springs0 $rest; done > build/data/10-snapshots.dat
# alt: Eight surfaces of eight by eight bodies, drawn as nets, at 0, 8, 16 and 24 seconds. In the upper row, taut, each is a smooth bump up or down; in the lower row, at rest length, the bump has flat flanks and folds, and its corners drag behind.
height = 8
load 'plots/style.gp'
set multiplot
set view 62,30,1.55,1.7
set zrange [-0.12:0.12]
set xrange [-1:1]
set yrange [-1:1]
unset border
unset tics
set hidden3d
do for [k=0:1] {
  do for [shot=0:3] {
    set origin 0.05 + 0.237*shot, k == 0 ? 0.5 : 0.01
    set size 0.23, 0.47
    set lmargin 0
    set rmargin 0
    set tmargin 0
    set bmargin 0
    set label 1 sprintf('%d s', 8*shot) at screen 0.165 + 0.237*shot, (k == 0 ? 0.94 : 0.45) center
    if (shot == 0) { set label 2 (k == 0 ? 'taut' : 'at rest length') at screen 0.018, (k == 0 ? 0.72 : 0.23) rotate by 90 center } else { unset label 2 }
    splot 'build/data/10-snapshots.dat' index 4*k + shot using 1:2:3 with lines lc rgb (k == 0 ? blue : red) lw 0.8*thick
  }
}
