# data: build/data/12-atlas.dat
# command: build/bin/bonk-studies --study atlas -o build/data/12-atlas.dat
# slides: 4
# alt: Eleven panels, error against cost, both logarithmic: bodies on a line and disks. In each a closed form or events stand alone at the lower left, marked as the pick; steps of all methods lie to the right of them, at many times the cost. After twelve seconds nothing holds any tolerance for the four disks.
height = 19
load 'plots/style.gp'
names = 'cradle equal-line heavy-cradle thermal piston galperin four-disks four-late break gas brownian'
array titles[11] = ['cradle', 'fifty balls', 'heavy cradle', 'thermal', 'piston', 'galperin', 'four disks', 'four disks, 12 s', 'break', 'gas', 'brownian']
rows = 4
keyx = 1.08
load 'plots/atlas.gp'
