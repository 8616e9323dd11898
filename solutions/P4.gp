# Project P4: how many forces does a tolerance cost, and which method is picked
# where, for three bodies on an eight?
# To be run beside the program: cd build && gnuplot ../solutions/P4.gp
set terminal pngcairo size 900,600 font ",14"
set output "P4.png"

system("cat >eight.txt <<END\n\
1 0.97000436 -0.24308753 0.466203685 0.43236573\n\
1 -0.97000436 0.24308753 0.466203685 0.43236573\n\
1 0 0 -0.93240737 -0.86473146\nEND")
# Order, forces of the pick, and all calls, for nine tenths of a period.
row(tol) = (pick = system(sprintf( \
    "./P4 eight.txt 5.6933 %.17g | sed -n 's/^# pick //p'", tol)), \
    order = word(pick, 1) + 0, steps = word(pick, 2) + 0, \
    sprintf("%.17g %d %d %s", tol, order, \
    order == 1 ? steps : order == 2 ? steps + 1 : 3 * steps + 1, \
    word(pick, 3)))
set print $picks
do for [k=0:20] { print row(10**(-1 - 0.4 * k)) }
unset print

set logscale xy
set format x "10^{%L}"
set format y "10^{%L}"
set xlabel "tolerance of the places at the end (m)"
set ylabel "forces"
set xrange [3e-10 : 0.3]
# Theory has no number of its own: powers, through the picks at 1e-3 and 1e-6.
stats $picks using (abs($1 / 1e-3 - 1) < 0.1 ? $3 : NaN) nooutput
at3 = STATS_mean
stats $picks using (abs($1 / 1e-7 / 10**0.2 - 1) < 2 ? $3 * ($1 / 1e-7)**0.25 \
    : NaN) nooutput
at7 = STATS_mean
plot at3 * (1e-3 / x)**0.5 linecolor "gray60" \
    title "the power -1/2 of a method of order 2", \
    at7 * (1e-7 / x)**0.25 linecolor "gray40" dashtype 2 \
    title "the power -1/4 of one of order 4", \
    $picks using 1:($2 == 2 ? $3 : NaN) with points pointtype 7 \
    linecolor "#0072b2" title "picked: leapfrog", \
    $picks using 1:($2 == 4 ? $3 : NaN) with points pointtype 5 \
    linecolor "#009e73" title "picked: three leapfrogs", \
    $picks using 1:($2 == 1 ? $3 : NaN) with points pointtype 9 \
    linecolor "#d55e00" title "picked: order 1", \
    $picks using 1:4 with points pointtype 6 linecolor "black" \
    title "with the search"
