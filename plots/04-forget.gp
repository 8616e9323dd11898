# data: build/data/04-forget.dat
# command: awk -f plots/forget.awk > build/data/04-forget.dat
# alt: Left, two swings of a piston, time upwards, with one fast particle that zigzags many times between the wall and the piston in each swing and one slow particle that meets the piston three or four times in all. Right, speed against the number of swings, for 60 swings: particles that start fast run through the same narrow bands of speed for ever; particles that start slow jump about without any rule, but never above a dashed line, the border.
height = 7.6
load 'plots/style.gp'
# Lengths in h, times in swings: the piston is at 1 + a sin(2 pi t).
wall(t) = 1 + 0.25*sin(2*pi*t)
file = 'build/data/04-forget.dat'
set multiplot layout 1,2 margins lecture ? 0.09 : 0.07,0.985,lecture ? 0.17 : 0.15,0.97 spacing 0.1,0
set xlabel 'position  ({/:Italic h})'
set ylabel 'time  (swings)' offset 1
set xrange [0:1.4]
set yrange [0:2]
set tics 0.5
set samples 400
set parametric
set trange [0:2]
plot file index 4 using 2:1 with lines lc rgb blue lw 0.8*thick, file index 5 using 2:1 with lines lc rgb red lw 2*thick, wall(t),t lc rgb purple lw 3*thick
unset parametric
set xlabel 'time  (swings)'
set ylabel 'speed  ({/:Italic v}_*)' offset 1
set xrange [0:60]
set yrange [0:4]
set xtics 20
set ytics 1
plot for [n=0:3] file index n using 2:3 with points pt 7 ps 0.22*big lc rgb (n < 3 ? red : blue), 1 with lines lc rgb dark dt 2 lw 1.5*thick
