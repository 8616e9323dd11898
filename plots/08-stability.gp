# data: build/data/08-stability.dat
# command: build/bin/step-studies --study stability -o build/data/08-stability.dat
# alt: A panel for each method: the part of the complex plane of lambda dt in which the damped oscillator does not grow. Euler, the unit disk around minus one; RK4, the known bean up to 2.83 on the imaginary axis and 2.79 on the negative real one; symplectic Euler, a strip of width one, up to 2 on the imaginary axis; leapfrog, a narrow triangle up to 2 and half as wide; Yoshida 4, a block of width 1.1 up to 1.6; PEFRL, a strip of width 1 up to 3 and beyond; Yoshida 6, a strip of width 1.5 up to 2.4 with a ragged edge, and an island above it; Kahan-Li 8, a strip of width 2.4 up to the upper edge; implicit midpoint and Gauss 4, the whole left half-plane.
height = 8.5
load 'plots/style.gp'
load 'plots/methods.gp'
file = 'build/data/08-stability.dat'
names = methods(file, 'euler rk4 symplectic-euler leapfrog yoshida4 pefrl yoshida6 kahan-li8 implicit-midpoint gauss4')
panels = words(names)
set multiplot layout ceil(panels/5.),5 margins 0.075,0.985,0.15,0.93 spacing 0.02,0.085
set xrange [-4:0.5]
set yrange [0:3.5]
set xtics -4,2,0
set ytics 1
unset colorbox
set palette defined (0 '#8fbfdd', 1 '#8fbfdd', 1.0000001 '#ffffff', 2 '#ffffff')
set cbrange [0:2]
do for [k=0:panels-1] {
  m = word(names, k+1)
  set format x (k > panels-6 ? '%g' : '')
  set format y (k % 5 == 0 ? '%g' : '')
  set xlabel (k > panels-6 ? 'Re {/Symbol l}{/:Italic dt}' : '')
  set ylabel k % 5 == 0 ? 'Im {/Symbol l}{/:Italic dt}' : '' offset 1
  set title name_of(m) offset 0,-0.7
  plot file index at(file, m) using 1:2:($3 < 1+1e-6 ? 1 : 2) with image
}
