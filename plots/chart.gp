# The chart of a choice: error against cost of everything that bonk has run
# on a scene, from a file that `bonk --chart FILE` has written. make chart
# runs both. By hand: gnuplot -e "file='chart.dat'" plots/chart.gp opens a
# window; with output='picture.svg' besides it draws a file.
script = 'chart.gp'
if (!exists("file")) file = 'build/chart/figure-eight.dat'
told = system(sprintf("[ -r '%s' ] && sed -n 's/^# tolerance: //p' '%s'", file, file))
if (told eq '') {
    system(sprintf("echo \"chart.gp: '%s' is no table of bonk --chart\" >&2", file))
    exit status 2
}
tolerance = real(told)
live = !exists("output")
medium = 'svg'
plans = system(sprintf("awk '!/^#/ && !NF { fresh = 1 } !/^#/ && NF && (fresh || !n++) { split($4, a, \":\"); cuts = $4; sub(/^[^,]*/, \"\", cuts); sub(/:.*/, \"\", a[1]); sub(/,.*/, \"\", a[1]); print ($3 == 1 ? \"taken:\" : \"\") a[1] cuts; fresh = 0 }' '%s'", file))
n = words(plans)
if (n == 0) {
    if (system(sprintf("sed -n 's/^# refused: /chart.gp: nothing to draw: /p' '%s' >&2; grep -c '^# refused: ' '%s'", file, file)) + 0 > 0) { exit status 1 }
    system(sprintf("echo \"chart.gp: '%s' has no run to be drawn\" >&2", file))
    exit status 2
}
taken = word(plans, n)[1:6] eq 'taken:'
# One column of names beside the plot, however many there are.
width = 17
height = n > 18 ? 3 + 0.33 * (n + 1) : 9
if (live) {
    wide = int(48 * width)
    high = int(48 * height)
    load 'plots/window.gp'
    medium = 'window'
    output = '/dev/null'
}
load 'plots/style.gp'
if (live) { set output }
stats file using 2 nooutput
if (STATS_min == STATS_max) set xrange [STATS_min/2:STATS_max*2]
eval powers
set xlabel 'cost  (s by the price list)'
set ylabel 'error  (share of the scale)' offset 1
set title system(sprintf("sed -n 's/^# command: //p' '%s' | cut -c 1-90", file)) noenhanced font ',11'
set key outside right top vertical samplen 1.5 font ',11' spacing 0.9 noenhanced
plot tolerance ls 9 dt '-' title 'tolerance', \
     for [k = 0:n-1] file index k using 2:1 with linespoints lc k+1 pt (k % 7)*2+4 ps 0.6*big lw 1.2*thick title k < n-taken ? word(plans, k+1) : '', \
     file index n-1 using 2:1 with points pt 3 ps taken*2*big lw 2.5*thick lc rgb dark title taken ? word(plans, n) : ''
if (live) { pause mouse close }
