# data: plots/data/06-reference.dat
# alt: Twenty-seven small square boxes, each with four disks thrown into it. In twenty-six some disks overlap and are drawn in red; in one, framed with a thick line, all four stand apart.
height = 4.9
load 'plots/style.gp'
r = 0.15
# Numbers of this figure's own, so that it looks alike with every gnuplot.
seed = 28.0
draw(dummy) = (seed = seed*16807.0 - floor(seed*16807.0/2147483647.0)*2147483647.0, seed/2147483647.0)
eval drawing
set xrange [-0.06:10.32]
set yrange [-0.06:3.4]
set margins 0,0,0,0
array X[4]; array Y[4]; array hit[4]
do for [n=0:26] {
    x0 = (n % 9)*1.16
    y0 = 2.32 - floor(n/9)*1.16
    do for [i=1:4] { X[i] = r + (1-2*r)*draw(0); Y[i] = r + (1-2*r)*draw(0); hit[i] = 0 }
    do for [i=1:4] { do for [j=1:4] { if (i != j && (X[i]-X[j])**2 + (Y[i]-Y[j])**2 < 4*r*r) { hit[i] = 1 } } }
    fits = hit[1]+hit[2]+hit[3]+hit[4] == 0
    set object 10*n+1 rectangle from x0,y0 to x0+1,y0+1 fs empty border lc rgb (fits ? dark : grey) lw (fits ? 3 : 0.8)*thick
    do for [i=1:4] {
        set object 10*n+1+i circle at x0+X[i],y0+Y[i] size r fc rgb (hit[i] ? '#f7d9c4' : '#cfe3f1') fs transparent solid 0.6 border lc rgb (hit[i] ? red : blue) lw 1*thick
    }
}
plot 1/0
