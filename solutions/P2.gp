# Project P2: how strongly do small disks push two big ones together, and from
# how far?
# To be run beside the program: cd build && gnuplot ../solutions/P2.gp
set terminal pngcairo size 900,600 font ",14"
set output "P2.png"

# P(s) over what it would be without small ones: there it grows as s, so that
# its mean over a slice is that in the middle.
R = 0.1
level(s) = 2 * s / (0.25 - 4 * R * R)
run(n, samples) = sprintf("< ./P2 pair %d %g 0.08 %d %d", n, R, 1 + n, samples)

set xlabel "distance s of the two big ones (m)"
set ylabel "P(s) over that without small ones"
set xrange [0.195 : 0.505]
set yrange [0.5 : 2.3]
set arrow from 0.36, 0.5 to 0.36, 1.7 nohead dashtype 3
set label "the depletion zones part" at 0.363, 1.6
plot for [n=0:24:12] run(n, 20) \
    using (($1 + $2) / 2):($5 / level(($1 + $2) / 2)) with lines \
    linecolor "black" title n == 0 ? "theory, over each slice" : "", \
    run(0, 20000) using (s = ($1 + $2) / 2):($3 / level(s)):($4 / level(s)) \
    with yerrorbars pointtype 6 linecolor "#009e73" title "no small ones", \
    run(12, 20000) using (s = ($1 + $2) / 2):($3 / level(s)):($4 / level(s)) \
    with yerrorbars pointtype 4 linecolor "#d55e00" title "12", \
    run(24, 20000) using (s = ($1 + $2) / 2):($3 / level(s)):($4 / level(s)) \
    with yerrorbars pointtype 7 linecolor "#0072b2" title "24"
