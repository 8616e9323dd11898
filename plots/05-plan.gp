# alt: Three horizontal lines of time, from 0 to 4 seconds, for the disks k, i and j. At 2 seconds a vertical line joins i and j: they meet. From then on the line of i is in another colour. At 3 seconds a dashed line, crossed out, joins k and i: the old plan of k. At 2.5 seconds a line joins i and k: the new plan of i.
width = 11
height = 4.6
load 'plots/style.gp'
unset ytics
set xtics 1 nomirror out
set border 1
set xlabel 'time (s)'
set margins 4,2,3,0.5
set xrange [0:4]
set yrange [0:3.5]
do for [k=1:3] {
  set label 10+k '{/:Italic '.word('j i k', k).'}' at -0.12,k-0.2 center
  set arrow 10+k from 0,k-0.2 to 4,k-0.2 nohead lc rgb '#777777' lw 1*thick
}
set arrow 21 from 2,1.8 to 4,1.8 nohead lc rgb blue lw 2.2*thick
set arrow 22 from 2,0.8 to 4,0.8 nohead lc rgb blue lw 2.2*thick
set arrow 1 from 2,0.8 to 2,1.8 heads size 0.06,20 filled lc rgb dark lw 2*thick
set arrow 2 from 3,1.8 to 3,2.8 heads size 0.06,20 filled dt 2 lc rgb red lw 1.6*thick
set arrow 3 from 2.5,1.8 to 2.5,2.8 heads size 0.06,20 filled lc rgb blue lw 2*thick
set arrow 4 from 2.93,2.15 to 3.07,2.45 nohead lc rgb red lw 2*thick
set arrow 5 from 2.93,2.45 to 3.07,2.15 nohead lc rgb red lw 2*thick
set label 1 'they meet' at 1.93,1.3 right
set label 2 'planned by {/:Italic i} at 2 s' at 2.44,2.3 right tc rgb blue
set label 3 'planned by {/:Italic k}: stale' at 3.13,2.3 left tc rgb red
plot 1/0
