#!/bin/sh
# Twenty requests of make hunt KIND=floor, whose tolerances are near the
# smallest that bonk grants: no table is wrong, nor more so than was found, and
# at twice the floor and more nothing is refused. With one twin as the bound of
# an error the tenth was off by twice what was found, and the last was wrong.
. tests/programs/common
tools=build/tests/hunt
holds 'the hunt is made' ${MAKE:-make} -s build/bin/bonk $tools/generate \
    $tools/truth $tools/truth-fast
holds 'no table is wrong' sh -c "tests/hunt/run -n 20 -s 31 floor >$work/report"
holds 'nor more than was found' grep -q '^ *0 are, but bonk' "$work/report"
holds 'at twice the floor and more all are answered' awk '
    / at twice the floor and more were answered$/ { all = $1 == $3 && $1 > 5 }
    END { exit !all }' "$work/report"
cat "$work/report"
echo 1..4
