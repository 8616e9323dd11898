# A run as a film: first its energy, then the bodies, above on their wire and
# below each at its velocity. Reads the table that bonkers writes; call it
# from the kit's own folder:
#   gnuplot -e "file='run.dat'" plots/movie.gp
# To be set in the same way, with semicolons between, besides what film.gp
# knows:
#   speed   seconds of the run in a second of the film (every row a frame)
#   radii   of the movers, as '0.1' or '0.1,0.2,..', if the run has them;
#           points are drawn with sizes of their own, apart by these sizes
#   intro   seconds for the energy (1.6)
script = 'movie.gp'
if (!exists("file")) file = 'build/movies/mixed.dat'
if (!exists("intro")) intro = 1.6
if (!exists("radii")) radii = ''
load 'plots/film.gp'

# The rows stay in memory, as lines; of the header we need the masses.
masses = system(sprintf("sed -n 's/^# masses: //p' '%s'", file))
n = words(masses)
load sprintf("< echo '$run << end'; grep -v '^#' '%s'; echo end", file)
rows = |$run|
if (n == 0 || rows < 2 || words($run[1]) != 2 * n + 6) {
    print sprintf("movie.gp: '%s' is no table of the motion in one run", file)
    exit status 2
}
m(i) = real(word(masses, i))
t(k) = real(word($run[k], 1))
x(k, i) = real(word($run[k], 2 * i + 3))  # body 0 is the left wall
v(k, i) = real(word($run[k], 2 * i + 4))
tc = t(2) - t(1)
if (!exists("speed")) speed = fps * tc
if (!(speed > 0)) {
    print sprintf('movie.gp: speed: %g is not above 0', speed)
    exit status 2
}

# How far, how fast, how much energy. A run without a right wall ends where
# its last body came to.
ends = word($run[1], 2 * n + 5) ne 'inf'
left = x(1, 0)
stats $run using (column(2 * n + (ends ? 5 : 3))) nooutput
box = STATS_max - left
vmax = 0
heavy = m(1)
light = m(1)
do for [i=1:n] {
    stats $run using (abs(column(2 * i + 4))) nooutput
    vmax = STATS_max > vmax ? STATS_max : vmax
    heavy = m(i) > heavy ? m(i) : heavy
    light = m(i) < light ? m(i) : light
}
vmax = vmax > 0 ? vmax : 1
stats $run using 2 nooutput
emax = STATS_max > 0 ? STATS_max : 1
change = (STATS_max - STATS_min) / emax

# The radius R goes with the square root of the mass; all bodies together get
# as much room as the box is long. Each is drawn further right by S, as hard
# rods would lie, so that two touch on the screen when they meet in the run.
array R[n]
array S[n]
array C[n]
array X[n]
array V[n]
given = words(system(sprintf("echo '%s' | tr , ' '", radii)))
size = 0.5 * box / (sum [i=1:n] sqrt(m(i)))
size = size * sqrt(heavy) > 0.08 * box ? 0.08 * box / sqrt(heavy) : size
edge = 0.0
do for [i=1:n] {
    R[i] = size * sqrt(m(i))
    S[i] = edge + R[i]
    edge = edge + 2 * R[i]
    C[i] = m(i) >= sqrt(heavy * light) ? 0 : 1
}
do for [i=1:given > 0 ? n : 0] {
    R[i] = real(word(system(sprintf("echo '%s' | tr , ' '", radii)), \
        given > 1 ? i : 1))
    S[i] = 0.0
    edge = 0.0
}

# What a body draws behind it is paler than itself.
full(c) = c > 0 ? 0xd55e00 : 0x0072b2
pale(c) = c > 0 ? 0xeebf99 : 0x99c7e0
dot(r) = 0.3 * r + 3 * pixel  # of a body drawn at its velocity

# One plot holds both panels, so that a window never shows half a frame: the
# lower one from -vtop to vtop, the wire at height wire.
vtop = 1.12 * vmax
top = vtop * 2.0
wire = 0.5 * (vtop + top)
wall = 0.012 * (box + edge)
right = left + box + edge
pixel = (box + edge + 2 * wall) / 854
decade = 10**floor(log10(vtop))
step = decade * (vtop / decade > 5 ? 2 : vtop / decade > 2 ? 1 : 0.5)
eval edges(0.095, 0.985, 0.14, 0.9)
set tics nomirror
set border 3
unset key
label = sprintf('{/:Italic t} = %%.%df s', tc < 0.01 ? 3 : tc < 0.1 ? 2 : 1)
place = given ? '{/:Italic x}' : '{/:Italic x_i} + {/:Italic s_i}'
lost = change > 0 ? gprintf('%.0t·10^{%T}', change) : '0'
tail = n > 50 ? 0 : 10
first = ceil(intro * fps)
frames = first + 1 + floor((rows - 1) * fps * tc / speed + 1e-6)
start = time(0.0)
do for [f=0:frames - 1] {
    if (late(f)) {
        continue
    }
    @before
    if (f < first) {
        # The energy, a line that grows.
        k = 2 + int((rows - 2) * (f + 1.0) / first)
        set xrange [t(1):t(rows)]
        set yrange [0:1.2 * emax]
        set xtics auto
        set ytics auto
        set xlabel 'time {/:Italic t} (s)'
        set ylabel 'energy {/:Italic E} (J)' offset 0.5
        set label 1 sprintf(label, t(k))
        set label 2 'relative change: '.lost
        plot $run every ::0::(k - 1) using 1:2 with lines lc rgb blue lw 3
    } else {
        # The bodies and, below, each at its velocity, with its way through
        # the rows before. If it collided once between two rows, we know
        # where; if more often, somewhere on that way must do.
        k = 1 + int((f - first) * speed / (fps * tc) + 0.5)
        k = k > rows ? rows : k
        set print $trail
        do for [i=1:n] {
            X[i] = x(k, i) + S[i]
            V[i] = v(k, i)
            do for [j=(k > tail ? k - tail : 1):k - 1] {
                xa = x(j, i) + S[i]
                va = v(j, i)
                vb = v(j + 1, i)
                print xa, va, C[i]
                if (va != vb) {
                    d = t(j + 1) - t(j)
                    at = (x(j + 1, i) + S[i] - xa - vb * d) / (va - vb)
                    at = at < 0 ? 0 : at > d ? d : at
                    print xa + va * at, va, C[i]
                    print xa + va * at, vb, C[i]
                }
            }
            print X[i], V[i], C[i]
            print ''
        }
        set print
        set xrange [left - wall:right + wall]
        set yrange [-vtop:top]
        set xtics auto
        set ytics -10 * step,step,vtop
        set xlabel 'position '.place.' (m)'
        unset ylabel
        set label 1 sprintf(label, t(k))
        set label 2 sprintf('%.3g s in a second', speed)
        set label 4 'velocity {/:Italic v} (m/s)' at screen 0.026,first 0 \
            center rotate by 90
        set object 1 rectangle from left - wall,-vtop to left,top behind \
            fs solid noborder fc rgb '#bbbbbb'
        if (ends) { set object 2 rectangle from right,-vtop to right + wall,top \
            behind fs solid noborder fc rgb '#bbbbbb' }
        set arrow 1 from left,wire to right,wire nohead back lc rgb '#bbbbbb' lw 2
        set arrow 2 from left,vtop to right,vtop nohead back lc rgb '#333333' lw 0.8
        set arrow 3 from left,0 to right,0 nohead back ls 9
        plot $trail using 1:2:(pale($3)) with lines lc rgb variable lw 2, \
            X using (X[$1]):(wire):(R[$1]):(full(C[$1])) \
                with circles lc rgb variable fs solid noborder, \
            X using (X[$1]):(V[$1]):(dot(R[$1])):(full(C[$1])) \
                with circles lc rgb variable fs solid noborder
    }
    @after
}
# A window stays until it is closed.
if (live && strstrt('windows qt wxt x11', window)) { pause mouse close }
