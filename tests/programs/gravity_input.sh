#!/bin/sh
# What gravity-studies refuses, and what it says; how a signal ends it; the
# same bytes for any number of threads.
. tests/programs/common
g=build/bin/gravity-studies
refuses 2 'study is needed' $g
refuses 2 'is not' $g --study nothing
refuses 2 'orbits' $g --study work --orbits -1
refuses 2 'factor' $g --study ring --factor nan
refuses 2 'moon' $g --study ring --moon 1
refuses 2 'mixed' $g --study ring --mixed 1.5
refuses 2 'kernel' $g --study ring --kernel fast
refuses 2 'seed' $g --study ring --seed -1
build/bin/scene ring --particles 998 -o "$work/less" # bodies: one more
build/bin/scene ring --particles 999 -o "$work/ring"
fewer=0
for kernel in auto portable avx512; do
    step="build/bin/step $work/ring --until 40 --every 40 --kernel $kernel"
    $step -o "$work/1" 2>"$work/why" || {
        holds "no $kernel: it says so" grep -q "no $kernel" "$work/why"
        fewer=$((fewer + 1))
        continue
    }
    $step --threads 2 -o "$work/2" --summary "$work/s"
    holds "$kernel: a thousand bodies are shared" \
        grep -qx 'threads 2' "$work/s"
    holds "$kernel: two threads, the same bytes" cmp "$work/1" "$work/2"
    $g --study ring --orbits .02 --kernel $kernel -o "$work/1"
    holds "$kernel is named in the head" grep -q "^# kernel $kernel" \
        "$work/1"
done
build/bin/step "$work/less" --until 8 --threads 2 -o "$work/2" \
    --summary "$work/s"
holds 'fewer are not' grep -qx 'threads 1' "$work/s"
echo "1..$((18 - 2 * fewer))"
