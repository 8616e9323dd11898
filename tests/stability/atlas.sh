#!/bin/sh
# The maps of chapter 12 that are quickly made: each pick holds its tolerance
# against the truth, none is dearer than 1.5 times the cheapest that holds,
# and nothing is refused that could be had. The whole atlas: make atlas.
. tests/programs/common
studies=build/bin/bonk-studies

# The truth itself is known to 1e-11 and better, a hundredth of the smallest
# tolerance: by how much two ways to find it differ.
for scene in cradle heavy-cradle thermal galperin four-disks comet \
    choreography figure-eight oscillator; do
    holds "the map of $scene is made" $studies --study atlas \
        --scene $scene -o "$work/$scene" --summary "$work/s"
    holds "what is true of $scene is known" \
        awk '$1 == "unsure" { exit !($2 ~ /[0-9]/ && $2 < 1e-11) }' "$work/s"
    holds "three right picks for $scene" grep -qx 'good 3' "$work/s"
    grep "^$scene-[369] " plots/data/12-atlas.dat >"$work/kept"
    holds "they are those of the atlas (if not: make atlas)" \
        sh -c "grep '^$scene-[369] ' '$work/$scene' | cmp - '$work/kept'"
done

# What the map of the four disks shows: 1e-9 is beyond the horizon.
holds 'a horizon is a pick' \
    awk '$1 == "four-disks-9" { exit !($2 == "refused" && $14 > 1 &&
        $14 < 4) }' "$work/four-disks"

# All of the committed atlas: asked for at three tolerances, 24 scenes.
awk '/^[a-z-]*-[369] / { ++n
        e = $1 ~ /3$/ ? 1e-3 : $1 ~ /6$/ ? 1e-6 : 1e-9
        if ($2 == "refused" ? $5 != "-" : $3 > e || $7 > 1.5) print
    } END { if (n != 72) print n, "picks" }' plots/data/12-atlas.dat \
    >"$work/wrong"
holds 'the committed atlas has no wrong pick' test ! -s "$work/wrong"
cat "$work/wrong"
echo 1..38
