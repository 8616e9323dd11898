# data: build/data/12-averages.dat
# command: build/bin/averages-studies -o build/data/12-averages.dat
# alt: Mean pressure of two disks against the time over which the mean is taken, from 128 to 131072 s, for twenty starts each. The points make a funnel about the law, 1.24, and scatter by 0.02 at 128 s and by 0.001 at 131072 s. Answers with error bars of about 0.01 only from 8192 s on; all lie on the law within their bars.
width = 12
file = 'build/data/12-averages.dat'
load 'plots/style.gp'
# Z = a p(r) of two disks, as in 06-two.gp.
s = 0.3; a = 0.7
alpha = 1 - pi*s**2/a**2 + 8*s**3/(3*a**3) - s**4/(2*a**4)
law = (1 - pi*s**2/(2*a**2) + 2*s**3/(3*a**3))/alpha
set logscale x 2
set xrange [90:280000]
set xtics ('128' 128, '512' 512, '2048' 2048, '8192' 8192, '32768' 32768, '131072' 131072)
set yrange [1.19:1.29]
set xlabel 'time {/:Italic T}  (s)'
set ylabel 'mean pressure {/:Italic Z}'
set key right top samplen 1.5 Left reverse
plot law ls 9 lw 2*thick title 'law', \
     file using 1:3 ls 1 title 'means over {/:Italic T}', \
     file using ($1*1.12*1.06**$2):($2 <= 6 ? $4 : 1/0):5 with yerrorbars ls 2 title 'answers'
