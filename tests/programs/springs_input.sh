#!/bin/sh
# Bad commands of springs-studies, and scenes of springs that cannot be.
. tests/programs/common
s=build/bin/springs-studies
g=build/bin/scene

refuses 2 "study is needed" $s
refuses 2 "'drum'" $s --study drum
refuses 2 "until: '0'" $s --study membranes --until 0
refuses 2 "both go to" $s --study path --summary -
refuses 2 "nx: '2'" $g membrane --nx 2
refuses 2 "diagonals: '3'" $g cantilever --diagonals 3
refuses 2 "nx: '2.5'" $g cantilever --nx 2.5
refuses 2 "mass1: '0'" $g double-pendulum --mass1 0
refuses 2 "turned over" $g oscillator --displacement -5
# Ten thousand bodies are shared among threads, to the same bytes.
$g membrane --nx 100 --ny 100 -o "$work/large"
$g membrane --nx 100 --ny 99 -o "$work/less"
for scene in large less; do
    build/bin/step "$work/$scene" --until .1 --observe z:5050 \
        --threads 1 -o "$work/$scene.1"
    build/bin/step "$work/$scene" --until .1 --observe z:5050 \
        --threads 2 -o "$work/$scene.2" --summary "$work/$scene.s"
    holds "$scene: the same bytes" cmp "$work/$scene.1" "$work/$scene.2"
done
holds 'ten thousand are shared' grep -qx 'threads 2' "$work/large.s"
holds 'fewer are not' grep -qx 'threads 1' "$work/less.s"
echo 1..13
