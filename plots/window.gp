# Sets `window` to a terminal of gnuplot's that opens one, or says what is
# missing; script names who asks. A window wants a terminal that can open one
# and, but for macOS and Windows, a display to open it on. Its size is wide x
# high.
if (!exists("window")) {
    window = ''
    do for [t in 'windows aqua qt wxt x11'] {
        if (window eq '' && strstrt(' '.GPVAL_TERMINALS.' ', ' '.t.' ')) {
            window = t
        }
    }
    if (window eq '') {
        print script.': this gnuplot opens no window; install one that does:', \
            ' apt-get install --no-install-recommends gnuplot-qt'
        exit status 1
    }
    if (strstrt('qt wxt x11', window) && GPVAL_SYSNAME ne 'Darwin' \
        && system('echo "$DISPLAY$WAYLAND_DISPLAY"') eq '') {
        print script.': there is no display to open a window on:', \
            ' DISPLAY is not set'
        exit status 1
    }
}
set output
eval 'set terminal '.window.(strstrt('qt wxt', window) ? \
    sprintf(' noraise size %d,%d font "Latin Modern Sans,15"', wide, high) : \
    window eq 'x11' ? sprintf(' noraise persist size %d,%d', wide, high) : \
    ' enhanced')
if (window eq 'x11') { unset minussign }  # its fonts may lack it
