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
echo 1..9
