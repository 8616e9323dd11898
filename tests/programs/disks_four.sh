#!/bin/sh
# The four disks of chapter 5, as the program disks tells of them, against
# direct sampling (plots/data/disks4_r0.15_unitbox.dat, computed for this
# book by a program of its own) and the law of their velocities.
. tests/programs/common
d='build/bin/disks --disks 4 --radius 0.15 --box 1,1'
$d --every 0.01 --samples 1000000 --measure positions -o "$work/table" \
    --summary "$work/s"

# Each bin by its own error: chi2 of 70 values, but for correlations between
# bins; the density is mirrored, so x and y give 140 values.
holds 'positions: those of direct sampling' awk '
    NR == FNR { if (!/^#/) p[int($1 * 100 + 0.5)] = $3; next }
    !/^#/ && int($1 * 100 + 0.5) in p { k = int($1 * 100 + 0.5)
        for (c = 2; c <= 4; c += 2) { n++
            z = ($c - p[k]) / $(c + 1); chi2 += z * z
            if (z * z > worst) worst = z * z } }
    END { print n, chi2, worst; exit !(n == 140 && chi2 < 220 && worst < 25) }' \
    plots/data/disks4_r0.15_unitbox.dat "$work/table"
holds 'positions: none closer to a wall than a radius' awk '
    !/^#/ && ($1 < 0.1499 || $1 > 0.8499) { n++; sum += $2 + $4 }
    END { print n, sum; exit !(n == 30 && sum == 0) }' "$work/table"

# p(r) = 2.69889(31), the virial 1.88928(13), the ratio .776638(150): four
# standard errors of the run and of the reference.
$d --every 1 --until 200000 --measure pressure -o /dev/null \
    --summary "$work/s"
pressure() { # KEY EXPECTED UNCERTAIN
    holds "$1: direct sampling" awk -v key="$1" -v want="$2" -v u="$3" '
        $1 == key { got = $2 } $1 == key "_error" { e = $2 }
        END { d = got - want; print got, e, want
            exit !(e > 0 && e < 0.01 && d * d < 16 * (e * e + u * u)) }' \
        "$work/s"
}
pressure Z_wall_x 2.69889 0.00031
pressure Z_wall_y 2.69889 0.00031
pressure Z_virial 1.88928 0.00013
# sem of the ratio: 0.17 per cent in 2e4 s (own runs), 0.06 in 2e5
holds 'collisions to wall hits: 0.7766' awk '
    $1 == "collisions" { c = $2 } $1 == "wall_collisions" { w = $2 }
    END { r = c / w / 0.776638 - 1; print c / w; exit !(r * r < 0.0025 ^ 2) }' \
    "$work/s"

# Kurtosis 2.4, not 3; no component above 2 m/s; spread 1/sqrt 2.
[ -x build/bin/histogram ] && {
    $d --every 0.1 --samples 30000 --measure states |
        build/bin/histogram --block --column vx,vy --range=-2,2 \
            --law microcanonical:8,2,1 --summary "$work/v" -o /dev/null -
    holds 'velocities: the law of eight components' awk '
        { s[$1] = $2 }
        END { print s["kurtosis_vx"], s["kurtosis_vy"], s["greatest_vx"]
            x = s["kurtosis_vx"] - 2.4; y = s["kurtosis_vy"] - 2.4
            exit !(x * x < 0.01 && y * y < 0.01 && s["greatest_vx"] < 2 &&
                s["law_chi2_probability_vx"] > 1e-4) }' "$work/v"
}

# The whole program of the chapter: it compiles as it stands, and until a
# rounding has grown (e^(3.6 t), 5 s) it goes where disks goes; then its
# places have the same density.
holds 'disks0: compiles alone' "${CC:-cc}" -std=c11 -Wall -Wextra -pedantic \
    -Werror -o "$work/disks0" src/programs/disks0.c -lm
cat >"$work/start" <<'END'
# box 1 1 walls
0 1 1 0.15 0.25 0.25 0.6 0.8
0 2 1 0.15 0.75 0.25 -0.8 0.6
0 3 1 0.15 0.25 0.75 0.28 -0.96
0 4 1 0.15 0.75 0.75 -0.96 -0.28
END
build/bin/disks --start "$work/start" --warmup 0 --every 0.05 --samples 100 \
    --measure states -o "$work/states"
build/bin/disks0 0.05 100 >"$work/rows"
holds 'disks0: where disks goes' awk '
    NR == FNR { if (!/^#/ && NF) { k = int($1 / 0.05 + 0.5)
        want[k, $2 * 2] = $5; want[k, $2 * 2 + 1] = $6 }; next }
    { for (c = 2; c <= 9; ++c) { d = $c - want[FNR - 1, c]; n++
        if (d * d > worst * worst) { worst = d; at = $1 } } }
    END { print n, worst, at; exit !(n == 808 && worst * worst < 1e-8) }' \
    "$work/states" "$work/rows"
build/bin/disks0 0.02 500000 >"$work/rows"
holds 'disks0: the density of direct sampling' awk '
    NR == FNR { if (!/^#/) p[int($1 * 100 + 0.5)] = $3; next }
    { for (c = 2; c <= 9; ++c) ++n[int(($c - 0.15) / 0.05 + 1e-9)] }
    END { for (s = 0; s < 14; ++s) { want = 0
            for (b = 0; b < 5; ++b) want += p[15 + 5 * s + b] / 100
            d = n[s] / 8 / FNR / want - 1
            if (d * d > worst * worst) worst = d }
        print worst; exit !(worst * worst < 0.025 ^ 2) }' \
    plots/data/disks4_r0.15_unitbox.dat "$work/rows"
echo 1..10
