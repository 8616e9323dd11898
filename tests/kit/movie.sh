#!/bin/sh
# Movies: the GIF has the pictures it should have, from a kit without programs;
# what touches in the run touches on the screen; a window's rate is the clock's;
# what cannot be shown is refused in one line.
. tests/programs/common
# As plots/show has it: gnuplot 6 has no degree sign in the C locale, and says so.
LC_ALL=C.UTF-8
export LC_ALL
make=${MAKE:-make}
kit=$work/kit root=$PWD
mkdir "$kit"
tar cf - Makefile src plots | (cd "$kit" && tar xf -)
cd "$kit" || exit 1
unset PRESET SCENE KEYS EVERY UNTIL VIEW FPS LIVE DT METHOD KERNEL TOLERANCE output

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

# Everything but ffmpeg.
mkdir "$work/bin"
for folder in $(echo "$PATH" | tr : ' '); do
    ln -s "$folder"/* "$work/bin/" 2>/dev/null
done
rm -f "$work/bin/ffmpeg"
full=$PATH
PATH=$work/bin

# refused NAME PATTERN VARIABLE=VALUE...: in one line, before a program is
# looked for.
refused() {
    what=$1 pattern=$2
    shift 2
    one_line "$what" 2 "^movie: $pattern" env "$@" plots/show movie
}
refused 'a movie of nonsense' "PRESET: 'nonsense' is none of four .* gas$" \
    PRESET=nonsense
refused 'two presets at once' "PRESET: 'four two' is none of" \
    PRESET='four two'
refused 'a preset that is a scene' "PRESET: 'ring' is a scene: SCENE=ring" \
    PRESET=ring
refused 'a scene that is a preset' "SCENE: 'mixed' is a preset: PRESET=mixed" \
    SCENE=mixed
refused 'no scene' "SCENE: 'rng' is no file and none of sun-earth .* galperin$" \
    SCENE=rng
refused 'a preset and a scene' "PRESET: 'four' and SCENE: 'ring': one film" \
    PRESET=four SCENE=ring
for setting in KEYS=--nx=5 VIEW=xy DT=0.1 METHOD=rk4 KERNEL=tree \
    TOLERANCE=1e-3; do
    refused "${setting%%=*} of a preset" \
        "${setting%%=*}: '${setting#*=}': only a SCENE takes that" "$setting"
done
refused 'a view of another kind' "VIEW: 'yz' is none of xy xz tilted" \
    SCENE=ring VIEW=yz
refused 'a method for bonk' 'TOLERANCE: bonk chooses DT and METHOD' \
    SCENE=ring TOLERANCE=1e-3 METHOD=rk4
refused 'a kernel for bonk' 'TOLERANCE: bonk chooses DT and METHOD' \
    SCENE=ring TOLERANCE=1e-3 KERNEL=tree
for rate in 0 51 2.5 x; do
    refused "the rate $rate" "FPS: '$rate' is not a number from 1 to 50" \
        FPS=$rate
done
$make -s movie PRESET=ring >"$work/out" 2>&1
is 'make says so' "movie: PRESET: 'ring' is a scene: SCENE=ring" \
    "$(head -n 1 "$work/out")"
is 'before anything is made' no "$(ls -d build/obj build/bin build/movies 2>/dev/null || echo no)"

# 1.6 s at 25 pictures for the energy, then the rows of 0, 0.1 and 0.2 s. The
# kit has objects and no program: that a clean one compiles what it needs is
# seen in handout.sh.
mkdir -p build
for file in compiler compiler.mk made obj; do
    cp -Rp "$root/build/$file" build || exit 1
done
holds 'a kit without programs makes a movie' \
    $make -s movie PRESET=two EVERY=0.1 UNTIL=0.2
is 'with the right pictures' '960 540 43 4 0 whole' \
    "$(gif build/movies/two.gif)"
is 'and nothing half made' 'two.dat two.gif' "$(echo $(ls build/movies))"
$make -s movie PRESET=two EVERY=0.1 UNTIL=0.2 FPS=5 >"$work/out" 2>&1
is 'another rate is another movie' '960 540 11 20 0 whole' \
    "$(gif build/movies/two.gif)"
bonkers=build/bin/bonkers

# film WHAT NAME PICTURES VARIABLE=VALUE...: it is made without a word of
# complaint, and is whole.
film() {
    what=$1 name=$2 pictures=$3
    shift 3
    env "$@" plots/show movie >"$work/out" 2>&1
    is "$what: a movie, and no complaint" "The movie: build/movies/$name.gif" \
        "$(grep -v '^  ' "$work/out")"
    is "$what: $pictures pictures" "960 540 $pictures 50 0 whole" \
        "$(gif "build/movies/$name.gif")"
}
# Every preset: 1.6 s for the energy, but for disks, and two rows.
awk '$1 == "preset" { print $2, $3 }' plots/films | while read -r name every; do
    case $name in disks | gas) n=2 ;; *) n=6 ;; esac
    film "$name" "$name" $n PRESET="$name" FPS=2 UNTIL="$every"
done

# Every scene of the gallery has a line in plots/films, and no other has. One
# without a line is filmed as well, in a hundred rows of step's.
cp plots/films films
sed -i '/^scene  *oscillator /d' plots/films
film 'a scene that is not listed' scene-oscillator 11 SCENE=oscillator \
    UNTIL=0.1 FPS=2
cp films plots/films
is 'plots/films has every scene' \
    "$(build/bin/scene --help | sed -n 's/^  \([a-z][a-z-]*\)  .*/\1/p')" \
    "$(awk '$1 == "scene" { print $2 }' plots/films)"
# With it the film takes 6 to 16 s, and something moves by a tenth of all.
awk '$1 == "scene" { print $2, $3, $4 }' plots/films >"$work/scenes"
while read -r name every until; do
    keys= how=
    [ "$name" != ring ] || keys='--particles 40'
    # Bodies that almost meet need steps of their own length.
    [ "$name" != pythagorean ] || how='--method radau15 --tolerance 1e-9'
    # shellcheck disable=SC2086
    build/bin/scene "$name" $keys -o run.plist
    n=$(awk "BEGIN { print int($until / $every / 8) }")
    # shellcheck disable=SC2086
    build/bin/step run.plist --until "$until" -o run.dat $how \
        --every "$(awk "BEGIN { print $n * $every }")"
    holds "$name: a film of 6 to 16 s ($((8 * n / 25)))" \
        test "$n" -ge 18 -a "$n" -le 50
    holds "$name: it moves" awk '!/^#/ {
        if (!rows++)
            for (i = 2; i <= NF; ++i)
                first[i] = $i
        for (i = 2; i <= NF; ++i)
            if ((i - 2) % 6 < 3) {
                k = (i - 2) % 6
                if (rows == 1 && i < 8 || $i < low[k]) low[k] = $i
                if (rows == 1 && i < 8 || $i > high[k]) high[k] = $i
                d = ($i - first[i]) ^ 2
                if (d > far) far = d
            }
        }
        END {
            for (k = 0; k < 3; ++k)
                if (high[k] - low[k] > size) size = high[k] - low[k]
            print sqrt(far), "of", size
            exit !(rows > 7 && sqrt(far) > 0.07 * size)
        }' run.dat
    film "$name" "scene-$name" 2 SCENE="$name" KEYS="$keys" FPS=2 UNTIL="$every"
done <"$work/scenes"
film 'what bonk has made' scene-sun-earth 3 SCENE=sun-earth TOLERANCE=1e-3 \
    UNTIL=6 FPS=2
holds 'by bonk' grep -q '^# bonk ' build/movies/scene-sun-earth.dat

# A scene of one's own, by any name; what is typed is no command.
cp run.plist "a b;touch pwned.plist"
holds 'a file, whatever it is called' $make -s movie \
    SCENE="a b;touch pwned.plist" EVERY=0.1 UNTIL=0.2 FPS=2
is 'its film' '960 540 3 50 0 whole' \
    "$(gif 'build/movies/scene-a_b_touch_pwned.gif')"
# shellcheck disable=SC2016
value="x'; touch pwned; \"\$(touch pwned) \`touch pwned\` \$(shell touch pwned)"
for goal in movie inspect chart; do
    for setting in SCENE="$value" KEYS="$value" UNTIL="$value"; do
        $make -s $goal SCENE=sun-earth "$setting" >"$work/out" 2>&1
        is "$goal: ${setting%%=*} is text, and refused" 2 $?
    done
done
is 'and nothing else is done' '' "$(ls pwned 2>/dev/null)"
one_line 'a file takes no keys' 2 "^movie: KEYS: 'run.plist' is a file" \
    env SCENE=run.plist KEYS='--dt 1' plots/show movie

# MP4 where ffmpeg is: here one that writes down what it is given.
mkdir "$work/fake"
cat >"$work/fake/ffmpeg" <<'END'
#!/bin/sh
for file; do :; done
echo "$*" >"$file"
cd "${file%/*}" && set -- *.png && echo $# "$1" >>mp4 &&
    od -An -v -tu1 -j 16 -N 8 "$1" >>mp4
END
chmod +x "$work/fake/ffmpeg"
PATH=$work/fake:$PATH SCENE=four-disks UNTIL=0.1 plots/show movie \
    >"$work/out" 2>&1
is 'with ffmpeg: an MP4' 'The movie: build/movies/scene-four-disks.mp4' \
    "$(grep -v '^  ' "$work/out")"
is 'of six pictures, 1920 by 1080' '6 00000.png 0 0 7 128 0 0 4 56' \
    "$(sed 1d build/movies/scene-four-disks.mp4 | tr -s ' \n' ' ' | sed 's/ $//')"
holds 'at their rate' grep -q -e '-framerate 25 -i .*/%05d.png .*-pix_fmt yuv420p' \
    build/movies/scene-four-disks.mp4
echo 'echo "ffmpeg: no such codec" >&2; exit 1' >>"$work/fake/ffmpeg"
sum=$(cksum <build/movies/scene-four-disks.mp4)
PATH=$work/fake:$PATH SCENE=four-disks UNTIL=0.1 plots/show movie \
    >"$work/out" 2>&1
is 'one that cannot is heard' '1 ffmpeg: no such codec' \
    "$? $(grep -v '^  ' "$work/out")"
is 'and the film there was is kept' "$sum" \
    "$(cksum <build/movies/scene-four-disks.mp4)"
is 'no pictures are left' '' "$(ls -d build/movies/*.frames 2>/dev/null)"
PATH=$full

# What is drawn: the scene's own colours and radii, its springs, its walls.
# said SCENE KEYS VIEW: how it is to be seen; drawn: its last picture.
said() {
    # shellcheck disable=SC2086
    build/bin/scene "$1" $2 -o run.plist
    build/bin/step run.plist --until 0.3 --every 0.1 -o run.dat ${4-}
    awk -v view="$3" -v ask=1 -f plots/scene-movie.awk run.plist run.dat
}
drawn() {
    awk -v view="$1" -v fps=25 -v left=-1 -v right=1 -v bottom=-1 -v top=1 \
        -f plots/scene-movie.awk run.plist run.dat | awk '/bodies/ { all = "" }
        { all = all $0 "\n" } END { printf "%s", all }'
}
is 'three bodies on a plane: seen from above' 'rows 4 0.1 0 xy' \
    "$(said figure-eight '' '' | cut -d ' ' -f 1-5)"
drawn xy >picture
is 'red, green and blue, as large as the scene has them' \
    '0.03 16711680 0.03 65280 0.03 255' \
    "$(sed -n 2,4p picture | awk '{ printf "%s%g %d", (NR > 1 ? " " : ""), $3, $4 }')"
is 'a pendulum: from the side' 'xz' \
    "$(said double-pendulum '' '' | cut -d ' ' -f 5)"
is 'a cradle: on a line' '1 xy' "$(said cradle '' '' | cut -d ' ' -f 4,5)"
is 'a membrane: from where it is seen, its heights thrice' 'tilted 3' \
    "$(said membrane '' '' | cut -d ' ' -f 5,6)"
is 'or as one wants it' 'xz 1' "$(said membrane '' xz | cut -d ' ' -f 5,6)"
drawn tilted >picture
is 'its springs are lines' 112 \
    "$(sed '1,/springs/d; /ways/,$d' picture | grep -c '^$' | awk '{ print $1 - 1 }')"
said gas '--particles 30' '' >/dev/null
is 'hard walls bound the picture' 'xy 1 0 7.5 0 5' \
    "$(said gas '--particles 30' '' | cut -d ' ' -f 5-)"
said gas '--particles 30' '' '--track 3,7' >/dev/null
is 'of bodies that are tracked, these' 2 \
    "$(drawn xy | sed '/^end/,$d' | grep -c '^[0-9]')"

# A disk on the screen is round and has a smooth rim: as wide as high, the
# right area, and half-tones.
printf '%s\n' 'pos 0 0 0 0 1 0 0 .5 .5 .5' 'pos 1 1 0.2 0 1 0 0.4 0 0 1' \
    'vel 1 0 0.2 0' contact >run.plist
build/bin/step run.plist --dt 0.1 --until 0.2 --every 0.1 -o run.dat
mkdir one
gnuplot -e "file='run.dat'; scene='run.plist'; output='one'" \
    plots/scene-movie.gp
gnuplot -e "set table 'pixels'; \
plot 'one/00000.png' binary filetype=png using 1:2:3 with rgbimage" 2>/dev/null
awk '!/^#/ && NF >= 5 && $5 > $3 {
        ++n
        half += $3 > 20 && $3 < 235
        if (!lx || $1 < lx) lx = $1
        if ($1 > hx) hx = $1
        if (!ly || $2 < ly) ly = $2
        if ($2 > hy) hy = $2
    }
    END {
        w = hx - lx + 1
        h = hy - ly + 1
        printf "%d %.2f %s\n", w - h, n / w / h, (half > 50 ? "smooth" : half)
    }' pixels >"$work/round"
is 'a disk is round and smooth' '0 0.78 smooth' "$(cat "$work/round")"

# Bodies of 1 and 9 kg: radii 1 to 3; neighbours and walls meet as in the run.
$bonkers --preset two --every 0.1 --samples 10 -o two.dat
print_film() { # SETTINGS PRINT
    gnuplot -e "file='two.dat'; window='dumb'; fps=50; intro=0; $1" \
        plots/movie.gp -e "print $2" 2>&1 >"$work/shown" | tail -1
}
is 'points touch when they meet' '0 0 0 1' "$(print_film '' \
    "sprintf('%.0f %.0f %.0f %.0f', 1e9*(S[1]-R[1]), 1e9*(S[2]-S[1]-R[1]-R[2]), \
    1e9*(right-3-2*R[1]-2*R[2]), R[2]/R[1]/3)")"
is 'bodies with radii stay where they are' '0 0.1 0.2 3' "$(print_film \
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
gnuplot -e "file='run.dat'; scene='run.plist'; window='dumb'; fps=50; unit='s'" \
    plots/scene-movie.gp >"$work/shown" 2>&1
is 'a scene in a window ends with its last row' 0.2 \
    "$(shown "$work/shown" | cut -d ' ' -f 2)"

# No window here, whether for want of a terminal or of a display.
one_line 'no window: one line that says why' 1 'gnuplot-qt|DISPLAY' \
    env -u DISPLAY -u WAYLAND_DISPLAY gnuplot -e "file='two.dat'" plots/movie.gp
one_line 'nor for a scene' 1 '^scene-movie.gp: .*(gnuplot-qt|DISPLAY)' \
    env -u DISPLAY -u WAYLAND_DISPLAY \
    gnuplot -e "file='run.dat'; scene='run.plist'" plots/scene-movie.gp
env -u DISPLAY -u WAYLAND_DISPLAY $make -s movie PRESET=two LIVE=1 \
    >"$work/out" 2>&1
is 'and make fails' 2 $?
holds 'with that line' grep -Eq '^movie.gp: .*(gnuplot-qt|DISPLAY)' "$work/out"

# What is no table of a run.
grep -v '^0\.[12]' run.dat >one.dat
sed '/^[pv][a-z]* 1 /d' run.plist >other.plist
one_line 'no file' 2 "^movie.gp: 'none.dat' cannot be read" \
    gnuplot -e "file='none.dat'; window='dumb'" plots/movie.gp
one_line 'no file of a scene' 2 "^scene-movie.gp: 'none.dat' cannot be read" \
    gnuplot -e "file='none.dat'; window='dumb'" plots/scene-movie.gp
one_line 'no states' 2 "^scene-movie.gp: 'two.dat' and 'two.dat': no table" \
    gnuplot -e "file='two.dat'; window='dumb'" plots/scene-movie.gp
one_line 'one row' 2 'a table of 1 rows, expected two at least' \
    gnuplot -e "file='one.dat'; scene='run.plist'; window='dumb'" \
    plots/scene-movie.gp
one_line 'another scene' 2 'a table with a body 1, which the scene has not' \
    gnuplot -e "file='run.dat'; scene='other.plist'; window='dumb'" \
    plots/scene-movie.gp
printf '# masses: 1 2\n0 1\n1 1\n' >bad.dat
one_line 'no table of a run' 2 "^movie.gp: 'bad.dat' is no table" \
    gnuplot -e "file='bad.dat'; window='dumb'" plots/movie.gp
$bonkers --preset piston --every 0.1 --samples 3 --ensemble 2 -o bad.dat
one_line 'an ensemble is no run' 2 "^movie.gp: 'bad.dat' is no table" \
    gnuplot -e "file='bad.dat'; window='dumb'" plots/movie.gp
one_line 'no rate' 2 '^movie.gp: fps: 0 is not' \
    gnuplot -e "file='two.dat'; window='dumb'; fps=0" plots/movie.gp
scenes=$(grep -c '^scene ' plots/films)
echo "1..$((100 + 4 * scenes))"
