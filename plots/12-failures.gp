# data: build/data/12-failures.dat
# command: awk -v want=figure -f tests/stability/failures.awk tests/stability/failures.txt > build/data/12-failures.dat
# slides: 2
# alt: Two pictures of the failures of this book, each a numbered point, the relative error of the energy to the right and that of the answer upwards, both logarithmic. Above, all of them: a crowd in the upper left corner, in a frame, where the energy is right to rounding and the answer wrong by a hundredth to a multiple of itself; some in the middle; and a few along the diagonal where both errors are alike. Below, the frame enlarged: more than twenty numbered points spread from one hundredth to four, with those that have no energy to look at in a strip on the left, and those that give no answer at all in a row at the top.
width = 14
height = 17
load 'plots/style.gp'
file = 'build/data/12-failures.dat'
set logscale xy
set multiplot
numbers = face.(lecture ? ',18' : ',8')
set ylabel 'error of the answer' offset 1
set xlabel 'relative error of the energy'
set key at graph 0.985,0.05 right bottom samplen 1

set lmargin at screen 0.11
set rmargin at screen 0.985
set bmargin at screen slide ? 0.15 : 0.565
set tmargin at screen 0.985
set xrange [1e-20:1e10]
set yrange [1e-11:300]
set xtics ('none' 2e-19, '0' 1e-17, '10^{-14}' 1e-14, '10^{-10}' 1e-10, '10^{-6}' 1e-6, '10^{-2}' 1e-2, '10^2' 1e2, '10^6' 1e6)
set ytics ('10^{-10}' 1e-10, '10^{-8}' 1e-8, '10^{-6}' 1e-6, '10^{-4}' 1e-4, '10^{-2}' 1e-2, '1' 1, 'none' 30)
set object 1 rectangle from 2e-20,0.012 to 2e-13,150 fillstyle empty border lc rgb '#555555' dt 2
set label 1 'both alike' at 3e-9,1e-9 left rotate by 50 tc rgb '#555555'
if (row(1)) plot x with lines ls 9 dt 2, \
     for [k = 1:4] file index k-1 using 2:3 with points ls k ps 0.65*big \
         title 'part '.word('I II III IV', k), \
     file using ($6 == 0 ? $4 : NaN):5:1 with labels font numbers

unset object 1
unset label 1
set lmargin at screen 0.11
set rmargin at screen 0.985
set bmargin at screen slide ? 0.15 : 0.07
set tmargin at screen slide ? 0.985 : 0.485
set xrange [5e-20:3e-13]
set yrange [0.012:80]
set xtics ('none' 2e-19, '0' 1e-17, '10^{-16}' 1e-16, '10^{-15}' 1e-15, '10^{-14}' 1e-14, '10^{-13}' 1e-13)
set ytics ('0.02' 0.02, '0.05' 0.05, '0.1' 0.1, '0.2' 0.2, '0.5' 0.5, '1' 1, '2' 2, '5' 5, 'none' 30)
set arrow 1 from 1.4e-18,0.012 to 1.4e-18,80 nohead ls 9
set arrow 2 from 1.4e-18,12 to 3e-13,12 nohead ls 9
set arrow 3 from 5e-20,12 to 1.4e-18,12 nohead ls 9
set arrow 4 from 8e-18,2 to 4e-18,2 head filled size screen 0.012,20 lc rgb '#555555'
unset key
if (row(2)) plot for [k = 1:4] file index k-1 using ($6 == 1 ? $2 : NaN):3 with points ls k ps 0.65*big, \
     file using ($6 == 1 ? $4 : NaN):5:1 with labels font numbers
unset multiplot
