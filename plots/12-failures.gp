# data: build/data/12-failures.dat
# command: awk -v want=figure -f tests/stability/failures.awk tests/stability/failures.txt > build/data/12-failures.dat
# alt: The failures of this book, each a numbered point, the relative error of the energy to the right and that of the answer upwards, both logarithmic: a crowd in the upper left corner, in a frame, where the energy is right to rounding and the answer wrong by a hundredth to a multiple of itself; some in the middle; and a few along the diagonal where both errors are alike.
height = 9
load 'plots/style.gp'
file = 'build/data/12-failures.dat'
set logscale xy
numbers = face.(lecture ? ',18' : ',8')
set ylabel 'error of the answer' offset 1
set xlabel 'relative error of the energy'
set key at graph 0.985,0.05 right bottom samplen 1
eval edges(0.11, 0.985, lecture ? 0.15 : 0.125, 0.975)
set xrange [1e-20:1e10]
set yrange [1e-11:300]
set xtics ('none' 2e-19, '0' 1e-17, '10^{-14}' 1e-14, '10^{-10}' 1e-10, '10^{-6}' 1e-6, '10^{-2}' 1e-2, '10^2' 1e2, '10^6' 1e6)
set ytics ('10^{-10}' 1e-10, '10^{-8}' 1e-8, '10^{-6}' 1e-6, '10^{-4}' 1e-4, '10^{-2}' 1e-2, '1' 1, 'none' 30)
set object 1 rectangle from 2e-20,0.012 to 2e-13,150 fillstyle empty border lc rgb '#555555' dt 2
set label 1 'both alike' at 6e-9,4e-10 left rotate by 54 tc rgb '#555555'
plot x with lines ls 9 dt 2, \
     for [k = 1:4] file index k-1 using 2:3 with points ls k ps 0.65*big \
         title 'part '.word('I II III IV', k), \
     file using ($6 == 0 ? $4 : NaN):5:1 with labels font numbers
