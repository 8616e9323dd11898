# data: plots/data/07-eos.dat
# alt: Left, the compressibility factor against packing, for disks from 1.2 to 6.5 and for spheres from 1.5 to 12; points on lines. Right, deviations in per cent: the points scatter about zero within two tenths of a per cent; uncorrected crosses lie below; the grey lines of Henderson and of Carnahan and Starling leave them.
height = 7.2
load 'plots/style.gp'
file = 'plots/data/07-eos.dat'
henderson(x) = (1+x**2/8)/(1-x)**2
liu(x) = (1+x**2/8+x**3/18-4*x**4/21)/(1-x)**2
starling(x) = (1+x+x**2-x**3)/(1-x)**3
k(y) = 1+4*y+6*y**2+2.3647684*y**3-0.8698551*y**4+1.1062803*y**5-1.1014221*y**6+0.66605866*y**7-0.03633431*y**8-0.20965164*y**10+0.10555569*y**14-0.0087238*y**22
kolafa(x) = k(x/(1-x))
set multiplot layout 1,2 margins 0.075,0.985,0.17,0.97 spacing 0.12,0
set xlabel 'packing {/Symbol h}'
set ylabel '{/:Italic Z} = {/:Italic PV/NkT}' offset 1
set xrange [0:0.65]
set yrange [1:13]
set xtics 0.2
set key at graph 0.03,0.97 left top Left reverse samplen 1.5
plot [0:0.65] henderson(x) ls 9 lw 1.5*thick, (x < 0.5 ? starling(x) : NaN) ls 9 lw 1.5*thick dt 2, \
     file using ($2 == 2 ? $4 : NaN):5 with points ls 1 title 'disks', \
     file using ($2 == 3 ? $4 : NaN):5 with points ls 2 title 'spheres'
set ylabel 'deviation (per cent)' offset 1.5
set yrange [-0.5:0.8]
set ytics 0.2
set label 1 'Henderson' at 0.47,0.62 right tc rgb '#555555'
set label 2 'Carnahan, Starling' at 0.63,-0.36 right tc rgb '#555555'
plot 0 ls 9 lw 0.8*thick, \
     [0:0.62] 100*(henderson(x)/liu(x)-1) ls 9 lw 1.5*thick, \
     [0:0.5] 100*(starling(x)/kolafa(x)-1) ls 9 lw 1.5*thick dt 2, \
     file using ($2 == 2 ? $4 : NaN):11 with points pt 2 ps 0.5*big lc rgb blue, \
     file using ($2 == 3 ? $4 : NaN):11 with points pt 2 ps 0.5*big lc rgb red, \
     file using ($2 == 2 ? $4 : NaN):10:7 with yerrorbars ls 1, \
     file using ($2 == 3 ? $4 : NaN):10:7 with yerrorbars ls 2
