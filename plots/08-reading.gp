# data: plots/data/08-reading.dat
# alt: Two panels against the number of digits, 1 to 19. Left, nanoseconds to read a number: both rise slowly with the digits, ours at less than half the height of the C library's. Right, the share of numbers read in each way: up to 15 digits all by one operation, from 17 on nearly all as a head and a tail, none by the library.
width = 14
height = 6
load 'plots/style.gp'
set multiplot layout 1,2 margins 0.085,0.985,0.19,0.96 spacing 0.1,0
set xlabel 'digits'
set xrange [0:20]
set xtics 5
set ylabel 'time to read a number  (ns)' offset 1
set yrange [0:*]
set key left top samplen 2
plot 'plots/data/08-reading.dat' index 0 using 1:3 with linespoints ls 2 title 'strtod', \
     'plots/data/08-reading.dat' index 0 using 1:2 with linespoints ls 1 title 'ours'
set ylabel 'share of numbers' offset 1
set yrange [-0.05:1.05]
set key left center
plot 'plots/data/08-reading.dat' index 0 using 1:4 with linespoints ls 1 title 'one operation', \
     'plots/data/08-reading.dat' index 0 using 1:5 with linespoints ls 3 title 'head and tail', \
     'plots/data/08-reading.dat' index 0 using 1:6 with linespoints ls 2 title 'library'
unset multiplot
