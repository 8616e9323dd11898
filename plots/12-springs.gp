# data: plots/data/12-atlas.dat
# slides: 3
# alt: Six panels, error against cost. The oscillator has a closed form at the lower left. The double pendulum, the membrane and the cantilever have staircases from leapfrog down to order four or eight. The pendulum of stiff springs has rods down to ten to the minus 5, then leapfrog with its springs at once at ten to the minus 7. The taut membrane has its modes as a pick for a thousandth and a millionth, and steps for a billionth.
width = 14
height = 16
load 'plots/style.gp'
names = 'oscillator pendulum stiff-springs membrane taut-membrane cantilever'
array titles[6] = ['oscillator', 'double pendulum', 'stiff springs', 'membrane', 'taut membrane', 'cantilever']
rows = 3
keyed = 5
load 'plots/atlas.gp'
