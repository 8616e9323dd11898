# data: build/data/09-ring-1.dat
# command: build/bin/gravity-studies --study ring --factor 1 -o build/data/09-ring-1.dat
# data: build/data/09-ring-500.dat
# command: build/bin/gravity-studies --study ring --factor 500 -o build/data/09-ring-500.dat
# data: build/data/09-ring-1000.dat
# command: build/bin/gravity-studies --study ring --factor 1000 -o build/data/09-ring-1000.dat
# alt: Three pictures of 3072 particles round a planet after two orbits. With masses of 1e-8 the ring is as it was, sharp at both edges. With 500 times that it is wide, its edges are torn, and there are grains of several particles. With 1000 times that it is a wide disk with clearly visible clumps and particles thrown out.
height = 5.8
load 'plots/style.gp'
eval drawing
set multiplot layout 1,3 margins 0.005,0.995,0.01,0.86 spacing 0.005,0
do for [f in '1 500 1000'] {
    file = 'build/data/09-ring-'.f.'.dat'
    set xrange [*:*]; set yrange [*:*]  # stats leaves out what is beyond
    stats file index 1 using 2 name 'V' nooutput
    stats file index 1 using (abs($1)) name 'E' nooutput
    set xrange [-3.4:3.4]; set yrange [-3.4:3.4]
    set title sprintf("× %s,  variance/mean %.1f\nenergy to %s", f, V_max, gprintf('%.0t·10^{%T}', E_max)) offset 0,-0.7
    plot file index 0 every ::1 using 1:2 with points pt 7 ps 0.1*big lc rgb '#333333', \
         file index 0 every ::0::0 using 1:2 with points pt 7 ps 1.6*big lc rgb orange
}
