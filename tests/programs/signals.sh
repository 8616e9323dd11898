#!/bin/sh
# A run that is told to stop is gone in seconds, long before whoever told it
# loses patience; its table is there, and no temporary file beside it.
. tests/programs/common

# begun PID PROGRAM: the process is that program, and has worked for a tenth of a
# second, or waits for something.
begun() {
    [ "$(readlink "/proc/$1/exe")" -ef "$2" ] &&
        awk '{ exit $3 != "S" && $14 < 10 }' "/proc/$1/stat"
}
# told SIGNAL STATUS FILES COMMAND...: so it ends, with these files.
told() {
    number=$1 want=$2 files=$3
    shift 3
    rm -rf "$work/folder"
    mkdir "$work/folder"
    "$@" -o "$work/folder/table" --summary "$work/folder/summary" \
        >"$work/out" 2>&1 &
    run=$!
    # On a machine with much to do it takes a while until a program has begun.
    tenth=0
    while [ -e "/proc/$run/exe" ] && [ $((tenth += 1)) -lt 600 ] &&
        ! begun $run "$1"; do
        sleep 0.1
    done
    sleep 0.2
    kill -0 "$run" 2>/dev/null || not_ok "$*" 'it was done before it was told'
    kill "-$number" "$run"
    tenth=0
    while [ $((tenth += 1)) -lt 150 ] && kill -0 "$run" 2>/dev/null; do
        sleep 0.1
    done
    kill -9 "$run" 2>/dev/null
    wait "$run" 2>/dev/null
    got=$?
    found=$(echo $(ls "$work/folder"))
    if [ "$got" -eq "$want" ] && [ "$found" = "$files" ]; then
        ok "$* stops at a $number"
    else
        not_ok "$* at a $number" "status $got, not $want; left: '$found'"
    fi
}

bin=build/bin
told TERM 1 table $bin/collide --tests 1000000000
told TERM 1 table $bin/bonkers --preset thermal --until 1e8
told TERM 1 table $bin/bonkers-studies --study drift --collisions 1000000000
told TERM 1 table $bin/disks --disks 20000 --packing 0.3 --until 1000
told TERM 1 table $bin/disks-studies --study collapse
told TERM 1 table $bin/disks-speed --particles 100 --collisions 1000000000
told TERM 1 table $bin/sample --samples 1000000000
told TERM 1 table $bin/sample-studies --study acceptance --samples 100000000
told TERM 1 table $bin/gravity-studies --study ring
told TERM 1 table $bin/springs-studies --study limits
told TERM 1 table $bin/spheres-studies --study checks
told TERM 1 table $bin/step-studies --study rounding
told TERM 1 table $bin/averages-studies
told HUP 1 table $bin/disks-studies --study collapse
# One that waits for its input and does not listen is ended after a while.
mkfifo "$work/pipe"
sleep 30 >"$work/pipe" &
writer=$!
told TERM 143 '' $bin/piston --study measure --table "$work/pipe"
kill $writer
$bin/scene ring -o "$work/ring.plist"
told TERM 143 '' $bin/bonk "$work/ring.plist" --until 100 --tolerance 1e-3
told TERM 1 'table table.checkpoint table.rows' $bin/step "$work/ring.plist" \
    --until 10000
echo 1..17
