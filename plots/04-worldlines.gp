# data: build/data/04-eleven.dat
# command: build/bin/bonkers --preset piston --until 200 --every 0.05 -o build/data/04-eleven.dat
# alt: Two diagrams of position across against time up. Left, 40 seconds: ten thin zigzag lines, five on either side of a thick line that swings from wall to wall about twice and is bent by every particle that it meets. Right, 200 seconds: ten swings of the thick line, the first ones wide, the later ones narrower and irregular.
height = 10
load 'plots/style.gp'
file = 'build/data/04-eleven.dat'
set multiplot layout 1,2 margins 0.085,0.98,lecture ? 0.15 : 0.13,0.975 spacing 0.085,0
set xlabel 'position {/:Italic x}  (m)'
set ylabel 'time {/:Italic t}  (s)' offset 1.2
set xrange [0:12]
set xtics 0,3,12
set yrange [0:40]
set ytics 10
plot for [i=1:5] file using (column(3+2*i)):1 with lines lw 0.9*thick lc rgb blue, \
     for [i=7:11] file using (column(3+2*i)):1 with lines lw 0.9*thick lc rgb green dt 1, \
     file using 15:1 with lines lw 3*thick lc rgb purple
unset ylabel
set yrange [0:200]
set ytics 50
plot for [i=1:5] file using (column(3+2*i)):1 with lines lw 0.25*thick lc rgb blue, \
     for [i=7:11] file using (column(3+2*i)):1 with lines lw 0.25*thick lc rgb green, \
     file using 15:1 with lines lw 2*thick lc rgb purple
