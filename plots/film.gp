# What the films have in common: movie.gp and scene-movie.gp load it. Before
# it, script is their name and file a table; after it they set frames, how many
# pictures there are, and start, the time at which they begin.
#   output  the folder for the pictures, 00000.png and so on; without it they
#           are shown in a window
#   lines   how high a picture is, in dots (540); its width is 16/9 of that
#   fps     pictures a second (25)
#   window  which of gnuplot's terminals to show them in (the first there is)
# A script that is not late(f) draws picture f: @before, a plot, @after.
# In a window picture f is due at f/fps after the start.
if (!exists("fps")) fps = 25
if (!exists("lines")) lines = 540
if (!exists("name")) name = ''
fps = real(fps)
if (!(fps >= 1 && fps <= 50)) {
    print sprintf('%s: fps: %g is not a number from 1 to 50', script, fps)
    exit status 2
}
if (system(sprintf("test -r '%s' && echo yes", file)) ne 'yes') {
    print sprintf("%s: '%s' cannot be read", script, file)
    exit status 2
}
live = !exists("output")
wide = 960
high = 540
if (live) {
    load 'plots/window.gp'
    folder = ''
} else {
    folder = output
}
medium = 'movie'
output = '/dev/null'
load 'plots/style.gp'
set output
if (!live && !strstrt(' '.GPVAL_TERMINALS.' ', ' pngcairo ')) {
    print script.': this gnuplot draws no pngcairo; install one that does:', \
        ' apt-get install --no-install-recommends gnuplot-nox'
    exit status 1
}
if (!live) {
    set terminal pngcairo enhanced size lines * wide / high,lines \
        font 'Latin Modern Sans,15' fontscale lines / 540.0 \
        linewidth lines / 540.0 pointscale lines / 540.0
}

before = live ? '' : "set output sprintf('%s/%05d.png', folder, f)"
after = live ? 'if (early(f) > 0) { pause early(f) }' : 'set output'
early(f) = f == frames - 1 ? 0 : start + (f + 1) / fps - time(0.0)
# Late? Then the picture is left out, but never the last.
late(f) = live && early(f) < 0
set label 1 '' at screen 0.02,0.96 left
set label 2 '' at screen 0.98,0.96 right tc rgb '#555555'
set label 3 name at screen 0.5,0.96 center noenhanced tc rgb '#555555'
