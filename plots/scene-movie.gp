# A run of a scene as a film: its bodies, their springs, where they have been.
# Reads a table of states that step or bonk has written, and the scene; or a
# table of states from disks. Call it from the kit's own folder:
#   gnuplot -e "file='run.dat'; scene='run.plist'" plots/scene-movie.gp
# To be set in the same way, with semicolons between, besides what film.gp
# knows:
#   view    xy, xz or tilted (what the motion wants)
#   name    stands above; length and time, the units, beside the numbers
# What is on a line leaves its way below, the earlier the deeper.
script = 'scene-movie.gp'
if (!exists("file")) file = 'build/movies/run.dat'
if (!exists("scene")) scene = file
if (!exists("view")) view = ''
if (!exists("length")) length = ''
if (!exists("unit")) unit = ''
awk = sprintf("awk -f plots/scene-movie.awk -v view='%s'", view)
length = length eq '' || length eq '-' ? '' : ' '.length
unit = unit eq '' ? '' : ' '.unit
told = system(sprintf("%s -v ask=1 '%s' '%s' 2>/dev/null", awk, scene, file))
frames = word(told, 1) eq 'rows' ? int(word(told, 2)) : 0
load 'plots/film.gp'
if (frames == 0) {
    print sprintf("%s: '%s' and '%s': %s", script, file, scene, told)
    exit status 2
}
step = real(word(told, 3))
line = int(word(told, 4))
view = word(told, 5)
tall = real(word(told, 6))
array E[4]
do for [k=1:4] { E[k] = real(word(told, 6 + k)) }

# What is to be seen fills a field of W by H dots, of 960 by 540, as well as
# one length on both axes allows; what is on a line stands at its top, and
# leaves room for a clock at its right.
W = 920.0
H = 440.0
clock = line ? 120 : 0
across = (E[2] - E[1]) / (W - clock)
scale = line || (E[4] - E[3]) / H < across ? across : (E[4] - E[3]) / H
scale = 1.06 * (scale > 0 ? scale : 1)
left = (E[1] + E[2] - (W - clock) * scale) / 2
right = left + W * scale
thick = E[4] - E[3] > 16 * scale ? E[4] - E[3] : 16 * scale
bottom = line ? thick - H * scale : (E[3] + E[4] - H * scale) / 2
top = bottom + H * scale
fall = H * scale - 1.5 * thick
eval edges(20.0 / 960, 940.0 / 960, 56.0 / 540, 496.0 / 540)
set xrange [left:right]
set yrange [bottom:top]
set size ratio -1
unset tics
unset border
unset key

# Hard walls.
walls = system(sprintf("sed -n 's/^walls //p; s/^# box .* walls$/hard hard/p' '%s'", scene)).' - - -'
xhard = view ne 'tilted' && word(walls, 1) eq 'hard'
yhard = view ne 'tilted' && word(walls, view eq 'xz' ? 3 : 2) eq 'hard'
do for [k=1:xhard ? 2 : 0] {
    set arrow k from E[k],(yhard ? E[3] : bottom) to E[k],(yhard ? E[4] : top) \
        nohead back lc rgb '#333333' lw 1.5
}
do for [k=3:yhard ? 4 : 2] {
    set arrow k from E[1],E[k] to E[2],E[k] nohead back lc rgb '#333333' lw 1.5
}

# How long a length is and, beside ways that lead down, how long ago.
handy(x) = 10**floor(log10(x)) * (x < 2 * 10**floor(log10(x)) ? 1 : \
    x < 5 * 10**floor(log10(x)) ? 2 : 5)
past = line ? handy(0.4 * 6 * fps * step) : 0
bar = handy(W * scale / 6)
set arrow 5 from left,screen 0.055 to left + bar,screen 0.055 heads \
    size screen 0.004,90 lc rgb '#333333' lw 1.2
set label 4 sprintf('%g%s', bar, length) at left + bar,screen 0.055 \
    offset 1,0 noenhanced
if (line) {
    set arrow 6 from right,top - thick / 2 - fall * past / (6 * fps * step) \
        to right,top - thick / 2 heads size screen 0.004,90 lc rgb '#333333' lw 1.2
    set label 5 sprintf('%g%s ago', past, unit) noenhanced right \
        at right,top - thick / 2 - fall * past / (6 * fps * step) offset -1,0
}
set label 2 (tall > 1 ? sprintf('heights %g times,  ', tall) : ''). \
    sprintf(fps * step < 100 ? '%.3g%s in a second' : '%.0f%s in a second', \
    fps * step, unit) noenhanced
digits = step < 1 ? int(ceil(-log10(step) - 1e-9)) : 0
now = sprintf('{/:Italic t} = %%.%df%s', digits, unit)

# Springs, ways, bodies: small ones as they are, larger ones with a rim.
rim = 4 * scale
picture = 'if (!late(f)) {'.before.';set label 1 sprintf(now, t);'. \
    'plot $ways using 1:2:3 with lines lc rgb variable lw 1.5, '. \
    '$springs using 1:2:3 with lines lc rgb variable lw 1.2, '. \
    '$bodies using ($3 < rim ? $1 : NaN):2:3:4 with circles '. \
    'lc rgb variable fs solid noborder, '. \
    '$bodies using ($3 < rim ? NaN : $1):2:3:4 with circles '. \
    'lc rgb variable lw 0.7 fs solid border lc rgb "#444444", '. \
    '$lone using 1:2 with lines lc rgb "#333333" lw 1;'.after.'}'
start = time(0.0)
load sprintf("< %s -v ask=0 -v view=%s -v tall=%g -v line=%d -v fps=%g -v left=%.9g -v right=%.9g -v bottom=%.9g -v top=%.9g -v fall=%.9g '%s' '%s'", \
    'awk -f plots/scene-movie.awk', view, tall, line, fps, left, right, bottom, top, fall, scene, file)
# A window stays until it is closed.
if (live && strstrt('windows qt wxt x11', window)) { pause mouse close }
