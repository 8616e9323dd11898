#!/bin/sh
# The first twenty requests of make hunt KIND=floor, whose tolerances are near
# the smallest that bonk grants: no table is wrong, and at twice the floor and
# more nothing is refused.
. tests/programs/common
tools=build/tests/hunt
holds 'the hunt is made' ${MAKE:-make} -s build/bin/bonk $tools/generate \
    $tools/truth $tools/truth-fast
holds 'no table is wrong' sh -c "tests/hunt/run -n 20 -s 1 floor >$work/report"
holds 'at twice the floor and more all are answered' awk '
    / at twice the floor and more were answered$/ { all = $1 == $3 && $1 > 5 }
    END { exit !all }' "$work/report"
cat "$work/report"
echo 1..3
