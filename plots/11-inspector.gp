# data: build/data/11-membrane.dat
# command: build/bin/scene membrane | build/bin/step - --until 40 --every 0.05 --observe t,z:30 -o build/data/11-membrane.dat
# data: build/data/11-parts.dat
# command: build/bin/scene double-pendulum | build/bin/step - --until 6 --every 0.01 --observe t,parts,energy -o build/data/11-parts.dat
# data: build/data/11-eight.dat
# command: build/bin/scene figure-eight | build/bin/step - --until 5 --every 0.01 --observe x:0,y:0 -o build/data/11-eight.dat
# data: build/data/11-phase.dat
# command: build/bin/scene oscillator --damping 0.2 | build/bin/step - --until 40 --every 0.05 --observe x:1,vx:1 -o build/data/11-phase.dat
# slides: 2
# alt: Four panels. Height of body 30 of the membrane against time: an oscillation. The parts of the energy of the double pendulum against time: kinetic energy, springs and weight exchange, their sum is a straight line. Place of one of three bodies, y against x: a lying eight, not yet closed. Velocity against place of a damped oscillator: a spiral into the point of rest.
height = 10
load 'plots/style.gp'
set multiplot
left(k) = k % 2 ? 0.59 : 0.1
low(k) = slide ? 0.15 : k < 2 ? 0.61 : 0.115
do for [k=slide == 2 ? 2 : 0:slide == 1 ? 1 : 3] {
    eval edges(left(k), left(k) + (k % 2 ? 0.39 : 0.375), low(k), low(k) + (slide ? 0.81 : 0.365))
    set key at graph 0.99,0.30 right samplen 1.5 spacing 1.0
    set xlabel (k == 2 ? '{/:Italic x}_0' : k == 3 ? '{/:Italic x}_1  (m)' : '{/:Italic t}  (s)') offset 0,0.6
    set ylabel (k == 0 ? '{/:Italic z}_{30}  (m)' : k == 1 ? 'energy  (J)' : k == 2 ? '{/:Italic y}_0' : '{/:Italic v}_1  (m/s)') offset (k % 2 ? 0.2 : 1.2)
    if (k == 0) { set xrange [0:40]; set yrange [*:*]; set ytics 0.02; plot 'build/data/11-membrane.dat' using 2:3 with lines lc rgb blue lw 1.2*thick }
    if (k != 0) { set ytics auto }
    if (k == 1) { set xrange [0:6]; set yrange [-3.4:3.4]; set key at graph 0.99,0.985 right horizontal maxcols 2 samplen 1.5; plot 'build/data/11-parts.dat' using 2:3 with lines lc rgb blue lw 1.5*thick title 'kinetic', \
        '' using 2:5 with lines lc rgb red lw 1.5*thick dt '-' title 'springs', \
        '' using 2:6 with lines lc rgb green lw 1.5*thick dt '.-' title 'weight', \
        '' using 2:7 with lines lc rgb dark lw 1*thick title 'sum' }
    if (k == 2) { set xrange [-1.3:1.3]; set yrange [-0.45:0.45]; plot 'build/data/11-eight.dat' using 2:3 with lines lc rgb blue lw 1.5*thick, '' every ::0::0 using 2:3 with points ls 1 }
    if (k == 3) { set xrange [*:*]; set yrange [*:*]; plot 'build/data/11-phase.dat' using 2:3 with lines lc rgb blue lw 1.2*thick, '' every ::0::0 using 2:3 with points ls 1 }
}
