# data: build/data/02-worldlines.dat
# command: build/bin/bonkers --masses 9.3,2.1,5.2,0.9,3.4,1.2,4.3,0.8,2.6,1.4 --positions 0.5,4.6,5.3,6.2,6.9,7.8,8.5,9.4,10.2,11.1 --velocities 2,0,0,0,0,0,0,0,0,0 --walls 0,12 --every 0.005 --until 7.5 -o build/data/02-worldlines.dat
# alt: Six pictures of one wire between two stops, one below the other, 1.5 seconds apart. At first a large bead is alone on the left and nine others rest on the right. In the second picture it has nearly reached them, in the third the first three have moved, and in the last three all ten stand in ever other places.
height = 5.7
load 'plots/style.gp'
file = 'build/data/02-worldlines.dat'
array M[10]
do for [i=1:10] { M[i] = mass(file, i) }
r(i) = 0.11*sqrt(M[i])
array S[10]
sum = 0
do for [i=1:10] {
    S[i] = sum + r(i)
    sum = sum + 2*r(i)
}
wire = 12 + sum
unset border
unset tics
set margins 0,0,0,0
set xrange [-1.75:wire+0.35]
set yrange [-5.65:0.6]
do for [k=0:5] {
    set arrow 10+k from 0,-k to wire,-k nohead lc rgb grey lw 1.2*thick back
    set object 20+k rectangle from -0.14,-k-0.36 to 0,-k+0.36 fc rgb '#555555' fs solid noborder
    set object 30+k rectangle from wire,-k-0.36 to wire+0.14,-k+0.36 fc rgb '#555555' fs solid noborder
    set label 10+k sprintf('%.1f s', 1.5*k) at -0.4,-k right tc rgb '#333333'
}
wash(i) = M[i] > 3 ? 0xcfe3f1 : 0xf7d9c4
hue(i) = M[i] > 3 ? 0x0072b2 : 0xd55e00
plot for [k=0:5] for [i=1:10] file every ::300*k::300*k using (column(3+2*i)+S[i]):(-k):(r(i)):(wash(i)) with circles lc rgb variable fs solid noborder, \
     for [k=0:5] for [i=1:10] file every ::300*k::300*k using (column(3+2*i)+S[i]):(-k):(r(i)):(hue(i)) with circles lc rgb variable lw 1.5*thick fs empty
