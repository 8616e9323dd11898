# data: plots/data/03-cost.dat
# alt: A series of 128 samples that wander about slowly. Short steps are the means of blocks of four, which follow the series and each other; long thick steps are the means of blocks of thirty-two, of which neighbours do not resemble each other.
height = 5.4
load 'plots/style.gp'
# Each sample remembers nine tenths of the last one.
seed = 98765432.0
draw(dummy) = (seed = seed*16807.0 - floor(seed*16807.0/2147483647.0)*2147483647.0, seed/2147483647.0)
normal(dummy) = sqrt(-2*log(draw(0)))*cos(2*pi*draw(0))
phi = 0.9
x = normal(0)
array M[32]
array L[4]
set print $series
do for [k=0:127] {
    x = phi*x + sqrt(1 - phi*phi)*normal(0)
    print k, x
    M[k/4+1] = (k % 4 ? M[k/4+1] : 0.0) + x/4
    L[k/32+1] = (k % 32 ? L[k/32+1] : 0.0) + x/32
}
set print $short
do for [k=1:32] { print 4*k-4.5, M[k]; print 4*k-0.5, M[k]; print '' }
set print $long
do for [k=1:4] { print 32*k-32.5, L[k]; print 32*k-0.5, L[k]; print '' }
unset print
set margins 8,2,3,2
set xrange [-1:128]
set xtics 32
set xlabel 'sample'
set ylabel '{/:Italic x}' offset 1
set key above samplen 1.5
plot $series with linespoints lc rgb grey pt 7 ps 0.3*big lw 0.8*thick title 'samples', \
     $short with lines lc rgb blue lw 2*thick title 'means of 4', \
     $long with lines lc rgb red lw 4*thick title 'means of 32'
