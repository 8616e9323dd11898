# data: build/data/11-break.dat
# command: build/bin/spheres-studies --study break -o build/data/11-break.dat
# data: build/data/11-break-steps.dat
# command: for order in ascending descending; do build/bin/spheres0 $order; echo; echo; done > build/data/11-break-steps.dat
# alt: Two pictures of sixteen balls half a second after the break, each with an inset in which the balls in the middle stand nearly three times as far apart. Left, filled balls and open balls are mirror images of each other in the axis of the shot; two balls have flown far out, one to either side. Right, by events there are two answers for a hundred racks, mirror images too; rings mark the places by steps, the deepest pair first, which fall on one of the two.
height = 7.9
load 'plots/style.gp'
file = 'build/data/11-break.dat'
steps = 'build/data/11-break-steps.dat'
# Where a panel and its inset lie on the page; one metre is as long up as across.
wide = 0.41
high = wide*width/height*3.4/3.35
foot = 0.165
across(left, x) = left + (x + 0.75)/3.35*wide
up(y) = foot + (y + 1.7)/3.4*high
set multiplot
set ylabel '{/:Italic y}  (m)' offset 1.5
do for [panel=1:2] {
    left = panel == 1 ? 0.085 : 0.575
    do for [zoom=0:1] {
        if (zoom) {
            eval edges(across(left, 0.85), across(left, 2.05), up(-0.6), up(0.6))
            set xrange [-0.05:0.41]
            set yrange [-0.23:0.23]
            unset object 1
            set xlabel ''
            set ylabel ''
            set title ''
            unset key
            unset tics
        } else {
            eval edges(left, left + wide, foot, foot + high)
            set xrange [-0.75:2.6]
            set yrange [-1.7:1.7]
            set object 1 rectangle from -0.05,-0.23 to 0.41,0.23 fs empty \
                border lc rgb '#777777' lw 0.7*thick
            set xlabel '{/:Italic x}  (m)'
            set xtics -0.5,0.5,2.5
            set ytics -1.5,0.5,1.5
            set key at graph 0.03,0.97 left top samplen 1
            set title panel == 1 ? 'by steps' : 'by events' offset 0,-0.6
        }
        if (panel == 1) {
            plot steps index 0 using 1:2 with points lc rgb blue pt 7 ps 0.7*big title 'ascending', \
                 steps index 1 using 1:2 with points lc rgb red pt 6 lw 1.3*thick ps 0.7*big title 'descending'
        } else {
            plot file index 1 using 1:2 with points lc rgb dark pt 7 ps 0.4*big title 'events', \
                 file index 0 using 5:6 with points lc rgb green pt 6 lw 1.3*thick ps 0.9*big title 'deepest first'
        }
    }
    set ylabel ''
    set format y ''
}
