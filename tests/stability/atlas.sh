#!/bin/sh
# All maps of chapter 12, as the book has them: each pick holds its tolerance against the
# truth, none costs more than 1.13 times the cheapest that holds, nothing is
# refused that could be had, and looking is bounded.
. tests/programs/common
data=build/data/12-atlas.dat
maps() { awk -v want="$1" -f plots/atlas.awk $data; }
key() { sed -n "s/^$1 //p" "$work/keys"; }
is() { awk "BEGIN { exit !($1) }"; }

# The truth itself is known to a hundredth of the smallest tolerance: by how
# much two ways to find it differ.
holds 'the maps are made' ${MAKE:-make} $data
holds 'what is true is known' awk '/^#= unsure [0-9]/ && $3 < 1e-11 { known = 1 }
    END { exit !known }' $data
maps keys >"$work/keys"
holds '24 scenes and one, at three tolerances' test "$(key asked)" = 75
# At a millionth the run of the four disks happens to be right, to 3.4e-8, but
# rounding could have made it wrong by 1.06e-6, and is not trusted.
maps wrong | grep -v '^four-disks-6 is refused' >"$work/wrong"
holds 'no pick is wrong' test ! -s "$work/wrong"
cat "$work/wrong"

# These eight are refused, and may be granted; nothing else is.
maps refused | grep -vxE 'four-(disks-[69]|late-[369])|gas-[69]|brownian-9' \
    >"$work/refused"
holds 'nothing is refused but these' test ! -s "$work/refused"
cat "$work/refused"

# What the map of the four disks shows: 1e-9 is beyond the horizon.
h=$(key four-disks-9_horizon)
holds 'a horizon is a pick' is "${h:-9} > 1 && ${h:-9} < 4"

# Looking, by the price list: no short run has more than 0.1 s of it, the
# longer ones, which are three, a median of nine times themselves (one of them
# the twin that tells how near the floor of rounding is), and all
# together twice what halving the classic method's step would have cost.
maps slow >"$work/slow"
holds 'no run under 10 ms is looked at for 0.1 s' test ! -s "$work/slow"
cat "$work/slow"
holds 'longer runs: looking costs at most nine times as much, median' \
    is "$(key times) <= 9"
spent=$(key deciding)
ran=$(key running)
holds 'all in all at most twice the classic methods' \
    is "$spent + $ran <= 2 * $(key classic)"

# Each unit of the price list has a run that measures it.
build/bin/bonk-studies --study prices >"$work/prices"
holds 'all prices are measured' awk '!/^#/ { n += $3 ~ /[0-9]/ }
    END { exit !(n == 19) }' "$work/prices"
echo 1..10
