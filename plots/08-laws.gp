# data: build/data/08-laws.dat
# command: build/bin/step-studies --study laws -o build/data/08-laws.dat
# alt: Energy of an oscillator against the number of steps, logarithmic upwards. Euler's points rise on a straight line to ten to the sixth in 60 steps. RK4's fall slowly along their line. Leapfrog's waver just below one, symplectic Euler's swing about one.
height = 6.5
load 'plots/style.gp'
load 'plots/methods.gp'
file = 'build/data/08-laws.dat'
set multiplot layout 1,2 margins 0.095,0.985,0.17,0.96 spacing 0.11,0
set xlabel 'steps'
set xrange [0:60]
h2 = 0.25
set logscale y
set format y '10^{%T}'
set ylabel 'energy / energy at the start' offset 1
set yrange [0.3:1e7]
set label 1 'Euler' at 36,2e5 right
plot (1+h2)**x ls 9 lw 1.5*thick, file using 1:2 with points ls style_of('euler')
unset logscale y
set format y '%.2f'
set ylabel ''
set yrange [0.7:1.7]
set ytics 0.1
set key at graph 0.97,0.97 right top samplen 1.5
plot (1-h2**3/72+h2**4/576)**x ls 9 lw 1.5*thick, 1 ls 9, 1-h2/4 ls 9 dt 2, \
     file using 1:3 with linespoints ls style_of('symplectic-euler') lw 0.5*thick title name_of('symplectic-euler'), \
     file using 1:4 with linespoints ls style_of('leapfrog') lw 0.5*thick title name_of('leapfrog'), \
     file using 1:5 with points ls style_of('rk4') title name_of('rk4')
