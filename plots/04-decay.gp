# data: build/data/04-share.dat
# command: build/bin/bonkers --preset piston --ensemble 2000 --every 0.5075 --until 913.5 | build/bin/piston --study measure --fit 0.07,0.02 --table - -o build/data/04-share.dat
# lecture: build/bin/bonkers --preset piston --ensemble 20000 --every 0.5075 --until 913.5 | build/bin/piston --study measure --fit 0.07,0.02 --table - -o build/data/04-share.dat
# data: build/data/04-masses.dat
# command: for s in 1 2 3 4; do for p in 20,1.41421356,300,1.435,14.35,1500,0.01 40,1,900,2.03,20.3,500,0.02 80,0.70710678,4000,2.87,28.7,400,0.02 160,0.5,16000,4.06,40.6,200,0.03; do IFS=,; set -- $p; printf '%s ' $1; build/bin/bonkers --preset piston --masses 1.2,1.26667,1.33333,1.4,1.46667,$1,1.44,1.38667,1.33333,1.28,1.22667 --velocities 1,1,1,1,1,$2,1,1,1,1,1 --until $3 --every $4 --ensemble $6 --seed $s | build/bin/piston --study measure --window $5 --fit 0.07,$7 --table - -o /dev/null --summary - | sed -n 's/^tau //p'; done; done > build/data/04-masses.dat
# lecture: for s in 1 2 3 4; do for p in 20,1.41421356,300,1.435,14.35,10000,0.01 40,1,900,2.03,20.3,2500,0.02 80,0.70710678,4000,2.87,28.7,1000,0.02 160,0.5,16000,4.06,40.6,500,0.03 320,0.35355339,80000,5.74,57.4,100,0.03; do IFS=,; set -- $p; printf '%s ' $1; build/bin/bonkers --preset piston --masses 1.2,1.26667,1.33333,1.4,1.46667,$1,1.44,1.38667,1.33333,1.28,1.22667 --velocities 1,1,1,1,1,$2,1,1,1,1,1 --until $3 --every $4 --ensemble $6 --seed $s | build/bin/piston --study measure --window $5 --fit 0.07,$7 --table - -o /dev/null --summary - | sed -n 's/^tau //p'; done; done > build/data/04-masses.dat
# alt: Left: the excess of the piston's share over one eleventh against time, logarithmic: it drops from 0.6 to 0.13 in the first 50 seconds and then falls along a straight line by a factor e in about 210 seconds. Right: decay time against the piston's mass, both logarithmic: four points from 35 seconds at 20 kilograms to some 6000 seconds at 160 kilograms rise parallel to the theory of forgetful particles, a factor of two above it, and far above the friction without memory.
height = 7.5
load 'plots/style.gp'
masses = 'build/data/04-masses.dat'
set multiplot layout 1,2 margins 0.115,0.985,0.16,0.97 spacing 0.12,0
set logscale y
set xlabel 'time {/:Italic t}  (s)'
set ylabel 'share of the piston − 1/11' offset 0.2
set xrange [0:900]
set xtics 200
set yrange [0.002:1]
set format y '10^{%T}'
plot 'build/data/04-share.dat' using 1:($3-1/11.0) with lines ls 9 lw 2*thick, \
     'build/data/04-share.dat' using 1:($2-1/11.0) with points ls 1 ps 0.5*big

# Mean and standard error of the seeds for each mass.
set logscale xy
set xlabel 'mass of the piston {/:Italic M}  (kg)'
set ylabel 'decay time {/:Italic τ}  (s)'
set xrange [10:500]
set xtics (10,20,40,80,160,320)
set yrange [1:1e5]
kT = 2*(80/3.0)/11
friction = 4*(4/3.0)*(5/6.0)*sqrt(2*kT/(pi*4/3.0))
moving(M) = M + 40/9.0
u(M) = 3*(20/3.0)/moving(M)*4/sqrt(15)
kept(M) = 1 - (1 + u(M))*exp(-u(M))
set print $means
do for [k=0:4] {
    M = 20*2**k
    if (system(sprintf("grep -c '^%d ' %s", M, masses)) > 0) {
        stats masses using ($1 == M ? $2 : NaN) nooutput
        print M, STATS_mean, STATS_mean_err
    }
}
unset print
set label 1 'forgetful' at 130,1100 left
set label 2 'no memory' at 60,3 left
plot moving(x)/(friction*kept(x)) with lines lw 1.5*thick lc rgb blue, \
     x/(2*friction) with lines lw 1.5*thick lc rgb red dt 2, \
     $means using 1:2:3 with yerrorbars pt 7 ps 0.6*big lw 1.5*thick lc rgb dark
