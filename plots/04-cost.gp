# data: plots/data/04-cost.dat
# alt: Two panels with logarithmic axes, relative error of the period against processor time. Left, error of the arithmetic: the leapfrog falls with slope minus two from one part in a thousand, Runge and Kutta with slope minus four, the quadrature, farthest to the left, is exact to twelve digits. Right, error against the particles: the isothermal guess at 66 per cent, bare formulas at 4 to 6 per cent, sound and the added mass at 0.8, the large swing with added mass at 0.4, all in about a microsecond, and no finer step improves it; particle runs from 0.5 to 0.05 per cent take a tenth of a second to some seconds.
height = 8
load 'plots/style.gp'
load 'plots/methods.gp'
cost = 'plots/data/04-cost.dat'
stats cost using (strcol(1) eq 'quadrature' && $2 == 1 && $3 == 64 ? $4 : NaN) nooutput
exact = STATS_min
truth = real(system("sed -n 's/^# 6 .* against \\([0-9.]*\\) s$/\\1/p' '".cost."'"))
set multiplot layout 1,2 margins 0.11,0.985,0.155,1-0.085 spacing 0.13,0
eval powers
set xlabel 'processor time  (s)'
set ylabel 'relative error of the period' offset 1
set title 'of the arithmetic' offset 0,-0.5
set xrange [2e-7:2e-2]
set xtics 100
set yrange [1e-13:1e-1]
set key at graph 0.97,0.97 right top samplen 1
plot cost using (strcol(1) eq 'leapfrog' && $2 == 1 ? $5 : NaN):(abs($4/exact-1)) with points ls style_of('leapfrog') title 'leapfrog', \
     cost using (strcol(1) eq 'rk4' && $2 == 1 ? $5 : NaN):(abs($4/exact-1)) with points ls style_of('rk4') title 'Runge–Kutta', \
     cost using (strcol(1) eq 'quadrature' && $2 == 1 ? $5 : NaN):(abs($4/exact-1)+2e-13) with points ls 3 title 'quadrature'
set title 'of the model' offset 0,-0.5
set xrange [1e-7:1e2]
set yrange [0.02:200]
set format y '%g'
set ytics (0.1, 1, 10, 100)
set ylabel 'error of the period  (%)' offset 1.5
set label 1 'isothermal' at 2e-6,66 left tc rgb '#555555'
set label 2 'bare' at 3e-6,5 left tc rgb red
set label 3 'mass, small swing; sound' at 5e-6,1.05 left tc rgb green
set label 4 'mass, true swing' at 3e-6,0.22 left tc rgb blue
set label 5 'particles' at 0.25,0.55 left tc rgb dark
plot cost using (strcol(1) eq 'isothermal' ? $5 : NaN):6 with points pt 12 ps big lw 1.5*thick lc rgb '#555555', \
     cost using (strcol(1)[1:4] eq 'bare' ? $5 : NaN):6 with points ls 2, \
     cost using (strcol(1) eq 'added' || strcol(1) eq 'sound' ? $5 : NaN):6 with points ls 3, \
     cost using (strcol(1) eq 'added-swing' ? $5 : NaN):6 with points ls 1, \
     cost using (strcol(1) eq 'leapfrog' && $2 == 1 && $3 < 0.6 ? $5 : NaN):(100*abs($4/truth-1)) with points ls style_of('leapfrog') ps 0.4*big, \
     cost using (strcol(1)[1:9] eq 'particles' ? $5 : NaN):6 with points ls 5
