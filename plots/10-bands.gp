# alt: Left, a grid of four by three bodies numbered row by row from 0 to 11, joined along the rows and along the columns. Right, two rows of twelve boxes: in the band of stride 1 the boxes 3 and 7, at the ends of rows, are empty; the band of stride 4 has boxes 0 to 7.
height = 4.2
load 'plots/style.gp'
unset border
unset tics
set size ratio -1
set margins 0,0,0,0
set xrange [-0.5:14.5]
set yrange [-0.75:3.75]
do for [i=0:11] {
  x = (i % 4)*1.1 + 0.2
  y = floor(i/4)*1.15 + 0.2
  if (i % 4 < 3) { set arrow from x,y to x+1.1,y nohead lc rgb blue lw 2.2*thick }
  if (i < 8) { set arrow from x,y to x,y+1.15 nohead lc rgb red lw 2.2*thick }
  set object i+1 circle at x,y size 0.27 fc rgb 'white' fs solid border lc rgb dark lw thick front
  set label i+1 sprintf('%d', i) at x,y center front
  s = 0.7
  bx = 5.7 + s*i
  hole = i == 3 || i == 7
  if (i < 11) { set object 20+i rect from bx,2.0 to bx+s,2.0+s fc rgb (hole ? 'white' : '#cfe3f1') fs solid border lc rgb blue lw thick }
  if (i < 11) { set label 20+i sprintf('%d', i) at bx+s/2,2.0+s/2 center tc rgb (hole ? '#999999' : dark) front }
  if (i < 8) { set object 40+i rect from bx,0.15 to bx+s,0.15+s fc rgb '#f3d3c2' fs solid border lc rgb red lw thick }
  if (i < 8) { set label 40+i sprintf('%d', i) at bx+s/2,0.15+s/2 center front }
}
set label 60 'stride 1:  {/:Italic i} to {/:Italic i} + 1' at 5.7,3.05 left tc rgb blue
set label 61 'stride 4:  {/:Italic i} to {/:Italic i} + 4' at 5.7,1.2 left tc rgb red
set label 62 'hole' at 5.7+0.7*3.5,1.72 center tc rgb '#555555'
set label 63 'hole' at 5.7+0.7*7.5,1.72 center tc rgb '#555555'
plot NaN
