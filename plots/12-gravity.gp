# data: build/data/12-atlas.dat
# command: build/bin/bonk-studies --study atlas -o build/data/12-atlas.dat
# alt: The map of the solar system: true error against cost, both logarithmic. Curves fall to the right, the steeper the higher their order.
height = 17.5
load 'plots/style.gp'
scene = 'solar-system'
ways = 'leapfrog rk4 pefrl kahan-li8 wisdom-holman sbab4 dopri5 radau15'
stepless = 'kepler,no-light'
xlow = 1e-6
xhigh = 0.4
ylow = lecture ? 1e-22 : 1e-19
deep = 1e-8
band = 1.5e-16
load 'plots/map.gp'
