#!/bin/sh
# Movies: the GIF has the pictures it should have, from a clean build; what
# touches in the run touches on the screen; a window's rate is the clock's;
# what cannot be shown is refused in one line.
. tests/programs/common
make=${MAKE:-make}
kit=$work/kit
mkdir "$kit"
tar cf - Makefile src plots | (cd "$kit" && tar xf -)
cd "$kit" || exit 1
unset PRESET EVERY UNTIL FPS LIVE output

# What a GIF says of itself: width height pictures delay(1/100 s) loops.
gif() {
    od -An -v -tu1 "$1" | tr -s ' ' '\n' | sed '/^$/d' | awk '
        { b[NR - 1] = $1 }
        function table(flags) {
            return flags >= 128 ? 3 * 2 ^ (flags % 8 + 1) : 0
        }
        function skip(p) {
            while (b[p] > 0)
                p += b[p] + 1
            return p + 1
        }
        END {
            p = 13 + table(b[10])
            loops = "once"
            while (p < NR && b[p] != 59)
                if (b[p] == 44) {
                    ++pictures
                    p = skip(p + 11 + table(b[p + 9]))
                } else if (b[p] == 33) {
                    if (b[p + 1] == 249)
                        delay = b[p + 4] + 256 * b[p + 5]
                    if (b[p + 1] == 255)
                        loops = b[p + 16] + 256 * b[p + 17]
                    p = skip(p + 2)
                } else
                    break
            print b[6] + 256 * b[7], b[8] + 256 * b[9], pictures, delay, \
                loops, b[p] == 59 ? "whole" : "broken at " p " of " NR
        }'
}
# is NAME EXPECTED GOT
is() {
    if [ "$2" = "$3" ]; then ok "$1"; else
        not_ok "$1" "expected '$2', got '$3'"; fi
}
# one_line NAME STATUS PATTERN COMMAND...: ends so, and says one line.
one_line() {
    what=$1 want=$2 pattern=$3
    shift 3
    "$@" >"$work/said" 2>&1 </dev/null
    got=$?
    if [ "$got" -eq "$want" ] && [ "$(wc -l <"$work/said")" -eq 1 ] &&
        grep -Eq "$pattern" "$work/said"; then ok "$what"; else
        not_ok "$what" "status $got, said: $(head -c 300 "$work/said")"; fi
}

one_line 'a movie of nonsense is refused' 2 "PRESET: 'nonsense' is none of .*" \
    $make -s movie PRESET=nonsense
one_line 'and of two at once' 2 "PRESET: 'four two' is none of" \
    $make -s movie PRESET='four two'
is 'before anything is made' no "$([ -e build ] && ls -R build || echo no)"

# 1.6 s at 25 pictures for the energy, then the rows of 0, 0.1, .. 1 s.
holds 'a clean kit makes a movie' \
    $make -s movie PRESET=two EVERY=0.1 UNTIL=1
is 'with the right pictures' '800 480 51 4 0 whole' \
    "$(gif build/movies/two.gif)"
# Later pictures can have only the colours of the first.
colours=$(od -An -v -tu1 -j 13 -N 768 build/movies/two.gif | tr -s ' \n' ' ')
for colour in '0 114 178' '213 94 0' '153 199 224' '238 191 153' '187 187 187'; do
    holds "and the colour $colour" \
        sh -c "case '$colours' in *' $colour '*) ;; *) exit 1 ;; esac"
done
is 'and nothing half made' '' "$(ls build/movies/*.part 2>&1 | grep -v 'No such\|cannot')"
$make -s movie PRESET=two EVERY=0.1 UNTIL=1 FPS=10 >"$work/out" 2>&1
is 'another rate is another movie' '800 480 27 10 0 whole' \
    "$(gif build/movies/two.gif)"
bonkers=build/bin/bonkers

# Every preset that the Makefile names, one second of it, without a word of
# complaint from gnuplot.
for preset in four mixed cradle thermal piston random galperin; do
    $make -s movie PRESET=$preset FPS=5 \
        UNTIL="$([ $preset = galperin ] && echo 0.02 || echo 0.4)" \
        >"$work/out" 2>&1
    is "$preset: a movie, and no complaint" \
        "The movie: build/movies/$preset.gif" \
        "$(grep -v -e '^  ' -e 'frames in animation' "$work/out")"
    is "$preset: a whole GIF" whole "$(gif build/movies/$preset.gif |
        cut -d ' ' -f 6-)"
done

# And of the disks.
for preset in disks gas; do
    $make -s movie PRESET=$preset FPS=5 UNTIL=0.2 >"$work/out" 2>&1
    is "$preset: a movie, and no complaint" \
        "The movie: build/movies/$preset.gif" \
        "$(grep -v -e '^  ' -e 'frames in animation' "$work/out")"
    is "$preset: a whole GIF" whole "$(gif build/movies/$preset.gif |
        cut -d ' ' -f 6-)"
done
is 'four disks: every row a picture, in a square' '480 520 11 20' \
    "$(gif build/movies/disks.gif | cut -d ' ' -f 1-4)"

# Bodies of 1 and 9 kg: radii 1 to 3; neighbours and walls meet as in the run.
$bonkers --preset two --every 0.1 --samples 10 -o two.dat
film() { # SETTINGS PRINT
    gnuplot -e "file='two.dat'; window='dumb'; fps=50; intro=0; $1" \
        plots/movie.gp -e "print $2" 2>&1 >"$work/shown" | tail -1
}
is 'points touch when they meet' '0 0 0 1' "$(film '' \
    "sprintf('%.0f %.0f %.0f %.0f', 1e9*(S[1]-R[1]), 1e9*(S[2]-S[1]-R[1]-R[2]), \
    1e9*(right-3-2*R[1]-2*R[2]), R[2]/R[1]/3)")"
is 'bodies with radii stay where they are' '0 0.1 0.2 3' "$(film \
    "radii='0.1,0.2'" "sprintf('%g %g %g %g', S[1]+S[2], R[1], R[2], right)")"

# 101 rows at 50 a second are due in 2 s and not before. A screen that takes
# nothing for 1.5 s makes it late; then it leaves pictures out, not the last.
$bonkers --preset two --every 0.1 --samples 100 -o two.dat
# shown: how many pictures a text window showed, and the time in the last.
shown() { grep -o 't = [0-9.]* s' "$1" | awk '{ last = $3 } END { print NR, last }'; }
slow() { { sleep "$1"; cat; } >"$work/shown"; }
for lag in 0 1.5; do
    { gnuplot -e "file='two.dat'; window='dumb'; fps=50; intro=0" \
        plots/movie.gp -e 'print time(0.0) - start' 2>"$work/took"; } | slow $lag
    # shellcheck disable=SC2046
    set -- $(shown "$work/shown") "$(tail -1 "$work/took")"
    holds "101 pictures take 2 s ($lag s late: $*)" \
        awk -v took="$3" 'BEGIN { exit !(took >= 1.99) }'
    is "and end with the last ($lag s late)" 10.0 "$2"
done
holds "late, pictures are left out ($1 of 101)" test "$1" -lt 90

# No window here, whether for want of a terminal or of a display.
one_line 'no window: one line that says why' 1 'gnuplot-qt|DISPLAY' \
    env -u DISPLAY -u WAYLAND_DISPLAY gnuplot -e "file='two.dat'" plots/movie.gp
env -u DISPLAY -u WAYLAND_DISPLAY $make -s movie PRESET=two LIVE=1 \
    >"$work/out" 2>&1
is 'and make fails' 2 $?
holds 'with that line' grep -Eq '^movie.gp: .*(gnuplot-qt|DISPLAY)' "$work/out"

# What is no table of a run.
one_line 'no file' 2 "^movie.gp: 'none.dat' cannot be read" \
    gnuplot -e "file='none.dat'; window='dumb'" plots/movie.gp
one_line 'no file of disks' 2 "^disks-movie.gp: 'none.dat' cannot be read" \
    gnuplot -e "file='none.dat'; window='dumb'" plots/disks-movie.gp
one_line 'no table of disks' 2 "^disks-movie.gp: 'two.dat' is no table" \
    gnuplot -e "file='two.dat'; window='dumb'" plots/disks-movie.gp
printf '# masses: 1 2\n0 1\n1 1\n' >bad.dat
one_line 'no table of a run' 2 "^movie.gp: 'bad.dat' is no table" \
    gnuplot -e "file='bad.dat'; window='dumb'" plots/movie.gp
$bonkers --preset piston --every 0.1 --samples 3 --ensemble 2 -o bad.dat
one_line 'an ensemble is no run' 2 "^movie.gp: 'bad.dat' is no table" \
    gnuplot -e "file='bad.dat'; window='dumb'" plots/movie.gp
one_line 'no rate' 2 '^movie.gp: fps: 0 is not' \
    gnuplot -e "file='two.dat'; window='dumb'; fps=0" plots/movie.gp
