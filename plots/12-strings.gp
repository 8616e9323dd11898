# data: build/data/12-atlas.dat
# command: build/bin/bonk-studies --study atlas -o build/data/12-atlas.dat
# alt: The map of Newton's cradle on strings.
height = 17.5
load 'plots/style.gp'
scene = 'strings'
ways = 'leapfrog rk4 pefrl kahan-li8 dopri5 radau15'
xlow = 1e-4
xhigh = 2
ylow = 1e-20
deep = 1e-8
band = 6e-16
byhand = 'leapfrog'
set label 1 'leapfrog' at 1.7e-3,2.4e-3 right font face.(lecture ? ',18' : ',8')
load 'plots/map.gp'
