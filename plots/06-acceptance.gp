# data: build/data/06-accept-2.dat
# command: build/bin/sample-studies --study acceptance --disks 2 --radii 0.04,0.08,0.12,0.16,0.19,0.22,0.24 --samples 10000 -o build/data/06-accept-2.dat
# lecture: build/bin/sample-studies --study acceptance --disks 2 --radii 0.04,0.08,0.12,0.16,0.19,0.22,0.24 --samples 100000 -o build/data/06-accept-2.dat
# data: build/data/06-accept-4.dat
# command: build/bin/sample-studies --study acceptance --disks 4 --radii 0.03,0.06,0.08,0.1,0.12,0.14,0.16,0.175,0.185,0.195,0.205 --samples 2000 -o build/data/06-accept-4.dat
# lecture: build/bin/sample-studies --study acceptance --disks 4 --radii 0.03,0.06,0.08,0.1,0.12,0.14,0.16,0.175,0.185,0.195,0.205 --samples 10000 -o build/data/06-accept-4.dat
# data: build/data/06-accept-8.dat
# command: build/bin/sample-studies --study acceptance --disks 8 --radii 0.02,0.04,0.055,0.065,0.075,0.085,0.095,0.105,0.115 --samples 2000 -o build/data/06-accept-8.dat
# lecture: build/bin/sample-studies --study acceptance --disks 8 --radii 0.02,0.04,0.055,0.065,0.075,0.085,0.095,0.105,0.115 --samples 10000 -o build/data/06-accept-8.dat
# data: build/data/06-accept-16.dat
# command: build/bin/sample-studies --study acceptance --disks 16 --radii 0.01,0.02,0.03,0.035,0.04,0.045,0.05,0.055,0.06,0.065,0.0675 --samples 400 -o build/data/06-accept-16.dat
# lecture: build/bin/sample-studies --study acceptance --disks 16 --radii 0.01,0.02,0.03,0.035,0.04,0.045,0.05,0.055,0.06,0.065,0.07 --samples 10000 -o build/data/06-accept-16.dat
# alt: Acceptance, logarithmic, against packing for 2, 4, 8 and 16 disks. All begin at one and fall, the faster the more disks: at packing 0.2 it is 0.4 for two disks and 0.0002 for sixteen. Dashed lines of independent pairs lie above the points and the farther the more crowded the box is.
height = 7.5
load 'plots/style.gp'
eval edges(0.105, 0.985, 0.15, 0.97)
set logscale y
set format y '10^{%T}'
set xrange [0:0.55]
set yrange [1e-6:2]
set xlabel 'packing η'
set ylabel 'acceptance α' offset 0.6
set samples 300
r(eta,N) = sqrt(eta/pi/N)
a(x) = 1 - 2*x
two(x) = 1 - pi*4*x**2/a(x)**2 + 64*x**3/(3*a(x)**3) - 8*x**4/a(x)**4
alpha(eta,N) = (r(eta,N) > 0.25 ? NaN : two(r(eta,N)))
set key at graph 0.98,0.97 right top samplen 1
drawn(k) = word('build/data/06-accept-2.dat build/data/06-accept-4.dat build/data/06-accept-8.dat build/data/06-accept-16.dat', k)
plot alpha(x,2) ls 9 lw 2*thick, \
     for [N in '4 8 16'] alpha(x,N+0)**(N*(N-1)/2) ls 9 lw 1*thick dt 2, \
     for [k=1:4] drawn(k) using 2:3:4 with yerrorbars ls k title word('2 4 8 16',k).' disks'
