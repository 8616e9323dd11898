# data: build/data/12-atlas.dat
# command: build/bin/bonk-studies --study atlas -o build/data/12-atlas.dat
# alt: The map of the stiff pendulum.
height = 17.5
load 'plots/style.gp'
scene = 'stiff-springs'
ways = 'leapfrog pefrl kahan-li8 dopri5 radau15'
less = 'leapfrog,rods'
xlow = 2e-5
xhigh = 3
ylow = 1e-16
deep = 1e-8
band = 6e-13
byhand = 'leapfrog,rods'
set label 1 'leapfrog with rods' at 0.16,2e-7 left font face.(lecture ? ',18' : ',8')
airx = 0
airy = 0.9
load 'plots/map.gp'
