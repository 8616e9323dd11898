# A run of disks as a film: where they are, with the way of the last moments.
# Reads a table of states from disks; call it from the kit's own folder:
#   gnuplot -e "file='run.dat'" plots/disks-movie.gp                in a window
#   gnuplot -e "file='run.dat'; output='run.gif'" plots/disks-movie.gp
# To be set in the same way, with semicolons between:
#   fps     frames a second (25); every block of rows is a frame
#   name    stands before the time
#   window  which of gnuplot's terminals to show it in (the first there is)
if (!exists("file")) file = 'build/movies/disks.dat'
if (!exists("fps")) fps = 25
if (!exists("name")) name = ''
live = !exists("output")
fps = real(fps)
if (!(fps >= 1 && fps <= 50)) {
    print sprintf('disks-movie.gp: fps: %g is not a number from 1 to 50', fps)
    exit status 2
}

# A window wants a terminal that can open one and, but for macOS and Windows,
# a display to open it on.
if (live && !exists("window")) {
    window = ''
    do for [t in 'windows aqua qt wxt x11'] {
        if (window eq '' && strstrt(' '.GPVAL_TERMINALS.' ', ' '.t.' ')) {
            window = t
        }
    }
    if (window eq '') {
        print 'disks-movie.gp: this gnuplot opens no window; install one', \
            'that does: apt-get install --no-install-recommends gnuplot-qt'
        exit status 1
    }
    if (strstrt('qt wxt x11', window) && GPVAL_SYSNAME ne 'Darwin' \
        && system('echo "$DISPLAY$WAYLAND_DISPLAY"') eq '') {
        print 'disks-movie.gp: there is no display to open a window on:', \
            'DISPLAY is not set'
        exit status 1
    }
}

# The table stays in memory; its head has the box.
if (system(sprintf("test -r '%s' && echo yes", file)) ne 'yes') {
    print sprintf("disks-movie.gp: '%s' cannot be read", file)
    exit status 2
}
box = system(sprintf("sed -n 's/^# box //p' '%s'", file))
columns = system(sprintf("grep -v '^#' '%s' | sed -n '1s/[^ ]* */x/gp'", file))
if (words(box) != 3 || strlen(columns) != 11) {
    print sprintf("disks-movie.gp: '%s' is no table of states in the plane", \
        file)
    exit status 2
}
lx = real(word(box, 1))
ly = real(word(box, 2))
walls = word(box, 3) eq 'walls'
load sprintf("< echo '$run << end'; grep -v '^#' '%s'; echo end", file)
stats $run using 2 nooutput
frames = STATS_blocks
disks = STATS_max
stats $run using 1 nooutput
step = frames > 1 ? STATS_max / (frames - 1) : 0
stats $run using 3 nooutput
heavy = STATS_max
light = STATS_min

# The style, and where to draw: 480 dots high, at most 960 wide.
medium = 'movie'
if (live) output = '/dev/null'
load 'plots/style.gp'
set output
wide = int(480 * lx / ly)
wide = wide > 960 ? 960 : wide < 240 ? 240 : wide
if (live) {
    eval 'set terminal '.window.(strstrt('qt wxt', window) ? \
        sprintf(' noraise size %d,520 font "Latin Modern Sans,13"', wide) : \
        window eq 'x11' ? sprintf(' noraise persist size %d,520', wide) : \
        ' enhanced')
    if (window eq 'x11') { unset minussign }  # its fonts may lack it
} else {
    set terminal gif animate optimize delay int(100 / fps + 0.5) loop 0 \
        enhanced font 'Latin Modern Sans,13' size wide,520
    set output output
}

# A few disks have a colour each; of many, the first one, and heavy ones.
full(i, m) = disks <= 8 ? (int(i) % 4 == 1 ? 0x0072b2 : int(i) % 4 == 2 ? \
    0xd55e00 : int(i) % 4 == 3 ? 0x009e73 : 0xe69f00) : \
    i == 1 || (heavy > light && m == heavy) ? 0xd55e00 : 0x99c7e0
colours = '#0072b2 #d55e00 #009e73 #e69f00 #99c7e0 #bbbbbb #333333 #fefefe #ffffff'
tail = disks <= 8 ? 12 : 60
unset tics
unset border
unset key
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0.02
set tmargin at screen 0.93
set size ratio -1
set xrange [0:lx]
set yrange [0:ly]
set object 1 rectangle from 0,0 to lx,ly fs empty border \
    lc rgb walls ? '#333333' : '#bbbbbb' lw walls ? 2 : 1
# The pictures of a GIF hold only what is new, in the colours of the first one,
# so that shows them all, under white.
do for [i=1:live ? 0 : words(colours)] {
    set object 10 + i rectangle from screen 0,0 to screen 0.01,0.01 behind \
        fs solid noborder fc rgb word(colours, i)
}
label = (name eq '' ? '' : name.':  ').sprintf('{/:Italic t} = %%.%df s', \
    step < 0.01 ? 3 : step < 0.1 ? 2 : 1)
traced(i) = disks <= 8 || i == 1
start = time(0.0)
f = 0
while (f < frames) {
    # A pixel of another white makes every two pictures differ: the writer of
    # GIFs stumbles over nothing new.
    if (!live) {
        set object 10 rectangle from screen 0,0.99 to screen 0.004,1 \
            fs solid noborder fc rgb (f % 2 ? '#fefefe' : '#ffffff')
    }
    set label 1 sprintf(label, f * step) at screen 0.03,0.965 left
    first = f > tail ? f - tail : 0
    plot $run index f using 5:6:4:(full($2, $3)) with circles \
            lc rgb variable fs solid noborder, \
        $run index first:f using (traced($2) ? $5 : NaN):6 with points pt 7 ps 0.2 lc rgb '#333333'
    f = f + 1
    if (live && f < frames) {
        # The clock keeps the rate: picture f is due f/fps after the start.
        due = int((time(0.0) - start) * fps)
        f = due > f ? (due < frames ? due : frames - 1) : f
        wait = start + f / fps - time(0.0)
        if (wait > 0) { pause wait }
    }
}
set output
# A window stays until it is closed.
if (live && strstrt('windows qt wxt x11', window)) { pause mouse close }
