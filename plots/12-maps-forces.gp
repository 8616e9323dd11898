# data: build/data/12-atlas.dat
# command: build/bin/bonk-studies --study atlas -o build/data/12-atlas.dat
# slides: 4
# alt: Eleven panels, error against cost, both logarithmic: gravity and springs. Where two bodies are alone a closed form stands at the lower left. Elsewhere the front is a staircase of methods, from order two at the top through order four to order eight and steps of their own length at the bottom, with a pick just below each of the three tolerances.
height = 19
load 'plots/style.gp'
names = 'sun-earth comet circumbinary choreography figure-eight ring oscillator pendulum membrane taut-membrane cantilever'
array titles[11] = ['Sun and Earth', 'comet', 'circumbinary', 'choreography', 'figure eight', 'ring', 'oscillator', 'double pendulum', 'membrane', 'taut membrane', 'cantilever']
rows = 4
keyx = 1.08
load 'plots/atlas.gp'
