# data: build/data/11-bound-stiff.dat
# command: build/bin/scene double-pendulum | build/bin/step - --dt 0.0285 --until 9.69 --every 0.0285 --bound 1e300 --observe parts -o build/data/11-bound-stiff.dat
# data: build/data/11-bound-good.dat
# command: build/bin/scene circumbinary | build/bin/step - --dt 4 --until 9600 --every 12 --observe parts -o build/data/11-bound-good.dat
# data: build/data/11-bound-euler.dat
# command: build/bin/scene double-pendulum | build/bin/step - --dt 0.002 --method euler --until 6 --every 0.01 --bound 1e300 --observe parts -o build/data/11-bound-euler.dat
# data: build/data/11-bound-spiral.dat
# command: build/bin/scene sun-earth | build/bin/step - --dt 1 --method euler --until 9600 --every 20 --bound 1e300 --observe parts -o build/data/11-bound-spiral.dat
# alt: Energy gained, in units of the scale S, against time, logarithmic upwards. The double pendulum with a step just above leapfrog's limit rises exponentially and crosses the bound 10; by Euler's method at a small step it does so half a second later. Two stars and a planet by leapfrog, ten steps a turn, stay near one hundredth. Euler's Earth levels off at a third, below the bound.
height = 7.2
load 'plots/style.gp'
load 'plots/methods.gp'
set logscale y
set format y '10^{%T}'
set xrange [0:9.6]
set yrange [1e-6:1e6]
set xlabel 'time  (s; of stars and planets in thousands of days)'
set ylabel '({/:Italic E} − {/:Italic E}_0)/{/:Italic S}' offset 0.6
eval edges(0.11, 0.98, 0.155, 0.97)
set key at graph 0.985,0.97 right Left reverse samplen 2 spacing 1.1
set label 1 'the bound' at 9.5,22 right tc rgb '#555555'
neg(x) = x < 0 ? -x : 0
E(a,b,c,d) = a + b + c + d
grown(a,b,c,d) = (n = n + 1, n == 1 ? e0 = E(a,b,c,d) : 0, s = n == 1 ? 0 : s, q = neg(b) + neg(c) + neg(d), s = q > s ? q : s, g = (E(a,b,c,d) - e0) / (abs(e0) + s), g > 1e-6 ? g : NaN)
step(name) = option('build/data/11-bound-'.name.'.dat', 'dt')
plot 10 ls 9, \
     n = 0, 'build/data/11-bound-euler.dat' using 1:(grown($2,$3,$4,$5)) with lines ls style_of('euler') lw 1.8*thick title 'double pendulum, Euler, '.step('euler').' s', \
     n = 0, 'build/data/11-bound-stiff.dat' using 1:(grown($2,$3,$4,$5)) with lines ls style_of('leapfrog') title 'leapfrog, '.step('stiff').' s', \
     n = 0, 'build/data/11-bound-spiral.dat' using ($1/1000):(grown($2,$3,$4,$5)) with lines ls style_of('euler') lw 1.8*thick dt '-' title 'Sun and Earth, Euler, '.step('spiral').' d', \
     n = 0, 'build/data/11-bound-good.dat' using ($1/1000):(grown($2,$3,$4,$5)) with points ls style_of('leapfrog') ps 0.2*big title 'Kepler-16, leapfrog, '.step('good').' d'
