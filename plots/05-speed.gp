# data: plots/data/05-speed.dat
# data: plots/data/05-pressure.dat
# alt: Two panels with logarithmic axes. Left, collisions per second against the number of disks, 4 to 1024: with every pair looked at they fall as one over N squared, by a factor of more than ten thousand; with a plan by less than a hundred, in the end as one over N. Right, error of the pressure against processor time, two lines of slope minus one half, from 0.13 to 0.002 over three and a half decades of time; the plan lies left of the pairs, at half their time.
height = 7.5
load 'plots/style.gp'
set multiplot layout 1,2 margins 0.1,0.985,0.16,0.97 spacing 0.115,0
speed = 'plots/data/05-speed.dat'
pressure = 'plots/data/05-pressure.dat'
# From a hundred disks on; the lines stand beside the points.
stats speed using ($1 > 100 ? log($1*$3) : NaN) nooutput
plan = exp(STATS_mean)
stats speed using ($1 > 100 ? log($1**2*$2) : NaN) nooutput
pairs = exp(STATS_mean)
stats pressure using (log(sqrt($2)*$4)) nooutput
slow = exp(STATS_mean)
eval powers
set xlabel 'disks {/:Italic N}'
set ylabel 'collisions per second' offset 1
set xrange [3:1500]
set yrange [50:1e7]
set key at graph 0.97,0.96 right top samplen 2
set label 1 '∝ 1/{/:Italic N}' at 500,3.5e4 right tc rgb '#555555'
set label 2 '∝ 1/{/:Italic N}^2' at 30,1.2e4 right tc rgb '#555555'
plot 0.45*plan/x ls 9, 0.85*pairs/x**2 ls 9, \
     speed using 1:3 with linespoints ls 1 title 'plan', \
     speed using 1:2 with linespoints ls 2 title 'pairs'
set xlabel 'processor time of a run  (s)'
set ylabel 'error of {/:Italic Z}' offset 1
set xrange [2e-5:0.6]
set yrange [1e-3:0.3]
plot 1.35*slow/sqrt(x) ls 9, \
     pressure using 3:4 with points ls 1 title 'plan', \
     pressure using 2:4 with points ls 2 title 'pairs'
