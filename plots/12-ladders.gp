# data: build/data/12-ladders.dat
# command: build/bin/scene solar-system | build/bin/bonk - --until 3650 --tolerance 1e-6 --chart build/data/12-ladders.dat -o /dev/null
# alt: Error against cost of all runs that were made to choose for the solar system over ten years, both logarithmic, with the tolerance of a millionth as a line across. Eight ellipses stand far to the left and above the line; the coarser run of the reference stands far to the right and far below. Leapfrog, Yoshida's sixth order and the method of Kahan and Li have one point each, PEFRL has three, all above the line. The points of Wisdom and Holman and of SBAB4 lie about the line; the cheapest of those below it is one of the former, marked with a star: it is taken.
height = 8
load 'plots/style.gp'
load 'plots/methods.gp'
eval powers
set xlabel 'cost  (s by the price list)'
set ylabel 'error  (fraction of the scale)' offset 1
set xrange [2e-5:0.02]
set yrange [1e-12:30]
eval edges(0.115, 0.965, 0.145, 0.97)
set key at graph 0.985,0.97 right Right spacing 1.1 samplen 2
file = 'build/data/12-ladders.dat'
tried(name) = sprintf("< awk '!/^#/ && $4 ~ /^%s:/ && $3 == 0' %s | sort -g -k2", name, file)
set label 1 'tolerance' at 2.6e-5,3.5e-6 tc rgb '#555555'
set label 2 'kepler, no-light' at 5.2e-5,5e-4
plot 1e-6 ls 9, \
     for [m in 'leapfrog yoshida6 pefrl kahan-li8 wisdom-holman sbab4 radau15'] tried(m) using 2:1 \
     with linespoints ls style_of(m) title name_of(m), \
     "< awk '!/^#/ && $4 ~ /^kepler/' ".file using 2:1 with points pt 7 ps 0.7*big lc rgb dark, \
     "< awk '!/^#/ && $3 == 1' ".file using 2:1 with points pt 3 ps 1.6*big lw 2*thick lc rgb dark
