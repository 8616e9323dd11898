# data: plots/data/04-cost.dat
# alt: A long narrow box between two thick walls. In its middle stands a broad piston of 40 kg; five small particles are strewn on either side. All have arrows of the same length to the right. The box is 12 metres long, the piston is at x.
height = 3.5
load 'plots/style.gp'
unset border
unset tics
set xrange [-0.35:12.35]
set yrange [-1.25:1.45]
set margins 0,0,0,0
array X[10] = [0.7, 1.9, 2.6, 4.1, 5.0, 7.3, 8.0, 9.6, 10.3, 11.2]
set object 1 rectangle from -0.3,-0.45 to 0,0.45 fc rgb '#777777' fs solid noborder
set object 2 rectangle from 12,-0.45 to 12.3,0.45 fc rgb '#777777' fs solid noborder
set object 3 rectangle from 0,-0.38 to 12,0.38 fc rgb '#f6f6f6' fs solid noborder behind
set object 4 rectangle from 5.78,-0.38 to 6.22,0.38 fc rgb '#dcc3da' fs solid border lc rgb purple lw 1.5*thick
set arrow 1 from 0,0.38 to 12,0.38 nohead lc rgb grey
set arrow 2 from 0,-0.38 to 12,-0.38 nohead lc rgb grey
set arrow 3 from 6,0.02 to 6.75,0.02 lw 2.5*thick lc rgb dark front
do for [k=1:10] {
    set object 10+k circle at X[k],0 size first 0.09 fc rgb (k < 6 ? blue : green) fs solid noborder front
    set arrow 10+k from X[k],0 to X[k]+0.55,0 lw 1.5*thick lc rgb (k < 6 ? blue : green) front
}
set label 1 'left gas: {/:Italic K_L}, {/:Italic l} = {/:Italic x}' at 2.9,0.72 center tc rgb blue
set label 2 'piston: 40 kg, {/:Italic V}' at 6,1.12 center tc rgb purple
set label 3 'right gas: {/:Italic K_R}, {/:Italic l} = {/:Italic L} − {/:Italic x}' at 9.1,0.72 center tc rgb green
set arrow 4 from 0,-0.62 to 6,-0.62 heads size 0.12,20 lw 1*thick
set label 4 '{/:Italic x}' at 3,-0.82 center
set arrow 5 from 0,-1.0 to 12,-1.0 heads size 0.12,20 lw 1*thick
set label 5 '{/:Italic L} = 12 m' at 9,-0.82 center
set arrow 6 from 6,0.85 to 6,0.48 lw 1*thick lc rgb purple
plot 1/0
