# data: build/data/02-worldlines.dat
# command: build/bin/bonkers --masses 9.3,2.1,5.2,0.9,3.4,1.2,4.3,0.8,2.6,1.4 --positions 0.5,4.6,5.3,6.2,6.9,7.8,8.5,9.4,10.2,11.1 --velocities 2,0,0,0,0,0,0,0,0,0 --walls 0,12 --every 0.005 --until 7.5 -o build/data/02-worldlines.dat
# alt: World lines of ten beads between two stops, position across and time upwards. Nine lines rise straight up until, at two seconds, a thick line that came from the left runs into the first of them; from there a wave goes through to the right stop and back. Every collision is a dot; at each of them two lines bend, and no line crosses another.
height = 7.6
load 'plots/style.gp'
file = 'build/data/02-worldlines.dat'
set xlabel 'position {/:Italic x} (m)'
set ylabel 'time {/:Italic t} (s)' offset 0.8
set xrange [-0.15:12.15]
set yrange [0:6]
eval edges(0.085, 0.98, 0.145, 0.97)
set arrow 1 from 0,graph 0 to 0,graph 1 nohead ls 9 lw 4*thick
set arrow 2 from 12,graph 0 to 12,graph 1 nohead ls 9 lw 4*thick
array M[10]
do for [i=1:10] { M[i] = mass(file, i) }
hue(i) = M[i] > 3 ? 0x0072b2 : 0xd55e00
# A collision in gap i changes two velocities between two rows; a stop keeps its own.
array last[12]
do for [k=1:12] { last[k] = 0.0 }
h = 0
jumped(j) = j >= 1 && j <= 10 && column(4+2*j) != last[j+1]
hit(i) = $0 > 0 && (i == 0 ? jumped(1) && !jumped(2) : i == 10 ? jumped(10) && !jumped(9) : jumped(i) && jumped(i+1))
keep(i) = (i > 0 ? last[i+1] = column(4+2*i) : 0, i < 10 ? last[i+2] = column(6+2*i) : 0, 0)
mark(i) = (h = hit(i), keep(i), h ? column(3+2*(i > 0 ? i : 1)) : NaN)
plot for [i=1:10] file using (column(3+2*i)):1 with lines lc rgb hue(i) lw (0.5+0.35*M[i])*thick, \
     for [i=0:10] file using (mark(i)):1 with points pt 7 ps 0.45*big lc rgb dark
