# data: build/data/08-stability.dat
# command: build/bin/step-studies --study stability -o build/data/08-stability.dat
# alt: Ten panels: for each method the part of the complex plane of lambda dt in which the damped oscillator does not grow. Euler, the unit disk around minus one; RK4, the known bean up to 2.83 on the imaginary axis and 2.79 on the negative real one; symplectic Euler, a strip of width one, up to 2 on the imaginary axis; leapfrog, a narrow triangle up to 2 and half as wide; Yoshida 4, a block of width 1.1 up to 1.6; PEFRL, a strip of width 1 up to 3 and beyond; Yoshida 6, a strip of width 1.5 up to 2.4 with a ragged edge, and an island above it; Kahan-Li 8, a strip of width 2.4 up to the upper edge; implicit midpoint and Gauss 4, the whole left half-plane.
width = 14
height = 8.5
load 'plots/style.gp'
file = 'build/data/08-stability.dat'
array part[10] = ['Euler', 'RK4', 'sympl. Euler', 'leapfrog', 'Yoshida 4', 'PEFRL', 'Yoshida 6', 'Kahan–Li 8', 'midpoint', 'Gauss 4']
array which[10] = [0, 3, 1, 2, 4, 6, 5, 7, 8, 9]
set multiplot layout 2,5 margins 0.075,0.985,0.15,0.93 spacing 0.02,0.085
set xrange [-4:0.5]
set yrange [0:3.5]
set xtics 1
set ytics 1
unset colorbox
set palette defined (0 '#8fbfdd', 1 '#8fbfdd', 1.0000001 '#ffffff', 2 '#ffffff')
set cbrange [0:2]
do for [k=0:9] {
  set format x (k > 4 ? '%g' : '')
  set format y (k % 5 == 0 ? '%g' : '')
  set xlabel k > 4 ? 'Re {/Symbol l}{/:Italic dt}' : ''
  set ylabel k % 5 == 0 ? 'Im {/Symbol l}{/:Italic dt}' : '' offset 1
  set title part[k+1] offset 0,-0.7
  plot file index which[k+1] using 1:2:($3 < 1+1e-6 ? 1 : 2) with image
}
unset multiplot
