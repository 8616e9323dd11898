# data: build/data/06-two.dat
# command: build/bin/sample --disks 2 --samples 1e6 --bins 40 -o build/data/06-two.dat
# lecture: build/bin/sample --disks 2 --samples 1e7 --bins 40 -o build/data/06-two.dat
# data: build/data/06-accept2.dat
# command: build/bin/sample-studies --study acceptance --disks 2 --radii 0.02,0.04,0.06,0.08,0.1,0.12,0.14,0.16,0.18,0.2,0.22,0.24 --samples 20000 -o build/data/06-accept2.dat
# lecture: build/bin/sample-studies --study acceptance --disks 2 --radii 0.02,0.04,0.06,0.08,0.1,0.12,0.14,0.16,0.18,0.2,0.22,0.24 --samples 200000 -o build/data/06-accept2.dat
# alt: Left, density of a coordinate of two disks: 1.77 at the walls, 1.22 in the middle; points lie on the curve. Right, acceptance against radius falls from 1 at radius 0 to 0.02 at 0.25; points lie on the curve.
height = 6.5
load 'plots/style.gp'
s = 0.3; a = 0.7
alpha(a,s) = 1 - pi*s**2/a**2 + 8*s**3/(3*a**3) - s**4/(2*a**4)
I(t) = (t*sqrt(s**2-t**2) + s**2*asin(t/s))/a - (s**2*t - t**3/3)/a**2
low(x,y) = x < y ? x : y
p(x) = x < 0.15 || x > 0.85 ? NaN : (1 - (I(low(x-0.15,s)) + I(low(0.85-x,s)))/a)/(alpha(a,s)*a)
set multiplot layout 1,2 margins 0.085,0.985,0.19,0.97 spacing 0.12,0
set samples 401
set xrange [0:1]
set yrange [1:2]
set xlabel 'position {/:Italic x}  (m)'
set ylabel 'density {/:Italic p}  (1/m)' offset 1
plot p(x) ls 9 lw 2*thick, 'build/data/06-two.dat' using ($2 > 0 ? $1+0.0125 : NaN):2:3 with yerrorbars ls 1 ps 0.5*big
set xrange [0:0.26]
set yrange [0:1]
set xlabel 'radius {/:Italic r}  (m)'
set ylabel 'acceptance' offset 1
plot (x <= 0.25 ? alpha(1-2*x,2*x) : NaN) ls 9 lw 2*thick, 'build/data/06-accept2.dat' using 1:3:4 with yerrorbars ls 1
