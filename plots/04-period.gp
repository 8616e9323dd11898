# data: build/data/04-adiabatic.dat
# command: build/bin/bonkers --preset adiabatic --ensemble 50 --every 0.5 --until 100 | build/bin/piston --study gases --body 201 --table - -o build/data/04-adiabatic.dat
# lecture: build/bin/bonkers --preset adiabatic --ensemble 1000 --every 0.5 --until 100 | build/bin/piston --study gases --body 201 --table - -o build/data/04-adiabatic.dat
# data: build/data/04-bare.dat
# command: build/bin/piston0 0.1 0 200 > build/data/04-bare.dat
# data: build/data/04-added.dat
# command: build/bin/piston0 0.1 6.6666666666666667 200 > build/data/04-added.dat
# data: build/data/04-amplitude.dat
# command: for v in 0.01 0.1 0.2 0.3 0.4 0.5 0.6 0.8 1 1.2 1.5 1.8 2.2 2.6 3; do build/bin/piston --velocity $v --gas-masses 0,0 -o /dev/null --summary - | tr '\n' ' '; echo; done > build/data/04-amplitude.dat
# data: build/data/04-swings.dat
# command: for p in 40,300,95,.5 160,1200,190,1 640,4800,330,2 2560,19200,480,2 10240,76800,580,3; do IFS=,; set -- $p; printf '%s ' $1; build/bin/bonkers --preset adiabatic --particles 101 --mass-ratio $2 --until $3 --every $4 --ensemble 16 | build/bin/piston --study measure --body 51 --window $4 --table - -o /dev/null --summary - | tr '\n' ' '; echo; done > build/data/04-swings.dat
# alt: Left: position of the piston against time for a small swing among 400 particles. The measured points follow the curve with the added mass and run ever further behind the bare curve, by 5 seconds after 100. Right: period divided by that of small swings, against amplitude divided by half the box. The theory falls from 1 to 0.37 at an amplitude of 0.76; five measured points lie on it, and the isothermal guess of 1.73 is far above.
height = 7.2
load 'plots/style.gp'
set multiplot layout 1,2 margins 0.095,0.985,0.165,0.97 spacing 0.105,0
set xlabel 'time {/:Italic t}  (s)'
set ylabel 'position  {/:Italic x} − 6 m  (m)' offset 1
set xrange [0:100]
set yrange [-0.7:1.05]
set ytics 0.5
set mytics 5
set key at graph 0.97,0.97 right top samplen 2 maxrows 2 width -1
set zeroaxis ls 9 lw 0.5*thick
plot 'build/data/04-bare.dat' using 1:($2-6) with lines lw 1.5*thick lc rgb red dt 2 title 'bare', \
     'build/data/04-added.dat' using 1:($2-6) with lines lw 1.5*thick lc rgb blue title 'added mass', \
     'build/data/04-adiabatic.dat' every 4 using 1:($2-6) with points pt 6 ps 0.6*big lc rgb dark title 'particles'
set xlabel 'amplitude / {/:Italic h}'
set ylabel 'period {/:Italic T} / {/:Italic T}_0'
set xrange [0:0.9]
set xtics 0.2
set yrange [0:1.9]
unset zeroaxis
small(M) = 2*pi*sqrt((M + 40.0/9)*36/40)
set label 1 'isothermal' at 0.03,1.62
set label 2 'adiabatic' at 0.03,0.86
plot 'build/data/04-amplitude.dat' using ($4/6 - 1):($12/$10) smooth csplines with lines lw 1.5*thick lc rgb blue, \
     [0:0.25] sqrt(3) ls 9 lw 1.5*thick dt 2, \
     'build/data/04-swings.dat' using ($7/6):($15/small($1)) with points pt 6 ps 0.8*big lc rgb dark
