# Project P3: for which error of three bodies on an eight does which method
# need the fewest forces, and does the error fall with the power of the step?
# To be run beside the program: cd build && gnuplot ../solutions/P3.gp
set terminal pngcairo size 900,600 font ",14"
set output "P3.png"

# After nine tenths of a period, in so many steps: the error that P3 states,
# and where the bodies are.
system("cat >eight.txt <<END\n\
1 0 0.97000436 -0.24308753 0.466203685 0.43236573\n\
1 0 -0.97000436 0.24308753 0.466203685 0.43236573\n\
1 0 0 0 -0.93240737 -0.86473146\nEND")
T = 0.9 * 6.32591398
run(method, n) = system(sprintf( \
    "./P3 eight.txt 1 %s %.17g %d 1 | sed -n '2s/ /\\n/gp; s/^# error //p'", \
    method, T / n, n))
place(end, i) = word(end, i == 0 ? 3 : i == 1 ? 7 : 11) + \
    {0, 1} * word(end, i == 0 ? 4 : i == 1 ? 8 : 12)
# What is true, from far shorter steps of the best method.
truth = run("fourth", 20000)
off(end, i) = abs(place(end, i) - place(truth, i))
worst(end) = off(end, 0) > off(end, 1) ? \
    (off(end, 0) > off(end, 2) ? off(end, 0) : off(end, 2)) : \
    (off(end, 1) > off(end, 2) ? off(end, 1) : off(end, 2))
# Forces that are needed, error stated, error.
row(method, forces, n) = (end = run(method, n), \
    sprintf("%d %s %.17g", forces * n, word(end, 15), worst(end)))
set print $euler
do for [k=0:5] { print row("euler", 1, 100 * 2**k) }
set print $leapfrog
do for [k=0:5] { print row("leapfrog", 1, 100 * 2**k) }
set print $fourth
do for [k=0:4] { print row("fourth", 3, 100 * 2**k) }
unset print

# Of theory there is the power alone: each line ends at the last point.
stats $euler using (n1 = $1, e1 = $3, $1) nooutput
stats $leapfrog using (n2 = $1, e2 = $3, $1) nooutput
stats $fourth using (n4 = $1, e4 = $3, $1) nooutput
set logscale xy
set format y "10^{%L}"
set xrange [80 : 6000]
set key left bottom
set xlabel "forces needed in nine tenths of a period"
set ylabel "error of the worst place at the end (m)"
plot e1 * (n1 / x) linecolor "gray60" title "powers 1, 2 and 4 of the step", \
    e2 * (n2 / x)**2 linecolor "gray60" notitle, \
    e4 * (n4 / x)**4 linecolor "gray60" notitle, \
    $euler using 1:2:($2 / 3):($2 * 3) with yerrorbars pointtype 4 \
    linecolor "#d55e00" title "euler: stated, and a factor of 3", \
    $leapfrog using 1:2:($2 / 3):($2 * 3) with yerrorbars pointtype 6 \
    linecolor "#0072b2" title "leapfrog", \
    $fourth using 1:2:($2 / 3):($2 * 3) with yerrorbars pointtype 8 \
    linecolor "#009e73" title "fourth, three leapfrogs a step", \
    $euler using 1:3 with points pointtype 7 pointsize 0.5 \
    linecolor "black" title "true, by 20000 steps of fourth", \
    $leapfrog using 1:3 with points pointtype 7 pointsize 0.5 \
    linecolor "black" notitle, \
    $fourth using 1:3 with points pointtype 7 pointsize 0.5 \
    linecolor "black" notitle
