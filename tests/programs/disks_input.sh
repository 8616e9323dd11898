#!/bin/sh
# Bad commands and bad files: one clear line, the right status.
. tests/programs/common
d=build/bin/disks

refuses 2 "disks: '0'" $d --disks 0
refuses 2 "disks: 'ten'" $d --disks ten
refuses 2 "dimensions: '4'" $d --dimensions 4
refuses 2 'box: a side of 1 has no room between its walls for a radius of 0.6' \
    $d --disks 2 --radius 0.6 --box 5,1
refuses 2 'box: a side of 1 has no room' $d --dimensions 3 --disks 2 \
    --radius 0.6 --box 5,5,1
refuses 2 'box: a side of 1 has no room' $d --disks 1 --radius 0.6 --box 5,1 \
    --boundary floor --until 1
refuses 2 "radius: '0'" $d --radius 0
refuses 2 "packing: '1.1'" $d --packing 1.1
refuses 2 "box: side 2 is 0" $d --box 1,0
refuses 2 "box has 2 sides, expected 3" $d --dimensions 3 --box 1,1
refuses 2 "packing: the box and the radii are given" \
    $d --packing 0.3 --radius 0.1 --box 1,1
refuses 2 "'round'.*walls" $d --boundary round
refuses 2 "'grid'.*auto" $d --engine grid
refuses 2 "'heat'.*states" $d --measure heat
refuses 2 "speed: '0'" $d --speed 0
refuses 2 "engine: cells need a larger box" \
    $d --disks 4 --packing 0.3 --boundary periodic --engine cells
refuses 2 "heavy: '3' is not a mass and a radius" $d --heavy 3
refuses 2 "heavy: '3,0' is not" $d --heavy 3,0
refuses 2 "restitution: '2'" $d --restitution 2
refuses 2 "measure speeds needs --every" $d --measure speeds
refuses 2 "measure brownian needs --heavy" $d --measure brownian --every 1
refuses 2 "until: needed for disks that never meet" $d --disks 1 --warmup 0
refuses 2 "every: '0'" $d --every 0
refuses 2 "both go to" $d --summary -
refuses 2 "stray" $d stray
refuses 2 "periodic box needs two" $d --disks 1 --boundary periodic
refuses 2 "speeds needs more disks: 2" \
    $d --disks 2 --boundary periodic --measure speeds --every 1
refuses 2 "100 disks .*find no place on a lattice" $d --disks 100
refuses 2 "no room between its walls" $d --disks 4 --radius 0.01 \
    --heavy 10,0.6 --until 1
refuses 2 "find no place at random" \
    $d --disks 100 --packing 0.8 --start random
refuses 2 "places 20000 disks at most, not 20001" \
    $d --disks 20001 --packing 0.1 --start random
refuses 2 "filled by the heavy disk alone" \
    $d --packing 0.1 --box 10,10 --heavy 1,4
refuses 1 "nowhere/out" $d -o "$work/nowhere/out"

# Kinds.
kinds() { # NAME PATTERN TEXT
    printf "$3" >"$work/$1"
    refuses 2 "$2" $d --species "$work/$1" --packing 0.2
}
kinds short "short:2: '3 1'" '# kinds\n3 1\n'
kinds long "long:1: '3 1 1 1'" '3 1 1 1\n'
kinds part "part:1: '1.5 1 1'" '1.5 1 1\n'
kinds light "light:1: '3 0 1'" '3 0 1\n'
kinds none 'none has no line' '# nothing\n'
refuses 2 "species: $work/missing: No such file" $d --species "$work/missing"

# States.
state() { # NAME PATTERN TEXT [OPTION...]
    printf "$3" >"$work/$1"
    name=$1 pattern=$2
    shift 3
    refuses 2 "$pattern" $d --start "$work/$name" "$@"
}
box='# box 10 10 walls\n'
one='0 1 1 0.5 2 5 1 0\n'
state overlap 'overlap: disks 1 and 3 overlap' \
    "$box${one}0 2 1 0.5 5 5 1 0\n0 3 1 0.5 2.9 5 0 0\n"
state outside 'outside: disk 2 is not inside' "$box${one}0 2 1 0.5 9.6 5 1 0\n"
state empty 'empty: 0 rows' "$box"
state words 'words:3: 5 numbers' "$box${one}0 2 1 0.5 9 x 1 0\n"
state torn 'torn:3: 7 numbers' "$box${one}0 2 1 0.5 9 5 1\n"
state mixed 'mixed:3: 11 numbers' "$box${one}0 2 1 0.5 8 5 1 0 8 5 0\n"
state flat 'the box has 2 sides, the rows have 3' "${box}0 1 1 0.5 2 5 5 1 0 0\n"
state boxless "has no head like '# box" "$one"
state massless 'disk 1 has mass 0' "${box}0 1 0 0.5 2 5 1 0\n"
state late 'disk 1 has mass 1, radius 0.5 and times 0, 1' \
    "${box}0 1 1 0.5 2 5 1 0 2 5 1\n"
state times 'disk 2 has .* times 1, 1; expected' "$box${one}1 2 1 0.5 8 5 1 0\n"
state nan 'nan:2: 4 numbers' "${box}0 1 1 0.5 nan 5 1 0\n"
state own 'disks: means nothing with --start ' "$box$one" --disks 3
state still 'until: needed' "$box$one"
refuses 2 'until: needed for disks that never meet' $d --disks 1 --collisions 50
refuses 2 "$work/missing: No such file" $d --start "$work/missing"
printf "$one" >"$work/bare"
holds 'a box from the command serves' \
    $d --start "$work/bare" --box 10,10 --until 1 -o /dev/null
printf "$box${one}\n\n5 1 1 0.5 3 5 1 0\n" >"$work/blocks"
holds 'the last block is the start' sh -c \
    "$d --start '$work/blocks' --until 6 | tail -n 1 | grep -q '^6 1 1 0.5 4 5 1 0'"

# A collapse is a failed run, and keeps its table.
printf '# box 3.5 1.2 walls\n0 1 1 0.5 0.5 0.6 0 0\n0 2 1 0.5 1.6 0.6 0 0\n0 3 1 0.5 2.9 0.6 -1 0\n' >"$work/row"
refuses 1 'inelastic collapse at t = ' \
    $d --start "$work/row" --restitution 0.1 --until 1000 -o "$work/collapsed"
holds 'the table of a collapse is kept' \
    sh -c "tail -n 1 '$work/collapsed' | grep -q ' 3 1 0.5 '"

# Disks that slow down end their run: at the collision asked for, or at rest.
holds 'disks that slow down reach their last collision' \
    timeout 60 $d --restitution 0.5 --summary /dev/null -o /dev/null
refuses 1 'too cold to go on: .* at t = ' \
    $d --restitution 0.5 --collisions 1000000 -o /dev/null

# A periodic box shows each disk one image of another, and time for it.
narrow='too narrow to be periodic: with a radius of'
refuses 2 "boundary: a side of 1 is $narrow 0.25 it must be more than 1" \
    $d --boundary periodic --radius 0.25 --disks 2 --until .1
refuses 2 "$narrow 0.3 " $d --boundary periodic --heavy 5,.3
refuses 2 "$narrow 0.2499999" \
    $d --boundary periodic --radius 0.2499999 --disks 2 --until .1
refuses 2 "$narrow 0.5 " $d --boundary periodic --packing .6 --disks 2
cat >"$work/two" <<'END'
# box 1 1 periodic
0 1 1 .3 .2 .2 1 0
0 2 1 .3 .8 .8 -1 0
END
refuses 2 "$narrow 0.3 " $d --start "$work/two" --until .1
# Those that are too small to meet are not waited for.
refuses 2 'until: needed for disks that never meet' $d --radius 1e-12

# Rows without end.
refuses 2 'every: 4.94066e-324 s makes more than 9e15 rows in 1 s' \
    $d --every 5e-324 --until 1
refuses 2 'every: 4.94066e-324 s makes more than 9e15 rows' $d --every 5e-324
$d --every 5e-324 --samples 2 -o "$work/few"
holds 'but three of them are three' \
    test "$(awk 'NF && !/^#/' "$work/few" | wc -l)" -eq 12
# A gas that cools ends before squares of its speeds are no numbers, by both
# engines alike (found by a trial of the second edition: cells never ended).
for engine in pairs cells; do
    refuses 1 'too cold to go on: .* at t = 4.59365e+134 s after 42703 collisions' \
        $d -N 20 -r .05 -e .9 -c 52000 --engine $engine -o "$work/$engine"
done
grep -v '^# command' "$work/pairs" >"$work/a"
grep -v '^# command' "$work/cells" >"$work/b"
holds 'both with the same last state' cmp "$work/a" "$work/b"
refuses 2 'speed: the speeds are too low' $d --speed 1e-160
refuses 2 'temperature: the speeds are too low' $d --temperature 1e-300
$d --speed 1e-130 -c 1000 -o /dev/null -S "$work/s"
holds 'above that no energy is lost' awk '$1 == "energy_error" {
    seen = 1; bad = $2 * $2 > 1e-26 } END { exit bad || !seen }' "$work/s"
echo 1..76
