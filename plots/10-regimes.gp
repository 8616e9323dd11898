# data: build/data/10-regimes.dat
# command: build/bin/springs-studies --study regimes -o build/data/10-regimes.dat
# data: build/data/10-critical.dat
# command: build/bin/springs-studies --study critical -o build/data/10-critical.dat
# alt: Two panels. Left, the place of the mass over fifteen seconds for four dampings: an oscillation that dies slowly, one that dies after one swing, the aperiodic limit, and a slow creep; the points of the leapfrog lie on the curves of the closed form. Right, with logarithmic axes, the relative error at three seconds against the distance from critical damping: the textbook's two formulas lose digits as one over the square root of the distance, up to a few times ten to the minus nine, ours stays at ten to the minus sixteen.
load 'plots/style.gp'
set multiplot layout 1,2 margins 0.075,0.985,0.16,0.97 spacing 0.135,0
set xlabel 'time  (s)'
set ylabel 'place {/:Italic q}  (m)' offset 1.5
set xrange [0:15]
set yrange [-0.85:1.05]
set key at graph 0.98,0.98 right top samplen 1.5
set xzeroaxis ls 9
f(g, t) = g < 1 ? exp(-g*t)*(cos(sqrt(1-g*g)*t) + g*sin(sqrt(1-g*g)*t)/sqrt(1-g*g)) : \
          g > 1 ? exp(-g*t)*(cosh(sqrt(g*g-1)*t) + g*sinh(sqrt(g*g-1)*t)/sqrt(g*g-1)) : exp(-t)*(1 + t)
set samples 300
plot f(0.1, x) ls 9, f(0.5, x) ls 9, f(1, x) ls 9, f(2, x) ls 9, \
     'build/data/10-regimes.dat' every 3 using 1:2 with points ls 1 title '{/:Italic γ} = 0.1 s^{−1}', \
     '' every 3 using 1:3 with points ls 2 title '0.5', \
     '' every 3 using 1:4 with points ls 3 title '1', \
     '' every 3 using 1:5 with points ls 4 title '2'
eval powers
set xlabel 'distance from the limit, |{/:Italic γ}/{/:Italic ω}_0 − 1|'
set ylabel 'relative error of {/:Italic q}(3 s)' offset 0
set xrange [1e-15:1]
set xtics 1e-15,1e3
set ytics 1e-16,1e2
set yrange [3e-17:1e-6]
t = 3
w(g) = sqrt(abs((1 - g)*(1 + g)))
ours(g) = exp(-g*t)*(g < 1 ? cos(w(g)*t) + g*t*(sin(w(g)*t)/(w(g)*t)) : cosh(w(g)*t) + g*t*(sinh(w(g)*t)/(w(g)*t)))
e(a, b) = abs(a/b - 1) + 5e-17
plot 'build/data/10-critical.dat' using 1:(e($3, $2)) with points ls 2 title 'two exponentials', \
     '' using 1:(e($5, $4)) with points ls 4 title 'cosine with a phase', \
     '' using 1:(e(ours(1 + $1), $2)) with points ls 1 title 'one formula for all'
