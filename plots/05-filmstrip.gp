# data: build/data/05-filmstrip.dat
# command: build/bin/disks --disks 4 --radius 0.15 --box 1,1 --warmup 0 --every 0.15 --samples 7 --measure states -o build/data/05-filmstrip.dat
# alt: Eight square frames in two rows, 0 to 1.05 seconds. In each stand four numbered disks with arrows for their velocities; from frame to frame they fly straight on, but for those that have met a wall or each other in between.
height = 7.5
load 'plots/style.gp'
file = 'build/data/05-filmstrip.dat'
eval drawing
set xrange [-0.02:1.02]
set yrange [-0.13:1.02]
set object 1 rectangle from 0,0 to 1,1 fs empty border lc rgb '#333333' lw 1.5*thick
set object 2 rectangle from 0.15,0.15 to 0.85,0.85 fs empty border lc rgb '#999999' lw 0.8*thick dt 3
hue(i) = i == 1 ? 0x0072b2 : i == 2 ? 0xd55e00 : i == 3 ? 0x009e73 : 0xe69f00
wash(i) = i == 1 ? 0xcfe3f1 : i == 2 ? 0xf7d9c4 : i == 3 ? 0xcfece3 : 0xfaeccc
# A number stands behind its arrow.
back = 0.075
hypot(x,y) = sqrt(x*x + y*y)
set multiplot layout 2,4 margins 0.005,0.995,0.01,0.99 spacing 0.012,0.012
do for [k=0:7] {
    set label 1 sprintf('{/:Italic t} = %.2f s', 0.15*k) at 0.5,-0.075 center tc rgb '#333333'
    plot file index k using 5:6:4:(wash($2)) with circles lc rgb variable fs solid noborder, \
         file index k using 5:6:4:(hue($2)) with circles lc rgb variable lw 1.5*thick fs empty, \
         file index k using 5:6:(0.15*$7):(0.15*$8) with vectors lc rgb '#333333' lw 1.5*thick, \
         file index k using ($5-back*$7/hypot($7,$8)):($6-back*$8/hypot($7,$8)):2 with labels tc rgb '#333333'
}
