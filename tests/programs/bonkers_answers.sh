#!/bin/sh
# What bonkers prints: exact counts, rows at exact times, the same bits from
# every engine, the mean of an ensemble. Reference values were computed for
# this book.
. tests/programs/common
b=build/bin/bonkers

rows() { grep -v '^#' "$1"; }
# value FILE KEY: of a summary
value() { awk -v key="$2" '$1 == key { print $2 }' "$1"; }

# equal NAME GOT EXPECTED
equal() {
    if [ "$2" = "$3" ]; then ok "$1"; else not_ok "$1" "'$2', not '$3'"; fi
}

# Under gravity: a bead let go from 5 m falls for 1 s at 10 m/s2, and after
# the bounce, another second later, stands there again. Engines that claim the same trajectory have the same bytes.
$b --masses 2 --positions 5 --walls 0 --gravity 10 --every 0.5 --until 2 \
    -o "$work/t" --summary "$work/s"
equal 'a bead falls, bounces and rises' \
    "$(rows "$work/t" | cut -d' ' -f2,5,6 | tr '\n' ';')" \
    '100 5 0;100 3.75 -5;100 0 10;100 3.75 5;100 5 0;'
equal 'it has bounced once' "$(value "$work/s" collisions)" 1
for e in scan heap slab; do
    $b --preset random --particles 40 --gravity 3 --every 1 --until 20 \
        --engine "$e" -o "$work/$e" --summary "$work/s"
    near=$(awk '$1 == "energy_error" { print ($2 < 1e-12 && $2 > -1e-12) }' \
        "$work/s")
    equal "$e keeps the energy of what falls" "$near" 1
done
for e in heap slab; do
    holds "scan and $e write the same bytes under gravity" \
        cmp "$work/scan" "$work/$e"
done

# What is given at rest on the floor stays there, elastic or not.
for e in 1 0.5; do
    $b --masses 2,1 --positions 0,0 --velocities 0,0 --walls 0 --gravity 10 \
        --restitution $e --every 1 --until 2 -o "$work/t" --summary "$work/s"
    equal "what lies on the floor stays there ($e)" \
        "$(rows "$work/t" | cut -d' ' -f2,5-8 | tr '\n' ';')" \
        '0 0 0 0 0;0 0 0 0 0;0 0 0 0 0;'
done

# Rows at whole multiples of the interval, and the last at the end: the third
# of three times 0.1 is 0.3, not a fourth row.
$b --until 0.3 --every 0.1 -o "$work/t"
equal 'times of four rows' "$(rows "$work/t" | cut -d' ' -f1 | tr '\n' ' ')" \
    '0 0.10000000000000001 0.20000000000000001 0.29999999999999999 '
$b --until 1 --every 0.3 -o "$work/t"
equal 'the last row is at the end' \
    "$(rows "$work/t" | cut -d' ' -f1 | tr '\n' ' ')" \
    '0 0.29999999999999999 0.59999999999999998 0.89999999999999991 1 '
$b --every 0.1 --samples 30000 -o "$work/t" --summary "$work/s"
holds 'row k is at k times 0.1, to the last bit' sh -c "grep -v '^#' \
    '$work/t' | awk '{ if (\$1 != NR - 1 && sprintf(\"%.17g\", (NR - 1) * 0.1) \
        != \$1) exit 1 } END { exit NR != 30001 }'"
equal 'the summary counts the rows behind the first' \
    "$(value "$work/s" samples)" 30000
holds 'no row out of order, walls where they were' sh -c "grep -v '^#' \
    '$work/t' | awk '{ if (\$3 != 0 || \$13 != 5 || \$4 != 0 || \$14 != 0 ||
        \$5 < 0.1 - 1e-15 || \$7 - \$5 < 0.2 - 2e-15 ||
        \$9 - \$7 < 0.2 - 2e-15 || \$11 - \$9 < 0.2 - 2e-15 ||
        \$11 > 4.9 + 2e-15) exit 1 }'"
$b --every 7 --until 20 --samples 2 -o "$work/t"
equal 'the number of samples may come first' "$(rows "$work/t" | tail -1 |
    cut -d' ' -f1)" 14
$b -o "$work/t" --summary "$work/s"
equal 'four runs for 50 s and gives its first row and its last' \
    "$(rows "$work/t" | cut -d' ' -f1 | tr '\n' ' ')" '0 50 '
for key in collisions samples time energy_error engine \
    collisions_per_second order_violations; do
    holds "the summary has $key" grep -q "^$key [^ ]*$" "$work/s"
done
equal 'the first row is the start' "$(rows "$work/t" | head -1)" \
    '0 518.45000000000005 0 0 1 1 2 2 3 3 4 4 5 0'
$b --until 0 -o "$work/t"
equal 'a run for 0 s ends where it starts' "$(rows "$work/t" | tail -1)" \
    '0 518.45000000000005 0 0 1 1 2 2 3 3 4 4 5 0'

# Two bodies, by hand: masses 1 and 3 meet at 2 m after 1 s and have the
# velocities -2 and 0; the first is at 0 a second later, and at the end at 1.
$b --masses 1,3 --positions 1,3 --velocities 1,-1 --walls 0,4 --every 1 \
    --until 2.5 -o "$work/t"
equal 'two bodies by hand' "$(rows "$work/t" | cut -d' ' -f1,2,5-8 | tr '\n' /)" \
    '0 2 1 1 3 -1/1 2 2 -2 2 0/2 2 0 2 2 0/2.5 2 1 2 2 0/'

# Sampling and engines change no bit of the last row.
last() { "$b" "$@" -o "$work/last" && rows "$work/last" | tail -1; }
for preset in four mixed cradle thermal piston two random; do
    plain=$(last --preset $preset --until 20 --engine scan)
    for engine in scan heap slab; do
        equal "$preset, $engine: rows or none, the same last row" \
            "$(last --preset $preset --until 20 --engine $engine \
                --every 0.07)" "$plain"
    done
done
for wish in '--preset galperin --mass-ratio 1e4' '--preset galperin' \
    '--preset adiabatic --until 3' \
    '--preset random --particles 500 --collisions 7001' \
    '--preset random --particles 500 --restitution 0.9 --until 3' \
    '--preset cradle --walls 0' '--preset mixed --walls 0 --collisions 99'; do
    # shellcheck disable=SC2086
    {
        scan=$(last $wish --engine scan 2>/dev/null)
        heap=$(last $wish --engine heap 2>/dev/null)
        slab=$(last $wish --engine slab 2>/dev/null)
    }
    equal "$wish: heap as scan" "$heap" "$scan"
    equal "$wish: slab as scan" "$slab" "$scan"
done

# The head names what was asked for, not how it was done.
$b --preset two --until 3 --engine heap -o "$work/t" \
    --summary "$work/s"
equal 'the command in the head' "$(sed -n 's/^# command: //p' "$work/t")" \
    'bonkers --preset two --until 3'
equal 'the engine in the summary' "$(value "$work/s" engine)" heap
equal 'the masses in the head' "$(sed -n 's/^# masses: //p' "$work/t")" '1 9'
equal 'the columns in the head' \
    "$(sed -n 's/^# [0-9]* \([^ ]* [^ ]*\) .*/\1/p' "$work/t" | tr '\n' ' ')" \
    't [s] energy [J] xL [m] vL [m/s] x1 [m] v1 [m/s] x2 [m] v2 [m/s] xR [m] vR [m/s] '
$b --preset random --particles 33 --until 1 -o "$work/t" --summary "$work/s"
equal 'many bodies run in slabs' "$(value "$work/s" engine)" slab
$b --preset random --seed 5 --until 1 -o "$work/t"
$b --preset random --seed 6 --until 1 -o "$work/u"
holds 'another seed, another run' sh -c "! cmp -s '$work/t' '$work/u'"

$b --preset mixed --collisions 1000000 -o "$work/t" --summary "$work/s"
equal 'a million collisions' "$(value "$work/s" collisions)" 1000000
equal 'no body out of order' "$(value "$work/s" order_violations)" 0

# An ensemble: the same bytes on any number of threads.
ensemble() { "$b" --preset piston --ensemble 40 --every 3 --until 20 "$@"; }
ensemble --threads 1 -o "$work/e1" --summary "$work/s"
equal 'members are counted' "$(value "$work/s" members)" 40
for threads in 2 3 16; do
    ensemble --threads $threads -o "$work/e"
    holds "$threads threads give the same ensemble" \
        cmp "$work/e1" "$work/e"
done
equal 'rows of an ensemble' "$(rows "$work/e1" | cut -d' ' -f1 | tr '\n' ' ')" \
    '0 3 6 9 12 15 18 20 '
$b --preset piston --ensemble 2 --every 4 --until 10 --seed 1 -o "$work/e"
# The members' seeds: the first two numbers of xoshiro256** from the seed 1.
$b --preset piston --every 4 --until 10 --seed 12966619160104079557 \
    -o "$work/m1"
$b --preset piston --every 4 --until 10 --seed 9600361134598540522 \
    -o "$work/m2"
for name in e m1 m2; do rows "$work/$name" >"$work/$name.rows"; done
# Columns of a single run: 3 + 2 i and 4 + 2 i; of an ensemble: 3 + 4 i on.
# Two members: the standard error of T is half the difference.
cat >"$work/means" <<'EOF'
function near(a, b, scale) {
    return a - b <= 8e-16 * scale && b - a <= 8e-16 * scale
}
{
    split($0, e)
    if ((getline first <one) <= 0 || (getline second <two) <= 0)
        bad++
    split(first, p)
    split(second, q)
    n = split(mass, m)
    energy = 0
    for (i = 0; i <= n + 1; i++) {
        inside = i > 0 && i <= n
        tp = inside ? m[i] * p[4 + 2 * i] ^ 2 / 2 : 0
        tq = inside ? m[i] * q[4 + 2 * i] ^ 2 / 2 : 0
        d = tp > tq ? (tp - tq) / 2 : (tq - tp) / 2
        k = 3 + 4 * i
        energy += (tp + tq) / 2
        bad += !near(e[k], (p[3 + 2 * i] + q[3 + 2 * i]) / 2, 12)
        bad += !near(e[k + 1], (p[4 + 2 * i] + q[4 + 2 * i]) / 2, 6)
        bad += !near(e[k + 2], (tp + tq) / 2, 30)
        bad += !near(e[k + 3], d, 30)
        count += d > 0.01
    }
    bad += e[1] != p[1] || e[1] != q[1] || !near(e[2], energy, 300)
}
END { exit !(bad == 0 && NR == 4 && count > 10) }
EOF
holds 'an ensemble of two is the mean of its two members' \
    awk -v one="$work/m1.rows" -v two="$work/m2.rows" \
    -v mass="$(sed -n 's/^# masses: //p' "$work/m1")" \
    -f "$work/means" "$work/e.rows"
holds 'masses come back as they were given' test '# masses: 49 98 0.1' = \
    "$(build/bin/bonkers --masses 49,98,0.1 --positions 1,2,3 \
        --velocities 1,0,0 --walls 0,4 --every 1 --until 1 | sed -n 4p)"
echo 1..76
