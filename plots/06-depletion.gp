# data: build/data/06-pair2.dat
# command: build/bin/markov0 100000 | awk -v columns=1 -v bins=100 -v high=2.5 -v block=2000 -f plots/density.awk > build/data/06-pair2.dat
# lecture: build/bin/markov0 1000000 | awk -v columns=1 -v bins=100 -v high=2.5 -v block=20000 -f plots/density.awk > build/data/06-pair2.dat
# data: build/data/06-pair3.dat
# command: build/bin/markov0 15000 3 | awk -v columns=1 -v bins=75 -v high=2.5 -v block=300 -f plots/density.awk > build/data/06-pair3.dat
# lecture: build/bin/markov0 300000 3 | awk -v columns=1 -v bins=75 -v high=2.5 -v block=6000 -f plots/density.awk > build/data/06-pair3.dat
# data: build/data/06-wall2.dat
# command: build/bin/sample --method markov --disks 1 --radius 1 --box 5,5 --small 0.2,60 --bins 100 --step 0.5 --samples 200000 -o build/data/06-wall2.dat
# lecture: build/bin/sample --method markov --disks 1 --radius 1 --box 5,5 --small 0.2,60 --bins 100 --step 0.5 --samples 2000000 -o build/data/06-wall2.dat
# alt: Three panels. Density of the distance of two big disks in the plane, 5 at contact falling to 1 at 2.4; of two balls in space, 2.8 at contact falling to 1 at 2.4; of a disk from a wall, 6 at contact falling to 1 at 1.4. Points of chains lie on the curves of Asakura and Oosawa.
height = 6.5
load 'plots/style.gp'
Z = 1.2
S(h) = h >= Z ? 0 : Z**2*acos(h/Z) - h*sqrt(Z**2-h**2)
cap(h) = h >= Z ? 0 : pi*(Z-h)**2*(2*Z+h)/3
pair(s) = (1 + 2*S(s/2)/(25-2*pi*Z**2))**72
ball(s) = (1 + 2*cap(s/2)/(125-8*pi*Z**3/3))**400
# One disk between four walls: y is averaged over.
free = 4.6**2 - pi*Z**2
side(x) = S(x-0.2) + S(5-x-0.2)
wall(x) = (sum [k=0:59] (1 + (side(x)+side(1.025+0.05*k))/free)**60)/60
set multiplot layout 1,3 margins 0.075,0.98,0.19,0.88 spacing 0.06,0
set samples 201
set xlabel 'distance {/:Italic s}  (m)'
set ylabel 'density, far away 1' offset 1.5
set xtics 0.2
set title 'two disks' offset 0,-0.6
f = 'build/data/06-pair2.dat'
set xrange [*:*]; set yrange [*:*]
stats f using ($1 >= 1.99 ? $2 : 0) nooutput; got = STATS_sum
stats f using ($1 >= 1.99 ? ($1+0.0125)*pair($1+0.0125) : 0) nooutput; c = STATS_sum/got
set xrange [1.95:2.5]
set yrange [0:6]
plot (x < 2 ? NaN : pair(x)) ls 9 lw 2*thick, f using ($1 >= 1.99 ? $1+0.0125 : NaN):(c*$2/($1+0.0125)):(c*$3/($1+0.0125)) with yerrorbars ls 1 ps 0.5*big
unset ylabel
set title 'two balls'
f = 'build/data/06-pair3.dat'
w = 2.5/150
set xrange [*:*]; set yrange [*:*]
stats f using ($1 >= 1.99 ? $2 : 0) nooutput; got = STATS_sum
stats f using ($1 >= 1.99 ? ($1+w)**2*ball($1+w) : 0) nooutput; c = STATS_sum/got
set xrange [1.95:2.5]
set yrange [0:4]
plot (x < 2 ? NaN : ball(x)) ls 9 lw 2*thick, f using ($1 >= 1.99 ? $1+w : NaN):(c*$2/($1+w)**2):(c*$3/($1+w)**2) with yerrorbars ls 2 ps 0.5*big
set title 'a disk and a wall'
set xlabel 'distance {/:Italic x}  (m)'
f = 'build/data/06-wall2.dat'
set xrange [*:*]; set yrange [*:*]
stats f using ($2 > 0 ? ($2+$4)/2 : 0) nooutput; got = STATS_sum
stats f using ($2 > 0 ? wall($1+0.025) : 0) nooutput; c = STATS_sum/got/wall(2.5)
set xrange [0.9:2.5]
set xtics 0.5
set yrange [0:7]
plot (x < 1 ? NaN : wall(x)/wall(2.5)) ls 9 lw 2*thick, f using ($2 > 0 ? $1+0.025 : NaN):(c*($2+$4)/2):(c*sqrt($3**2+$5**2)/2) with yerrorbars ls 3 ps 0.5*big
