#!/bin/sh
# Cells in every build: gcc and clang, with eight or four neighbours at a time, if
# this machine has the instructions, and one by one: the runs of
# tests/library/cells.c end with the same bytes. (That these are the bytes of
# pairs it finds out itself, in the build that is there.) And the memory that a
# million disks take.
. tests/programs/common
sources='src/box/cells.c src/box/calendar.c src/box/disks.c src/box/meet.c
    src/box/meetings.c src/box/walls.c src/box/falling.c src/box/collapse.c src/box/starts.c src/box/heat.c
    src/line/collide.c src/line/fall.c src/toolbox/random.c'

expected=
# The test's own code runs for less time than a compiler would work on it.
for cc in gcc clang; do
    $cc -std=c11 -D_POSIX_C_SOURCE=200809L -O0 -ffp-contract=off -Isrc -Itests \
        -c -o "$work/test.o" tests/library/cells.c
    for level in '-O2' '-O3 -DVECTOR_PLAIN'; do
        # shellcheck disable=SC2086
        $cc -std=c11 -D_POSIX_C_SOURCE=200809L -ffp-contract=off $level \
            -Isrc -o "$work/cells" "$work/test.o" $sources \
            -lcunit -lm || not_ok "$cc $level" 'does not compile'
        "$work/cells" bytes >"$work/said" 2>&1
        got=$(sed -n 's/^[a-z0-9]* \([0-9a-f]\{16\}\)$/\1/p' "$work/said")
        kernel=$(sed -n 's/^\([a-z0-9]*\) [0-9a-f]\{16\}$/\1/p' "$work/said")
        expected=${expected:-$got}
        if grep -q '^not ok' "$work/said"; then
            not_ok "$cc $level" "$(grep '^not ok' "$work/said" | head -1)"
        elif [ -z "$got" ] || [ "$got" != "$expected" ]; then
            not_ok "$cc $level" "bytes $got, expected $expected"
        else
            ok "$cc $level, $kernel: the same bytes"
        fi
    done
done

# Memory, more than a small run takes: dense disks have thin skins and
# few in a cell, thin ones need longer lists.
runs_in() { # KIBIBYTES PARTICLES OPTION...
    most=$1 particles=$2
    shift 2
    (ulimit -v "$most" && build/bin/disks-speed --particles "$particles" \
        --collisions 1000 "$@" -o "$work/table") >"$work/said" 2>&1
}
takes() { # BYTES OPTION...
    bytes=$1
    shift
    least=2000
    while [ $least -lt 20000 ] && ! runs_in $least 100 "$@"; do
        least=$((least + 500))
    done
    if runs_in $((least + bytes * 1000000 / 1024)) 1000000 "$@"; then
        ok "$*: a million take $bytes bytes each"
    else
        not_ok "$*: a million take $bytes bytes each" \
            "$(head -c 200 "$work/said")"
    fi
}
takes 250 --dimensions 2 --packing 0.7
takes 250 --dimensions 3 --packing 0.49
takes 250 --dimensions 2 --packing 0.3
takes 250 --dimensions 3 --packing 0.3

# What each step of the chapter has bought: four rows, each a speed.
build/bin/disks-speed --steps --particles 200 --collisions 300 \
    -o "$work/steps" >"$work/said" 2>&1
rows=$(grep -cE '^(pairs|neighbours|calendar|lanes) [0-9.e+-]+$' "$work/steps")
if [ "$rows" -eq 4 ]; then
    ok 'disks-speed --steps: four steps, four speeds'
else
    not_ok 'disks-speed --steps: four steps, four speeds' "$rows rows"
fi
echo 1..9
