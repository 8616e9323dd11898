# data: plots/data/11-pressure.dat
# data: build/runs/spheres-law.summary
# command: build/bin/spheres-studies --study law --until 1000 -o /dev/null --summary build/runs/spheres-law.summary
# alt: Two panels with logarithmic axes against the step from 0.0125 to 0.8 diameters. Left, the error of the energy stays near 1e-15 for all three ways at all steps. Right, the error of the pressure: for the two ways that push apart it rises in proportion to the step along the line of the law, from half a per cent to a quarter or a third; for going back it is within the noise below 0.05 and rises with slope 2 to a fifth.
height = 7.5
load 'plots/style.gp'
file = 'plots/data/11-pressure.dat'
stats file index 0 every ::0::0 using (0.5*($2 + $4)) name 'E' nooutput
stats file index 0 every ::0::0 using (0.5*sqrt($3**2 + $5**2)) name 'F' nooutput
set multiplot layout 1,2 margins 0.103,0.985,0.16,0.97 spacing 0.125,0
set logscale xy
set xlabel '{/:Italic v dt} / 2{/:Italic r}'
set xrange [0.01:1]
set format y '10^{%T}'
set ylabel '|Δ{/:Italic E}| / {/:Italic E}' offset 0.7
set yrange [1e-17:1]
set key at graph 0.97,0.95 right top samplen 1
plot file index 0 using ($1/0.2):14 with points ls 2 title 'all pairs', \
     file index 0 using ($1/0.2):27 with points ls 3 title 'approaching', \
     file index 0 using ($1/0.2):40 with points ls 1 title 'going back'
set ylabel '|Δ{/:Italic Z}| / {/:Italic Z}' offset 1
set yrange [3e-4:1]
set key at graph 0.03,0.95 left top samplen 1
dz(a,b) = abs(0.5*(a + b)/E_mean - 1)
er(a,b) = sqrt(0.25*(a**2 + b**2) + F_mean**2)/E_mean
low(d,e) = d > 1.2*e ? d - e : 3e-4
law = result('spheres-law', 'law')
plot law*x ls 9 title 'law', (x > 0.05 ? law*x*x : NaN) ls 9 dt 2, \
     file index 0 using ($1/0.2):(dz($2,$4)):(low(dz($2,$4),er($3,$5))):(dz($2,$4)+er($3,$5)) every ::1 with yerrorbars ls 2 title 'all pairs', \
     file index 0 using ($1/0.2*1.03):(dz($15,$17)):(low(dz($15,$17),er($16,$18))):(dz($15,$17)+er($16,$18)) every ::1 with yerrorbars ls 3 title 'approaching', \
     file index 0 using ($1/0.2):(dz($28,$30)):(low(dz($28,$30),er($29,$31))):(dz($28,$30)+er($29,$31)) every ::1 with yerrorbars ls 1 title 'going back'
