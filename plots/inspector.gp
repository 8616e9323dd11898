# The particle inspector: one observable of a scene against another, from a
# table that `step --observe X,Y` has written. make inspect runs both.
# By hand: gnuplot -e "file='run.dat'" plots/inspector.gp opens a window;
# with output='picture.svg' besides it draws a file.
if (!exists("file")) file = 'build/inspect/sun-earth.dat'
told = system(sprintf("[ -r '%s' ] && grep -c '^# [0-9]* .* \\[' '%s'", \
    file, file))
columns = told eq '' ? 0 : int(told)
if (columns < 3) {
    system(sprintf("echo \"inspector.gp: '%s' is no table of step --observe X,Y\" >&2", file))
    exit status 2
}
rows = int(system(sprintf("grep -vc '^#' '%s'", file)))
if (rows < 2) {
    system(sprintf("echo \"inspector.gp: '%s' has %d rows, expected two at least\" >&2", file, rows))
    exit status 2
}
live = !exists("output")
medium = 'svg'
width = 14
height = 9
if (live) output = '/dev/null'
load 'plots/style.gp'
if (live) {
    set output
    set terminal qt size 900,580 font 'Latin Modern Sans,13' noenhanced
}
symbol(c) = system(sprintf("sed -n 's/^# %d \\([^ ]*\\) .*/\\1/p' '%s'", c, file))
unit(c) = system(sprintf("sed -n 's/^# %d [^ ]* \\[\\([^]]*\\)\\].*/\\1/p' '%s'", c, file))
label(c) = symbol(c).(unit(c) eq '1' ? '' : '  ('.unit(c).')')
set xlabel label(2) noenhanced
set ylabel (columns == 3 ? label(3) : unit(3)) noenhanced offset 1
set title system(sprintf("sed -n 's/^# command: //p' '%s' | cut -c 1-90", file)) \
    noenhanced font ',11'
set key outside top right horizontal
plot for [c=3:columns] file using 2:c with lines ls (c - 2) lw 1.2*thick \
    title columns > 3 ? symbol(c) : '' noenhanced
if (live) { pause mouse close }
