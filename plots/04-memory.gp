# data: build/data/04-adiabatic.dat
# command: build/bin/bonkers --preset adiabatic --ensemble 50 --every 0.5 --until 100 | build/bin/piston --study gases --body 201 --table - -o build/data/04-adiabatic.dat
# lecture: build/bin/bonkers --preset adiabatic --ensemble 1000 --every 0.5 --until 100 | build/bin/piston --study gases --body 201 --table - -o build/data/04-adiabatic.dat
# data: build/data/04-added.dat
# command: build/bin/piston0 0.1 6.6666666666666667 200 > build/data/04-added.dat
# alt: Mean velocity of the piston against time, 0 to 40 seconds. For five seconds the points lie on an exponential decay with time constant 11.3 seconds; then they leave it, pass through zero at 10 seconds and follow a cosine with its minimum at 20 seconds and a maximum at 40.
load 'plots/style.gp'
eval edges(0.105, 0.98, 0.165, 0.97)
set xlabel 'time {/:Italic t}  (s)'
set ylabel 'velocity {/:Italic V}  (m/s)' offset 1
set xrange [0:42]
set yrange [-0.11:0.11]
set zeroaxis ls 9 lw 0.5*thick
set key at graph 0.5,0.96 center top samplen 2
M = 40.0
m = 1.0/30
friction = 4*m*(200/6.0)*sqrt(2*m/(pi*m))
plot 0.1*exp(-friction*x/M) with lines lw 1.5*thick lc rgb red dt 2 title 'friction without memory', \
     'build/data/04-added.dat' using 1:3 with lines lw 1.5*thick lc rgb blue title 'springs with added mass', \
     'build/data/04-adiabatic.dat' using 1:3 with points pt 6 ps 0.6*big lc rgb dark title 'particles'
