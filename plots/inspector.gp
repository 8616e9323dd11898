# The particle inspector: one observable of a scene against another, from a
# table that `step --observe X,Y` has written. make inspect runs both.
# By hand: gnuplot -e "file='run.dat'" plots/inspector.gp opens a window;
# with output='picture.svg' besides it draws a file. pairs=2 takes the first
# two columns behind the time for X, and draws each against its own Y; length
# and unit are the scene's units of length and time. Axes that both are
# lengths have one scale.
script = 'inspector.gp'
if (!exists("file")) file = 'build/inspect/sun-earth.dat'
if (!exists("pairs")) pairs = 1
if (!exists("length")) length = ''
if (!exists("unit")) unit = ''
ask(c, k) = system(sprintf("awk -v metre='%s' -v second='%s' -v c=%d -v say=%d -f plots/inspector.awk '%s'", \
    length, unit, c, k, file))
told = system(sprintf("test -r '%s' && echo yes", file))
columns = told eq 'yes' ? int(ask(0, 0)) : 0
if (columns < 2 + pairs) {
    print sprintf("%s: '%s' is no table of step --observe X,Y", script, file)
    exit status 2
}
rows = int(system(sprintf("grep -vc '^#' '%s'", file)))
if (rows < 2) {
    print sprintf("%s: '%s' has %d rows, expected two at least", script, file, rows)
    exit status 2
}
live = !exists("output")
medium = 'svg'
width = 16
height = 9
wide = 960
high = 540
if (live) {
    load 'plots/window.gp'
    medium = 'window'
    output = '/dev/null'
}
load 'plots/style.gp'
if (live) { set output }

# What all columns from a to b have in common stands on the axis; what they
# have not, beside the line.
same(k, a, b) = a >= b ? ask(a, k) : ask(b, k) eq same(k, a, b - 1) ? ask(b, k) : ''
joined(c) = ask(c, 1).(ask(c, 2)[1:1] eq ' ' ? '' : ' of ').ask(c, 2)
axis(a, b) = (a == b ? joined(a) : same(1, a, b)).(same(3, a, b) eq '' ? '' : '  ('.same(3, a, b).')')
line(c) = same(1, y, columns) eq '' ? joined(c) : ask(c, 2)
y = 2 + pairs
# What hardly changes is drawn as a change, or its tics would all be one.
stats file using y nooutput
lengths = same(4, 2, columns) eq 'length'
constant = columns == y && !lengths && \
    STATS_max - STATS_min < 1e-3 * abs(STATS_max)
first = constant ? real(system(sprintf("sed '/^#/d;q' '%s' | cut -d ' ' -f %d", file, y))) : 0
set xlabel axis(2, 1 + pairs) noenhanced
set ylabel (constant ? 'change of ' : '').axis(y, columns) noenhanced offset (constant ? 0 : 1)
if (lengths) { set size ratio -1 }
set title system(sprintf("sed -n 's/^# command: //p' '%s' | cut -c 1-90", file)) \
    noenhanced font ',11'
set key outside right top vertical
x(c) = pairs == 1 ? 2 : c - pairs
plot for [c=y:columns] file using x(c):(column(c) - first) with lines ls ((c - y) % 5 + 1) lw 1.2*thick \
    dt 1 + (c - y) / 5 title columns > y ? line(c) : '' noenhanced, \
    for [c=y:columns] file every ::0::0 using (lengths ? column(x(c)) : NaN):c \
    with points ls ((c - y) % 5 + 1)
if (live) { pause mouse close }
