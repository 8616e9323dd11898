# alt: Three by three square boxes. In each of them, at the same places, a blue disk and an orange one; in the one in the middle they are dark and carry the letters i and j. A line joins disk i, near the right edge of the middle box, to the orange disk of the box on the right: the nearest image. An arrow shows that disk i flies to the left, towards the orange disk of its own box.
width = 8
height = 8
load 'plots/style.gp'
eval drawing
set margins 0,0,0,0
set xrange [-0.75:1.75]
set yrange [-0.75:1.75]
ix = 0.8
iy = 0.55
jx = 0.17
jy = 0.42
r = 0.09
n = 0
do for [a=-1:1] { do for [b=-1:1] {
  home = a == 0 && b == 0
  set object 3*n+10 rectangle from a,b to a+1,b+1 fs empty border lc rgb home ? '#333333' : '#bbbbbb' lw (home ? 2 : 0.8)*thick
  set object 3*n+11 circle at ix+a,iy+b size r fc rgb home ? '#9dc6e3' : '#e7f1f8' fs solid border lc rgb home ? blue : '#a9cbe4' lw 1.2*thick
  set object 3*n+12 circle at jx+a,jy+b size r fc rgb home ? '#f0b994' : '#fbeee5' fs solid border lc rgb home ? red : '#ecb696' lw 1.2*thick
  n = n + 1
} }
set object 5 rectangle from 0,0 to 1,1 fs empty border lc rgb '#333333' lw 2*thick front
set arrow 1 from ix+0.094*r/0.1,iy-0.033*r/0.1 to jx+1-0.094*r/0.1,jy+0.033*r/0.1 heads size 0.04,20 lc rgb dark lw 1.6*thick front
set arrow 2 from ix-r,iy-0.02 to ix-r-0.25,iy-0.055 size 0.05,20 filled lc rgb blue lw 2*thick front
set label 1 '{/:Italic i}' at ix,iy center front
set label 2 '{/:Italic j}' at jx,jy center front
set label 3 'nearest' at 1.05,0.62 left front
plot 1/0
