# data: plots/data/04-cost.dat
# alt: Left, two swings of a piston, time upwards, with one fast particle that zigzags many times between the wall and the piston in each swing and one slow particle that meets the piston three or four times in all. Right, speed against the number of swings, for 60 swings: particles that start fast run through the same narrow bands of speed for ever; particles that start slow jump about without any rule, but never above a dashed line, the border.
width = 14
height = 7.6
load 'plots/style.gp'
# Lengths in h, times in swings: the piston is at 1 + a sin(2 pi t).
a = 0.25
omega = 2*pi
border = 2*sqrt(a)*omega
wall(t) = 1 + a*sin(omega*t)
push(t) = a*omega*cos(omega*t)
step = 0.002
# Follows one particle from the wall; writes its path while t < watched, and
# its speed at each hit.
set print $path
set print $speed
array S[4] = [0.2, 0.33, 0.62, 2.0]
do for [n=1:4] {
    set print $speed append
    t = 0.0; x = 0.0; v = S[n]*border
    while (t < 60) {
        dt = v > border ? step/3 : step
        x = x + v*dt; t = t + dt
        if (x < 0) { x = -x; v = -v }
        if (v > push(t) && x > wall(t)) { v = 2*push(t) - v; x = 2*wall(t) - x; print n, t, abs(v)/border }
    }
    print ''
    print ''
}
do for [n=1:2] {
    set print $path append
    t = 0.0; x = n == 1 ? 0.3 : 0.1; v = (n == 1 ? 2.0 : 0.3)*border; print t, x
    while (t < 2) {
        x = x + v*step; t = t + step
        if (x < 0) { x = -x; v = -v; print t, 0 }
        if (v > push(t) && x > wall(t)) { v = 2*push(t) - v; x = 2*wall(t) - x; print t, wall(t) }
    }
    print t, x
    print ''
    print ''
}
unset print
set multiplot layout 1,2 margins lecture ? 0.09 : 0.07,0.985,lecture ? 0.17 : 0.15,0.97 spacing 0.1,0
set xlabel 'position  ({/:Italic h})'
set ylabel 'time  (swings)' offset 1
set xrange [0:1.4]
set yrange [0:2]
set xtics 0.5
set ytics 0.5
set samples 400
set parametric
set trange [0:2]
plot $path index 0 using 2:1 with lines lc rgb blue lw 0.8*thick, $path index 1 using 2:1 with lines lc rgb red lw 2*thick, wall(t),t lc rgb purple lw 3*thick
unset parametric
set xlabel 'time  (swings)'
set ylabel 'speed  ({/:Italic v}_*)' offset 1
set xrange [0:60]
set yrange [0:4]
set xtics 20
set ytics 1
plot for [n=0:3] $speed index n using 2:3 with points pt 7 ps 0.22*big lc rgb (n < 3 ? red : blue), 1 with lines lc rgb dark dt 2 lw 1.5*thick
unset multiplot
