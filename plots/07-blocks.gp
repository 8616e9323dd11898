# alt: Four rows. In the first, sixteen small squares, samples; in the second, eight blocks of two of them; in the third, the same eight joined to four blocks of four, with room for four new ones; below, the first third and the last third of the row are marked, and their means are compared.
width = 12
height = 4.4
load 'plots/style.gp'
unset border
unset tics
set margins 0,0,0,0
set xrange [-4.8:16.2]
set yrange [-3.1:2.75]
n = 1
do for [i=0:15] {
  set object n circle at i+0.5,2.1 size 0.22 fc rgb '#333333' fs solid noborder
  n = n + 1
}
do for [i=0:7] {
  set object n rectangle from 2*i+0.08,0.75 to 2*i+1.92,1.4 fc rgb '#cfe3f1' fs solid border lc rgb blue lw 1*thick
  n = n + 1
}
do for [i=0:3] {
  set object n rectangle from 4*i+0.08,-0.55 to 4*i+3.92,0.1 fc rgb '#9dc6e3' fs solid border lc rgb blue lw 1*thick
  n = n + 1
}
set arrow 1 from 0.08,-1.35 to 5.25,-1.35 heads size 0.2,20 lc rgb red lw 1.5*thick
set arrow 2 from 10.75,-1.35 to 15.92,-1.35 heads size 0.2,20 lc rgb red lw 1.5*thick
set label 1 'samples' at -0.5,2.1 right
set label 2 'blocks' at -0.5,1.08 right
set label 3 'neighbours joined' at -0.5,-0.22 right
set label 4 'first third, {/:Italic x̄}_1' at 2.65,-2.0 center tc rgb red
set label 5 'last third, {/:Italic x̄}_3' at 13.3,-2.0 center tc rgb red
set label 6 'steady?' at -0.5,-1.35 right
plot 1/0
