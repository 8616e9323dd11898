#!/bin/sh
# Bad commands, unwritable files and a full disk: one clear line, the right
# status, nothing half-written.
. tests/programs/common
bin=build/bin
c=$bin/collide
f=$bin/collide-forms

refuses 2 "'ten' is not a whole number from 1 to" $c --tests ten
refuses 2 "'-3' is not a whole number" $c --tests -3
refuses 2 "'0' is not a whole number" $c --tests 0
refuses 2 "'1.5' is not a whole number" $c --tests 1.5
refuses 2 "'' is not a whole number" $c --tests ''
refuses 2 "'99999999999999999999' is not" $c --seed 99999999999999999999
refuses 2 "velocitys" $c --velocitys 1,2
refuses 2 "stray" $c stray
refuses 2 "tests" $c --tests
refuses 2 "restitution: '2'" $c --restitution 2
refuses 2 "restitution: 'nan'" $c --restitution nan
refuses 2 "'best'.*smaller" $c --form best
refuses 2 "dimensions: '4'" $c --dimensions 4
refuses 2 "mass-ratio: '0.5'" $c --mass-ratio 0.5
refuses 2 "need each other" $c --velocities 1,0
refuses 2 "need each other" $c --inverse-masses 1,0
refuses 2 "two walls" $c --velocities 1,0 --inverse-masses 0,0
refuses 2 "each 0 or from" $c --velocities 1,0 --inverse-masses 1,-1
refuses 2 "each 0 or from" $c --velocities 1,0 --inverse-masses 1e-310,1
refuses 2 "beyond 1e150" $c --velocities 1e308,0 --inverse-masses 1,0
refuses 2 "is zero" \
    $c --velocities 1,0 --inverse-masses 1,1 --normal 0,1 --normal 0
refuses 2 "expected two" $c --velocities 1,0 --inverse-masses 1
refuses 2 "expected 2 " $c --velocities 1,0,2 --inverse-masses 1,1
refuses 2 "'x'" $c --velocities 1,x --inverse-masses 1,1
refuses 2 "expected 4 " $c --velocities 1,0 --inverse-masses 1,1 --normal 1,1
refuses 2 "line of centres" \
    $c --velocities 1,0,0,0 --inverse-masses 1,1 --normal 0,0
refuses 2 "both go to" $c --summary -
refuses 2 "both go to" $c --summary "$work/x" -o "$work/x"
refuses 2 "study" $f
refuses 2 "'speed'" $f --study speed
refuses 2 "collisions" $f --study drift --collisions -1
refuses 2 "ratio" $f --study rounding --mass-ratio 0.1

refuses 1 "nowhere/out" $c -o "$work/nowhere/out"
refuses 1 "nowhere/sum" $c --summary "$work/nowhere/sum"
refuses 1 "nowhere/out" $f --study map -o "$work/nowhere/out"
mkdir "$work/folder"
refuses 1 "folder" $c -o "$work/folder"
holds 'nothing is left of refused files' \
    test "$(ls "$work" | tr '\n' ' ')" = "err folder out "
if [ -w /dev/full ]; then
    refuses 1 "No space left" $c -o /dev/full
    refuses 1 "No space left" $f --study drift --summary /dev/full
fi

# Full disk for one file: the other keeps its old content.
echo old >"$work/keep"
$c --summary "$work/keep" -o /dev/full 2>/dev/null
holds 'a failed run leaves the older summary' grep -q old "$work/keep"

holds 'no temporary is left' test "$(ls -A "$work" | tr '\n' ' ')" = \
    "err folder keep out said "
holds '--help' sh -c "$c --help | grep -q -- --restitution"
holds '--version' sh -c "$c --version | grep -q '^collide (Bonkers)'"
echo 1..43
