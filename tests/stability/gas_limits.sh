#!/bin/sh
# Where a gas fails, chapter 7. Each case must go on failing as the chapter
# says it does.
. tests/programs/common
d=build/bin/disks

# says NAME CONDITION: an awk expression of the last summary, s["key"].
says() {
    holds "$1" awk "{ s[\$1] = \$2 } END { for (k in s) print k, s[k]; exit !($2) }" "$work/s"
}

# A crystal without a fault is still there after the usual warm-up, with a
# small error bar: one fifth too low. With six places empty it melts.
spheres="$d --dimensions 3 --packing 0.49 --boundary periodic -o /dev/null"
$spheres --disks 256 --collisions 20000 --summary "$work/s"
says 'a lattice of 256 spheres does not melt' \
    's["Z_virial"] < 10.5 && s["Z_virial_error"] < 0.3'
$spheres --disks 250 --collisions 20000 --summary "$work/s"
says 'one of 250 does' 's["Z_virial"] > 11.8 && s["Z_virial"] < 12.5'

# Crystals that melt while they are averaged, within the first third of the
# run and later: both are reported.
spheres="$d --dimensions 3 --disks 500 --boundary periodic -o /dev/null"
for melting in '0.48 --until 30' '0.4917 --until 200'; do
    # shellcheck disable=SC2086
    $spheres --warmup 10 --packing $melting --summary "$work/s" 2>"$work/note"
    says "a crystal at $melting melts: a drift" 's["drift"] > 6'
    holds 'and a note of one line' awk '
        /^disks: note: .* a higher Z_virial than the first, by / { ++notes }
        END { print; exit !(NR == 1 && notes == 1) }' "$work/note"
done
# Fluids at 0.30, twenty seeds each, from a lattice and thrown: of 160 drifts
# not one is as large as 6 by chance, but for one gate in 130.
for start in lattice random; do
    for seed in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
        for gas in '--disks 100' '-D 3 --disks 64 --boundary periodic'; do
            # shellcheck disable=SC2086
            $d $gas --packing 0.30 --start $start --seed $seed -o /dev/null \
                --summary "$work/s" 2>>"$work/steady" &&
                cat "$work/s" >>"$work/fluids"
        done
    done
done
holds 'a fluid at 0.30 is steady' awk '$1 == "drift" { ++n; z = $2 < 0 ? -$2 : $2
        if (z > most) most = z }
    END { print n, "drifts, up to", most; exit !(n == 80 && most < 6) }' \
    "$work/fluids"
holds 'and nothing is said of it' sh -c "cat \"$work/steady\"; test ! -s \"$work/steady\""

# Near freezing an equation that knows no crystal goes on.
$d --disks 480 --packing 0.70 --boundary periodic --warmup 500 \
    --collisions 200000 -o /dev/null --summary "$work/s"
says "Henderson's 11.79 at packing 0.70 is far too high" \
    's["Z_virial"] < 10.7 && s["Z_virial"] > 9'
# A crystal presses less than the fluid at a lower packing.
$d --disks 480 --packing 0.72 --boundary periodic --warmup 500 \
    --collisions 100000 -o /dev/null --summary "$work/s"
cp "$work/s" "$work/crystal"
$d --disks 480 --packing 0.69 --boundary periodic --warmup 500 \
    --collisions 100000 -o /dev/null --summary "$work/s"
holds 'the pressure falls where it freezes' awk '$1 == "Z_virial" {
    z[++n] = $2 } END { print z[1], z[2]; exit !(z[2] > z[1]) }' \
    "$work/crystal" "$work/s"

# The correlation of a heavy disk begins as Langevin wants and stays above.
$d --disks 400 --radius 0.5 --heavy 40,2 --start random --temperature 1 \
    --box 39.79149,39.79149 --boundary periodic --warmup 5 \
    --measure brownian --every 0.5 --until 3000 -o "$work/b"
holds 'the gas remembers longer than friction does' awk '!/^#/ {
        if (!n++) c = $2
        r = $2 / c / exp(-0.00303 / 0.02273 * $1)
        if ($1 == 0.5) early = r
        if ($1 > 7 && $1 < 10) { late += r; ++m } }
    END { late /= m; print early, late
        exit !(early > 0.99 && early < 1.01 && late > 1.1) }' "$work/b"

# There and back: home after 7 collisions of each, lost after 27.
home() { # TIME
    $d --disks 1000 --packing 0.3 --boundary periodic --warmup 10 \
        --every "$1" --samples 1 -o "$work/there"
    awk -v OFMT=%.17g '/^# box/ { print } !/^#/ && NF && $1 {
        print 0, $2, $3, $4, $5, $6, -$7, -$8 }' "$work/there" >"$work/turned"
    $d --start "$work/turned" --every "$1" --samples 1 -o "$work/back"
    awk '/^# box/ { L = $3; M = $4 } /^#/ || !NF { next }
        NR == FNR && $1 == 0 { x[$2] = $5; y[$2] = $6 }
        NR > FNR && $1 > 0 { a = $5 - x[$2]; b = $6 - y[$2]
            a -= L * int(2 * a / L); b -= M * int(2 * b / M)
            s += a * a + b * b }
        END { print sqrt(s / 1000) }' "$work/there" "$work/back"
}
holds 'a thousand disks come home after 4 s' \
    awk -v off="$(home 4)" 'BEGIN { print off; exit !(off < 1e-8) }'
holds 'and do not after 16 s' \
    awk -v off="$(home 16)" 'BEGIN { print off; exit !(off > 0.05) }'
echo 1..13
