# Project P1: how much faster is the lightest bead than the heaviest, and does
# it matter whether the wire is flat or upright?
# To be run beside the program: cd build && gnuplot ../solutions/P1.gp
set terminal pngcairo size 900,600 font ",14"
set output "P1.png"

# Four beads, the lightest on top; what P1 says of the ratio of their rms
# velocities, and its standard error.
beads(m) = sprintf("9 0.1 0.5\n5 0.4 -0.7\n2 0.6 0.9\n%.17g 0.8 -1\n", m)
run(m, wire) = system("printf '" . beads(m) . "' >beads.txt; " . \
    "./P1 beads.txt " . wire . " 20000 | sed -n 's/^# ratio//p'")
set print $flat
do for [k=1:6] { print 0.25 * k, " ", run(0.25 * k, "1 0 0.1") }
set print $upright
do for [k=1:6] { print 0.25 * k, " ", run(0.25 * k, "inf 1 0.1") }
unset print

set xrange [0.1 : 1.65]
set xlabel "mass of the lightest of 9, 5, 2 kg and this (kg)"
set ylabel "its rms velocity over that of the heaviest"
plot sqrt(9 / x) linecolor "black" title "theory: the same energy for each", \
    $flat using ($1 - 0.01):2:3 with yerrorbars pointtype 7 \
    title "flat, 1 m", \
    $upright using ($1 + 0.01):2:3 with yerrorbars pointtype 6 \
    title "upright, without an upper stop"
