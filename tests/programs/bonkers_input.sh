#!/bin/sh
# Bad commands, unwritable files and stopped runs of bonkers: one clear line,
# the right status, nothing half-written.
. tests/programs/common
b=build/bin/bonkers
s=build/bin/bonkers-studies

refuses 2 "preset: 'nope' is not four, mixed" $b --preset nope
refuses 2 "engine: 'fast' is not auto, naive" $b --engine fast
refuses 2 "positions: 3 numbers found, expected 2" \
    $b --masses 1,2 --positions 1,2,3
refuses 2 "velocities: 1 numbers found, expected 2" \
    $b --positions 1,2 --velocities 1
refuses 2 "positions: mover 1 and mover 2 overlap" $b --positions 2,1
refuses 2 "positions: mover 1 and mover 2 overlap" \
    $b --positions 1,2 --radii .6,.6
refuses 2 "the left wall and mover 1 overlap" \
    $b --positions 1,2 --walls 1.5,4
refuses 2 "mover 2 and the right wall overlap" \
    $b --positions 1,2 --walls 0,1.5
refuses 2 "the left wall and mover 1 overlap" \
    $b --positions 1,2 --radii 1.5,0
refuses 2 "samples: means nothing without --every" $b --samples 3
refuses 2 "collisions: means nothing with --ensemble" \
    $b --preset piston --ensemble 3 --collisions 5
refuses 2 "restitution: means nothing with --ensemble" \
    $b --preset piston --ensemble 3 --restitution 0.5
refuses 2 "ensemble: means nothing without --preset thermal" $b --ensemble 3
refuses 2 "particles: piston cannot have 4" $b --preset piston -N 4
refuses 2 "two cannot have 3 movers" $b --preset two --positions 1,2,3
refuses 2 "particles: '0' is not" $b --particles 0
refuses 2 "particles: '1e8' is not" $b --particles 1e8
refuses 2 "particles: means nothing with lists of them" \
    $b --positions 1,2 --particles 3
refuses 2 "need --positions" $b --masses 1,2
refuses 2 "mass-ratio: means nothing without --preset piston" $b --mass-ratio 3
refuses 2 "mass-ratio: '0' is not" $b --preset two --mass-ratio 0
refuses 2 "walls: '3,1', expected the left one" $b --walls 3,1
refuses 2 "walls: '1,1', expected the left one" $b --walls 1,1
refuses 2 "walls: '1,2,3' has more than 2" $b --walls 1,2,3
refuses 2 "walls: '-inf'" $b --walls=-inf,3
refuses 2 "radii: number 1 is -1" $b --positions 1,2 --radii=-1,1
refuses 2 "masses: number 1 is 0" $b --positions 1,2 --masses 0,1
refuses 2 "masses: number 2 is -1" $b --positions 1,2 --masses 1,-1
refuses 2 "velocities: 'nan'" $b --positions 1,2 --velocities 1,nan
refuses 2 "until: '-1' is not" $b --until=-1
refuses 2 "until: 'nan' is not" $b --until nan
refuses 2 "every: '0' is not" $b --every 0
refuses 2 "every: '-1' is not" $b --every=-1
refuses 2 "restitution: '1.1' is not" $b --restitution 1.1
refuses 2 "restitution: '-0.1' is not" $b --restitution=-0.1
refuses 2 "samples: '0' is not" $b --every 1 --samples 0
refuses 2 "collisions: '-1' is not" $b --collisions=-1
refuses 2 "ensemble: '1' is not" $b --ensemble 1
refuses 2 "threads: '0' is not" $b --threads 0
refuses 2 "seed: '-1' is not" $b --seed=-1
refuses 2 "'stray' is not an option" $b stray
refuses 2 "summary and the table would both go to '-'" $b --summary -
refuses 2 "both go to" $b --summary "$work/x" -o "$work/x"
refuses 2 "study is needed" $s
refuses 2 "study: 'x' is not speed, drift" $s --study x
refuses 2 "collisions: '10' is not" $s --study drift --collisions 10
refuses 2 "stray" $s --study drift stray
refuses 1 "nowhere/out" $b -o "$work/nowhere/out"
refuses 1 "nowhere/sum" $b --summary "$work/nowhere/sum"
refuses 1 "nowhere/out" $s --study collapse -o "$work/nowhere/out"
holds 'nothing is left of refused files' \
    test "$(ls "$work" | tr '\n' ' ')" = "err out "
if [ -w /dev/full ]; then
    refuses 1 "No space left" $b -o /dev/full
    refuses 1 "No space left" $b --summary /dev/full
fi

# Bodies that touch are not refused for the rounding of their radii.
touch_each_other() { # NAME OPTION...
    what=$1
    shift
    holds "$what" $b "$@" --until 1 -o "$work/touching"
}
touch_each_other 'rods that touch: .1, .3, .5, .7' \
    --positions .1,.3,.5,.7 --radii .1,.1,.1,.1
touch_each_other 'rods that touch far from the wall' \
    --positions 1000.1,1000.3,1000.5 --radii .1,.1,.1
touch_each_other 'rods that fill the box' \
    --positions .1,.3,.5 --radii .1,.1,.1 --walls 0,.6

# A collapse is no wrong command: status 1, one line, the table kept with its
# last row.
refuses 1 "inelastic collapse at t = 3.298.* after 23[0-9] collisions" \
    $b --masses 1,1 --positions 1,2 --velocities 0,-1 --walls 0 \
    --restitution 0.1 -o "$work/collapse" --summary "$work/sum"
holds 'a collapse keeps its last row' \
    awk '!/^#/ { n++; t = $1; if (NF != 10) exit 1 }
        END { exit !(n == 2 && t > 3.29 && t < 3.3) }' "$work/collapse"
refuses 1 "collapse" $b --positions 1,2 --velocities 0,-1 --walls 0 \
    --restitution 0 -o "$work/collapse"

# A run that is stopped: status 1, one line, a table with whole rows, and no
# summary that looks whole.
stop_run() { # NAME SIGNAL OPTION...
    what=$1 signal=$2
    shift 2
    rm -f "$work/table" "$work/summary"
    "$b" "$@" -o "$work/table" --summary "$work/summary" 2>"$work/err" &
    run=$!
    sleep 0.7
    kill -"$signal" $run
    wait $run
    status=$?
    if [ $status -eq 1 ] && [ ! -e "$work/summary" ] &&
        [ "$(wc -l <"$work/err")" -eq 1 ] && awk '
            /^# [0-9]/ { columns = $2 }
            !/^#/ { rows++; bad += NF != columns }
            END { exit !(rows > 0 && bad == 0) }' "$work/table"; then
        ok "$what"
    else
        not_ok "$what" "status $status, $(ls "$work" | tr '\n' ' '): $(
            cat "$work/err")"
    fi
}
stop_run 'TERM ends a run with a whole table' TERM \
    --preset random --until 1e9 --every 10000
stop_run 'so it does with one of many bodies' TERM \
    --preset random --particles 20000 --until 1e6
stop_run 'and with the naive engine' TERM \
    --preset random --particles 2000 --engine naive --until 1e6
stop_run 'TERM ends an ensemble with those that are done' TERM \
    --preset random --ensemble 1e6 --until 100 --every 50
holds 'no temporary is left' test "$(ls -A "$work" | tr '\n' ' ')" = \
    "collapse err out said sum table touching "

# All fly apart, the clock has no end, and rows are asked for: either it is
# done or it is refused, but not a table without end.
ends() { # NAME OPTION...
    what=$1
    shift
    (ulimit -f 20000 && timeout 10 $b "$@" -o "$work/apart") \
        >"$work/said" 2>&1
    status=$?
    if [ $status -eq 0 ] || [ $status -eq 2 ]; then ok "$what"; else
        not_ok "$what" "status $status: $(head -c 200 "$work/said")"; fi
}
ends 'rows of a run in which nothing happens any more' \
    --preset galperin --every 1
ends 'rows up to a collision that does not come' \
    --preset galperin --every 1 --collisions 1000

# Memory: at most 108 bytes a particle more than a small run takes. They are
# 32 for the start, 32 for the body, 24 for what it was before the slabs under
# way, 8 each for the time and the fraction of a gap, and 4 for its place in
# the heap; the start is freed before a row takes 24.
runs_in() { # KIBIBYTES PARTICLES
    (ulimit -v "$1" && $b --preset random --particles "$2" --until 0.5 \
        -o "$work/large") >"$work/said" 2>&1
}
least=2000
while [ $least -lt 20000 ] && ! runs_in $least 1000; do
    least=$((least + 500))
done
if runs_in $((least + 105469)) 1000000; then
    ok 'a million bodies take 108 bytes each'
else
    not_ok 'a million bodies take 108 bytes each' \
        "not in $least + 105469 KiB: $(head -c 200 "$work/said")"
fi
(ulimit -v 60000 && $b --preset random --particles 1000000 -o "$work/none") \
    >"$work/said" 2>"$work/err"
status=$?
if [ $status -eq 1 ] && [ "$(wc -l <"$work/err")" -eq 1 ] &&
    grep -q 'no memory' "$work/err"; then
    ok 'too little memory is said in one line'
else
    not_ok 'too little memory' "status $status: $(cat "$work/err")"
fi
holds '--help' sh -c "$b --help | grep -q -- --restitution"
holds '--version' sh -c "$b --version | grep -q '^bonkers (Bonkers)'"
holds "the studies' --help" sh -c "$s --help | grep -q -- --study"

# Rows without end.
refuses 2 'every: 4.94066e-324 s makes more than 9e15 rows in 30 s' \
    build/bin/bonkers --preset mixed --every 5e-324 --until 30
refuses 2 'makes more than 9e15 rows' \
    build/bin/bonkers --every 5e-324 --collisions 10
build/bin/bonkers --every 5e-324 --samples 2 -o "$work/few"
holds 'but three of them are three' \
    test "$(grep -vc '^#' "$work/few")" -eq 3
# What cools ends before squares of its speeds are no numbers, and says so
# (found by a trial of the second edition: it ended without a word).
for engine in naive scan heap slab; do
    refuses 1 'too cold to go on: .* s after 7468 collisions' \
        build/bin/bonkers --restitution 0.9 --engine $engine \
        --collisions 300000 -o /dev/null
done
refuses 2 'velocities: the fastest has 1e-160 m/s' build/bin/bonkers \
    --walls 0,1 --masses 1 --positions 0.5 --velocities 1e-160
refuses 1 'the next collision is later than any number' build/bin/bonkers \
    --walls=-1e300,1e300 --masses 1,1 --positions 0.5,0.6 \
    --velocities 1e-20,0 --collisions 10 -o /dev/null
echo 1..80
