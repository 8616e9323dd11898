# data: build/data/03-states.dat
# command: build/bin/bonkers --preset thermal --every 10 --samples 2000 -o build/data/03-states.dat
# alt: Two scatter plots of pairs of positions. Left, the two leftmost balls: points in the triangle above the diagonal, thinning out upwards; right, the two rightmost balls, the mirror image. Lines enclose half and nine tenths of the law.
height = 7.2
load 'plots/style.gp'
file = 'build/data/03-states.dat'
set size square
set multiplot layout 1,2 margins 0.085,0.985,0.18,0.97 spacing 0.12,0
set xrange [0:11]
set yrange [0:11]
set tics 2
set xlabel '{/:Italic x}_1  (m)'
set ylabel '{/:Italic x}_2  (m)' offset 1
dot = 0.22*big
# The second of ten is at 11 b, b of the law Beta(2, 9): b where P is q, by halving.
half = 0.0
most = 0.0
do for [k=1:50] {
    step = 11*0.5**k
    half = ibeta(2, 9, (half + step)/11) < 0.5 ? half + step : half
    most = ibeta(2, 9, (most + step)/11) < 0.9 ? most + step : most
}
plot file every ::1 using 5:7 with points pt 7 ps dot lc rgb blue, \
     [0:11] x ls 9, \
     [0:half] half lc rgb dark lw 1.1*thick, [0:most] most lc rgb dark lw 1.1*thick
set xlabel '{/:Italic x}_9  (m)'
set ylabel '{/:Italic x}_{10}  (m)'
plot file every ::1 using 21:23 with points pt 7 ps dot lc rgb red, \
     [0:11] x ls 9, \
     '+' using (11-half):(11-half+(half)*$0/99.) with lines lc rgb dark lw 1.1*thick, \
     '+' using (11-most):(11-most+(most)*$0/99.) with lines lc rgb dark lw 1.1*thick
