# data: plots/data/12-atlas.dat
# slides: 4
# alt: Seven panels, error against cost. For Sun and Earth and for the comet a closed form at ten to the minus 14 is a hundred to two thousand times cheaper than the steps that come near. In the solar system the picks are a closed form at a thousandth, and steps of the eighth order below. In the other four the front is a staircase of methods from order two and four at the top to order eight at the bottom, with a pick just below each of the three tolerances.
width = 14
height = 20
load 'plots/style.gp'
names = 'sun-earth comet solar-system circumbinary choreography figure-eight ring'
array titles[7] = ['Sun and Earth', 'comet', 'solar system', 'circumbinary', 'choreography', 'figure eight', 'ring']
rows = 4
keyed = 6
keyx = 0.03
keyy = -0.85
load 'plots/atlas.gp'
