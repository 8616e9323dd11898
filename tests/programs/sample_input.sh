#!/bin/sh
# Bad commands and boxes that cannot be: one clear line, the right status.
. tests/programs/common
s=build/bin/sample
t=build/bin/sample-studies

refuses 2 "'fly'" $s --method fly
refuses 2 'chains need --boundary periodic' $s --method chains
refuses 2 'small: means nothing' $s --method chains --boundary periodic --small 0.1,3
refuses 2 "disks: '0'" $s --disks 0
refuses 2 "radius: '0'" $s --radius 0
refuses 2 "box: '1', expected two or three" $s --box 1
refuses 2 "box: '1,-1', expected" $s --box 1,-1
refuses 2 "box: '1,1,1,1'" $s --box 1,1,1,1
refuses 2 "small: '0.1', expected" $s --small 0.1
refuses 2 "small: '0.1,1.5', expected" $s --small 0.1,1.5
refuses 2 "step: '0'" $s --step 0
refuses 2 "stray" $s stray
refuses 2 "both go to" $s --summary -

# No room.
refuses 2 "box: a side of 1 has no room for a radius of 0.5" $s --radius 0.5
refuses 2 "box: a side of 1 has no room for a radius of 0.6" \
    $s --small 0.6,1
refuses 2 "a periodic one must be at least four radii" \
    $s --boundary periodic --radius 0.26
refuses 2 "would fill 1.131 of the box" $s --disks 16
refuses 2 "no packing fills more than 0.7405" \
    $s --disks 9 --radius 0.29 --box 1.2,0.9,0.8 --method markov
refuses 1 "no start found for 4 disks of radius 0.251" \
    $s --method markov --radius 0.251 -o "$work/none"
holds 'and no table is left' test ! -e "$work/none"

# Direct sampling that would never end.
refuses 2 "direct would need more than 10^18 throws; use markov" \
    $s --disks 30 --box 2,2

refuses 1 "nowhere/out" $s -o "$work/nowhere/out"
refuses 2 "radii: 0.6, expected" $t --radii 0.1,0.6
refuses 2 "step: 1, expected" $t --step 0.1,1
refuses 2 "study" $t --study sleep
refuses 1 "radii: 0.26 leaves no room" $t --study memory --radii 0.26
refuses 2 "both go to" $t --study memory --summary -
refuses 2 "study is needed" $t

# What cannot be thrown is refused, or given up after a hundred million
# throws in a row.
refuses 2 'have no room between these walls' $s --disks 2 --radius .3
refuses 2 'have no room between these walls' $s --disks 4 --radius .26
refuses 2 'have no room between these walls' \
    $s --disks 2 --radius .4 --box 1,1,1
refuses 1 'nothing fitted in 1e+08 throws in a row; use --method markov' \
    $s --radius .25 --samples 1
echo 1..32
