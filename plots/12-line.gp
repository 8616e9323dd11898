# data: plots/data/12-atlas.dat
# slides: 3
# alt: Six panels, error against cost, both logarithmic, from ten to the minus 17 to ten thousand and from a fifth of a microsecond to four tenths of a second. In each a closed form or events stand alone at the lower left, at errors of about ten to the minus 15, marked as the pick. Steps lie at errors about one and, at six to nine hundred times the cost, at ten to the minus 12, with little between.
width = 14
height = 16
load 'plots/style.gp'
names = 'cradle equal-line heavy-cradle thermal piston galperin'
array titles[6] = ['cradle', 'fifty balls', 'heavy cradle', 'thermal', 'piston', 'galperin']
rows = 3
keyed = 4
keyx = 0.12
keyy = 0.3
load 'plots/atlas.gp'
