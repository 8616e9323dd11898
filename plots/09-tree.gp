# data: plots/data/09-tree.dat
# alt: Time of one evaluation of all forces against the number of particles in a ring, both axes logarithmic, from 125 to 32000. The direct sums rise with slope two, the vector kernel at two thirds of the portable one. Two trees rise with slopes near 1.2 and 1.3 and cross the vector kernel at a few hundred particles, that with the larger cells first. A vertical line marks 3072.
load 'plots/style.gp'
file = 'plots/data/09-tree.dat'
eval edges(0.11, 0.985, 0.16, 0.97)
eval powers
set xlabel 'particles {/:Italic N}'
set ylabel 'time of all forces  (ms)' offset 1
set xrange [100:40000]
set yrange [0.005:1e4]
set key at graph 0.03,0.96 left top Left reverse samplen 2
set arrow from 3072,0.005 to 3072,1e4 nohead ls 9
plot file using 1:2 with linespoints ls 2 title 'direct, portable', \
     file using 1:3 with linespoints ls 1 title 'direct, vectors', \
     file using 1:4 with linespoints ls 3 title 'tree, {/Symbol q} = 0.2', \
     file using 1:7 with linespoints ls 4 dt 2 title 'tree, {/Symbol q} = 0.5'
