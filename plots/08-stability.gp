# data: build/data/08-stability.dat
# command: build/bin/step-studies --study stability -o build/data/08-stability.dat
# alt: Eight panels: for each method the part of the complex plane of lambda dt in which the damped oscillator does not grow. Euler, the unit disk around minus one; RK4, the known bean up to 2.83 on the imaginary axis and 2.79 on the negative real one; symplectic Euler, a strip of width one, up to 2 on the imaginary axis; leapfrog, a narrow triangle up to 2 and half as wide; Yoshida 4, a block of width 1.1 up to 1.6; PEFRL and Kahan-Li 8, strips up to 3 and beyond, of widths 1 and 2.4; implicit midpoint, the whole left half-plane.
width = 14
height = 8.5
load 'plots/style.gp'
file = 'build/data/08-stability.dat'
array part[8] = ['Euler', 'RK4', 'symplectic Euler', 'leapfrog', 'Yoshida 4', 'PEFRL', 'Kahan–Li 8', 'midpoint']
array which[8] = [0, 3, 1, 2, 4, 6, 7, 8]
set multiplot layout 2,4 margins 0.075*room,0.985,0.13*room,0.97 spacing 0.02*room,0.05*room
set xrange [-4:0.5]
set yrange [0:3.5]
set xtics 1
set ytics 1
unset colorbox
set palette defined (0 '#8fbfdd', 1 '#8fbfdd', 1.0000001 '#ffffff', 2 '#ffffff')
set cbrange [0:2]
do for [k=0:7] {
  set format x (k > 3 ? '%g' : '')
  set format y (k % 4 == 0 ? '%g' : '')
  set xlabel k > 3 ? 'Re {/Symbol l}{/:Italic dt}' : ''
  set ylabel k % 4 == 0 ? 'Im {/Symbol l}{/:Italic dt}' : '' offset 1
  set label 1 part[k+1] at graph 0.04,0.92 front
  plot file index which[k+1] using 1:2:($3 < 1+1e-6 ? 1 : 2) with image
}
unset multiplot
