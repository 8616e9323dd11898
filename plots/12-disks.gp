# data: plots/data/12-atlas.dat
# slides: 3
# alt: Five panels, error against cost. Events are one point: at ten to the minus 8 for four disks after 4 seconds, at about one after 12 seconds, where no pick is marked, at ten to the minus 15 for the break, at ten to the minus 6 for the gas and ten to the minus 9 for the heavy disk. Steps lie at errors about one, and come below a thousandth only at fifteen to fifty times the cost, or not at all.
width = 14
height = 16
load 'plots/style.gp'
names = 'four-disks four-late break gas brownian'
array titles[5] = ['four disks', 'four disks, 12 s', 'break', 'gas', 'brownian']
rows = 3
keyed = 4
keyx = 0.03
keyy = -0.85
load 'plots/atlas.gp'
