#!/bin/sh
# make inspect: a picture of any observable against any other, of a scene by
# name or by file, also of a run that blows up; what is wrong is said. And
# make chart: what bonk has tried, be it much or little.
. tests/programs/common
# As plots/show has it: gnuplot 6 has no degree sign in the C locale, and says so.
export LC_ALL=C.UTF-8
make=${MAKE:-make}
copy_kit Makefile src plots
mkdir -p build/bin
cp "$OLDPWD"/build/bin/step "$OLDPWD"/build/bin/scene "$OLDPWD"/build/bin/bonk build/bin
unset SCENE PRESET X Y UNTIL DT METHOD EVERY KEYS LIVE TOLERANCE OBSERVE output
# What make would build is there already.
inspect() { $make -s inspect -o build/bin/step -o build/bin/scene "$@"; }

# drawn NAME: the picture is whole and has curves.
drawn() {
    holds "$1: a picture" sh -c "
        grep -q '</svg>' build/inspect/$1.svg && xmllint --noout \
        build/inspect/$1.svg && grep -c '<path' build/inspect/$1.svg"
}
inspect SCENE=membrane X=t Y=z:30 UNTIL=20 >"$work/out" 2>&1
holds 'it says what it runs, where the picture is, and nothing else' \
    test "$(sed 1d "$work/out")" = 'The picture: build/inspect/membrane.svg'
drawn membrane
holds 'its axes have words and units' sh -c "
    grep -q '>time t  (s)<' build/inspect/membrane.svg &&
    grep -q '>z of body 30  (m)<' build/inspect/membrane.svg"
build/bin/scene figure-eight -o mine.plist
inspect SCENE=mine.plist X=x:0 Y=y:0 DT=0.02 METHOD=rk4 EVERY=0.1 \
    >"$work/out" 2>&1
drawn mine
holds 'the command is that of the variables' grep -q \
    '^# command: step mine.plist --observe x:0,y:0 --until 12.64 --dt 0.02 --method rk4 --every 0.1' \
    build/inspect/mine.dat
inspect SCENE=membrane KEYS='--nx 5 --ny 5' Y=parts UNTIL=3 >"$work/out" 2>&1
holds 'keys go to the scene' \
    test "$(grep -c ^pos build/inspect/membrane.plist)" -eq 25
holds 'four columns are four curves' \
    grep -q 'U_springs' build/inspect/membrane.svg
inspect SCENE=membrane X=momentum Y=parts UNTIL=1 >"$work/out" 2>&1
holds 'eight columns are eight, not octal' test $? -eq 0
# last NAME: the time of the last row.
last() { tail -n 1 "build/inspect/$1.dat" | cut -d ' ' -f 1; }
inspect SCENE=sun-earth >"$work/out" 2>&1
holds 'a scene ends when its film ends' awk -v last="$(last sun-earth)" \
    '$2 == "sun-earth" { exit !(last > 0.99 * $4 && last <= $4) }' plots/films
holds 'its units are astronomical' sh -c "
    grep -q '>time t  (d)<' build/inspect/sun-earth.svg &&
    grep -q '>change of energy E  (solar mass AU²/d²)<' build/inspect/sun-earth.svg"
# scales NAME: the units on both axes are of one length, in dots.
scales() {
    gnuplot -e "file='build/inspect/$1.dat'; output='x.svg'; pairs=$2" \
        plots/inspector.gp -e "print abs(log((GPVAL_TERM_XMAX-GPVAL_TERM_XMIN) \
        *(GPVAL_Y_MAX-GPVAL_Y_MIN)/((GPVAL_TERM_YMAX-GPVAL_TERM_YMIN) \
        *(GPVAL_X_MAX-GPVAL_X_MIN)))) < 0.02 ? 'same' : 'not'" 2>&1
}
inspect SCENE=figure-eight X=x:1,x:2 Y=y:1,y:2 >"$work/out" 2>&1
holds 'two paths: a picture with two names' sh -c "
    grep -q '>body 1<' build/inspect/figure-eight.svg &&
    grep -q '>body 2<' build/inspect/figure-eight.svg &&
    grep -q '>x<' build/inspect/figure-eight.svg"
holds 'of lengths, and one scale' test "$(scales figure-eight 2)" = same
inspect SCENE=figure-eight X=t Y=x,y >"$work/out" 2>&1
holds 'of all bodies, against the time' sh -c "
    grep -q '>x of body 0<' build/inspect/figure-eight.svg &&
    grep -q '>y of body 2<' build/inspect/figure-eight.svg"
holds 'and two scales' test "$(scales figure-eight 1)" = not
inspect SCENE=solar-system X=x Y=y UNTIL=300 >"$work/out" 2>&1
holds 'all bodies against their own' test "$(grep -o '>body [0-9]<' \
    build/inspect/solar-system.svg | sort -u | wc -l)" -eq 9
for pair in 'x:0,x:1 y:0' 'x:0,x:1 y:0,y:1,t' 'momentum,t x:0,x:1'; do
    inspect SCENE=sun-earth X="${pair% *}" Y="${pair#* }" >"$work/out" 2>&1
    holds "not as many of each: $pair" grep -q '^inspect: X: ' "$work/out"
done
inspect SCENE=gas X=x Y=y >"$work/out" 2>&1
holds 'but not 250 of them' grep -q \
    "^inspect: 'x': the scene has 250 bodies; name some, as in x:0,x:249" \
    "$work/out"
cp build/inspect/sun-earth.plist "my own.scene.plist"
inspect SCENE='my own.scene.plist' >"$work/out" 2>&1
holds 'a name with a space' grep -qx \
    'The picture: build/inspect/my_own.scene.svg' "$work/out"
inspect SCENE=mine.plist KEYS='--dt 1' >"$work/out" 2>&1
holds 'a file takes no keys' grep -q "^inspect: KEYS: 'mine.plist' is a file" \
    "$work/out"

inspect SCENE=double-pendulum Y=energy DT=0.03 >"$work/out" 2>&1
holds 'a run that blows up is drawn' test $? -eq 0
holds 'and says so' grep -q '^step: blew up after' "$work/out"
drawn double-pendulum

inspect SCENE=nonsense >"$work/out" 2>&1
holds 'no scene: make fails' test $? -ne 0
holds 'and the line says which there are' \
    grep -q "^scene: 'nonsense' is no scene; there are" "$work/out"
inspect SCENE=sun-earth Y=z:30 >"$work/out" 2>&1
holds 'no such body: make fails' test $? -ne 0
holds 'and the line says which there are' \
    grep -q "^step: --observe: 'z:30': z needs 1 of the bodies 0 to 1" "$work/out"
# told PATTERN: the script says one line about bad.dat, with status 2.
script=inspector
told() {
    gnuplot -e "file='bad.dat'; output='x.svg'" plots/$script.gp \
        >"$work/out" 2>&1
    got=$?
    if [ $got -eq 2 ] && [ "$(wc -l <"$work/out")" -eq 1 ] &&
        grep -q "^$script.gp: $1" "$work/out"
    then ok "refused: $1"; else
        not_ok "refused: $1" "status $got: $(cat "$work/out")"; fi
}
echo '# nothing' >bad.dat
told "'bad.dat' is no table of step"
printf '# 1 t [s] t\n# 2 t [s] t\n# 3 x [m] x\n0 0 0\n' >bad.dat
told "'bad.dat' has 1 rows, expected two"
# no_window SCRIPT FILE: says in one line what is missing.
no_window() {
    env -u DISPLAY -u WAYLAND_DISPLAY gnuplot -e "file='$2'" "plots/$1.gp" \
        >"$work/out" 2>&1
    got=$?
    holds "$1: no window is one line that says why" sh -c "
        test $got -eq 1 && test \$(wc -l <'$work/out') -eq 1 &&
        grep -Eq '^$1.gp: .*(gnuplot-qt|DISPLAY)' '$work/out'"
}
no_window inspector build/inspect/sun-earth.dat
inspect SCENE=sun-earth LIVE=1 >"$work/out" 2>&1
holds 'and make fails with it' grep -Eq '^inspector.gp: .*(gnuplot-qt|DISPLAY)' \
    "$work/out"

# chart OPTION...: what it says on standard error goes to $work/err.
chart() {
    $make -s chart -o build/bin/bonk -o build/bin/scene "$@" 2>"$work/err" |
        tail -n 1 >"$work/out"
}
for name in sun-earth figure-eight; do
    chart SCENE=$name
    holds "what was tried on $name is drawn, and no complaint" sh -c "
        cat '$work/err'; test ! -s '$work/err' &&
        grep -qx 'The chart: build/chart/$name.svg' '$work/out' &&
        xmllint --noout build/chart/$name.svg"
done
holds 'with the plan that was taken' \
    grep -q 'taken:pefrl' build/chart/figure-eight.svg
chart SCENE=four-disks
holds 'where all was refused there is nothing to draw, and why is said' sh -c "
    cat '$work/err'; grep -q '^bonk: .*horizon' '$work/err' &&
    grep -q '^chart.gp: nothing to draw: horizon: after t = ' '$work/err'"
gnuplot -e "file='build/chart/four-disks.dat'; output='none.svg'" \
    plots/chart.gp 2>"$work/err"
holds '  with the status of a refusal' test $? -eq 1
script=chart
echo '# nothing' >bad.dat
told "'bad.dat' is no table of bonk --chart"
echo '# tolerance: 0.001' >bad.dat
told "'bad.dat' has no run to be drawn"
chart SCENE='my own.scene.plist'
holds 'and of a file with a space in its name' grep -qx \
    'The chart: build/chart/my_own.scene.svg' "$work/out"
no_window chart build/chart/sun-earth.dat
echo 1..41
