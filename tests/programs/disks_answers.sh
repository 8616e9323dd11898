#!/bin/sh
# What disks says, against exact results and against references computed
# for this book by programs of its own (direct sampling, another
# event-driven run). A measured number may be 4 standard errors away, its
# own and the reference's; seeds are fixed, so a pass stays a pass.
. tests/programs/summaries
d=build/bin/disks

# within NAME KEY EXPECTED ERROR LARGEST: within 4 errors, the summary's own
# (KEY_error, which may be LARGEST at most) and that of the reference.
within() {
    holds "$1" awk -v key="$2" -v want="$3" -v error="$4" -v most="$5" '
        $1 == key { got = $2; found = 1 }
        $1 == key "_error" { own = $2 }
        END { z = (got - want) / sqrt(own * own + error * error)
            print key, got, "+-", own, "not", want, "+-", error, "z", z
            exit !(found && own > 0 && own <= most && z < 4 && z > -4) }' \
        "$work/s"
}

# says NAME CONDITION: an awk expression of the last summary, s["key"].
says() {
    holds "$1" awk "{ s[\$1] = \$2 } function abs(x) { return x < 0 ? -x : x }
        END { for (k in s) print k, s[k]; exit !($2) }" "$work/s"
}

# Without options: the article's four disks.
$d --until 6000 -o /dev/null --summary "$work/s"
near 'four disks fill 0.09 pi of the box' packing 0.28274333882308 1e-13
near 'all speeds 1: kT is 1/2' kT 0.5 1e-12
near 'the energy stays' energy_error 0 1e-12
# 8.88634 sqrt(E) wall hits a second with E = 2; their pressure and their
# collisions are in disks_four.sh.
says 'they hit the walls as often as they should' \
    'abs(s["wall_collisions"] / s["time"] / 12.56718 - 1) < 0.006'

$d --disks 2 --radius 0.15 --until 8000 -o /dev/null --summary "$work/s"
within 'two disks, exactly known: x' Z_wall_x 1.771667475 1e-9 0.025
within 'two disks, exactly known: y' Z_wall_y 1.771667475 1e-9 0.025
$d --disks 1 --radius 0.1 --until 4000 --warmup 0 -o /dev/null --summary "$work/s"
says 'one disk flies to and fro: Z = 2 v_x^2 / v^2 * L / (L - 2r), both together' \
    'abs((s["Z_wall_x"] + s["Z_wall_y"]) / 2 - 1.25) < 1e-3'

# p(x) of the four; that it is that of direct sampling disks_four.sh finds.
$d --measure positions --every 0.5 --samples 40000 -o "$work/p" --summary "$work/s"
near 'every clock time is looked at' samples 40001 0
holds 'the densities sum to one' awk '!/^#/ { x += $2 / 100; y += $4 / 100 }
    END { print x, y; exit !((x - 1) ^ 2 < 1e-20 && (y - 1) ^ 2 < 1e-20) }' \
    "$work/p"

# MPPhys: 250 disks. The wall pressures from other runs, 60 times 200 s.
$d --disks 250 --radius 0.1 --box 7.5,5 --until 300 -o "$work/gas" \
    --summary "$work/s"
near 'the gas fills a fifth of the box' packing 0.20943951 1e-8
within 'the gas presses on x' Z_wall_x 1.66779 0.00059 0.02
within 'the gas presses on y' Z_wall_y 1.68545 0.00055 0.02
within 'its virial' Z_virial 1.62075 0.00031 0.005
says 'a disk collides 4.956 times a second' \
    'abs(s["collision_rate"] / 4.956 - 1) < 0.004'
holds 'the virial theorem holds in every run, to rounding' awk '
    NR == FNR { s[$1] = $2; next }
    /^#/ || !NF { next }
    { if (!begun++) t = $1
        G[$1 == t] += $3 * (($5 - 3.75) * $7 + ($6 - 2.5) * $8) }
    END { unit = 2 * s["kT"] * 250 * s["time"]
        walls = (s["Z_wall_x"] * 7.3 / 7.5 + s["Z_wall_y"] * 4.8 / 5) / 2
        off = (G[0] - G[1]) / unit - (s["Z_virial"] - walls)
        print off, walls, s["Z_virial"]; exit !(off < 1e-12 && off > -1e-12) }' \
    "$work/s" "$work/gas"

# Bulk, with the correction for N; another event-driven run of so many.
bulk() { # DIMENSIONS DISKS PACKING COLLISIONS Z ERROR LARGEST
    $d --dimensions "$1" --disks "$2" --packing "$3" --boundary periodic \
        --temperature 1 --collisions "$4" -o /dev/null --summary "$work/s"
    within "$1-D, packing $3: Z" Z_virial "$5" "$6" "$7"
    near "$1-D, packing $3: it was asked for" packing "$3" 1e-12
    near "$1-D, packing $3: kT is exact" kT 1 1e-12
    says "$1-D, packing $3: Enskog's rate" \
        "abs(s[\"collision_rate\"] / (2 * $1 * (s[\"Z_virial\"] - 1)) * 1.7724538509 - 1) < 0.004"
}
bulk 2 324 0.10 200000 1.23570 0.00016 0.001
bulk 2 324 0.30 200000 2.06120 0.00055 0.005
bulk 2 324 0.60 200000 6.45002 0.00318 0.03
bulk 3 500 0.20 200000 2.40584 0.00079 0.01
bulk 3 480 0.49 300000 12.17400 0.01127 0.07

# Speeds: the columns of laws are the laws, and the gas follows the exact one.
$d --disks 10 --radius 0.1 --box 1.5,1 --measure speeds --every 0.5 \
    --samples 20000 -o "$work/v" --summary "$work/s"
holds 'the exact law and Maxwell, averaged over a bin' awk '
    function below(u) { return 1 - (u * u < 10 ? (1 - u * u / 10) ^ 9 : 0) }
    !/^#/ { w = 2 / 21; n++
        a = (below($1 + w) - below($1)) / w - $4
        b = (exp(-$1 ^ 2) - exp(-($1 + w) ^ 2)) / w - $5
        if (a * a > worst) worst = a * a
        if (b * b > worst) worst = b * b }
    END { print n, worst; exit !(n == 42 && worst < 1e-18) }' "$work/v"
within 'ten disks: <v^4> = 2 N / (N + 1)' v4 1.81818181818 1e-9 0.01
near 'ten disks: the exact law gives that' v4_finite 1.8181818181818 1e-12
# Gamma(1.5) Gamma(10) / Gamma(10.5) sqrt(10)
within 'ten disks: the mean speed' mean_speed 0.8973696 1e-6 0.002
near 'ten disks: the exact mean' mean_speed_finite 0.8973696 1e-6
near "ten disks: Maxwell's mean" mean_speed_maxwell 0.88622692545 1e-9
says 'ten disks: the exact law fits, Maxwell does not' \
    's["chi2_finite"] < 2.2 * s["bins"] && s["chi2_maxwell"] > 10 * s["bins"]'
$d --disks 250 --radius 0.1 --box 7.5,5 --measure speeds --every 1 \
    --samples 3 -o /dev/null --summary "$work/s"
near '250 disks: <v^4>' v4_finite 1.9920318725 1e-9
near '250 disks: <v>' mean_speed_finite 0.886670149 1e-9
$d --disks 32 --packing 0.3 --boundary periodic --dimensions 3 \
    --measure speeds --every 0.5 --samples 4000 -o /dev/null --summary "$work/s"
# n = 93 numbers, u^2 at most 93/2 31/32: <u^4> is 15 of its squares / n (n + 2).
within 'periodic spheres: <v^4>' v4 3.445196 1e-8 0.05
near 'periodic spheres: the exact law gives that' v4_finite 3.445196 1e-5

# The same gas on the move (found by a trial of the second edition: Z 1.189
# for 2.336, kT 5.59 for .790): a drift is no heat where momentum is kept.
for boundary in floor periodic; do
    heavy=$([ $boundary = floor ] || echo '--heavy 5,0.7')
    $d --disks 16 --radius 0.5 --box 6,6 --start random --temperature 1 \
        --boundary $boundary $heavy --until 0 -o "$work/still"
    awk '!/^#/ && NF { $7 = sprintf("%.17g", $7 + 3) } { print }' \
        "$work/still" >"$work/moving"
    for x in still moving; do
        $d --start "$work/$x" --until 1 -o /dev/null --summary "$work/$x.s"
    done
    holds "$boundary: the temperature does not depend on a drift" \
        awk '$1 == "kT" { v[++n] = $2 } END { d = v[1] - v[2]
            print v[1], v[2]; exit !(n == 2 && d * d < 1e-26) }' \
        "$work/still.s" "$work/moving.s"
done
$d --start "$work/moving" --collisions 40000 --measure speeds --every 0.3 \
    -o /dev/null --summary "$work/s"
awk '{ sub(/^v4/, "move"); sub(/^Z_virial/, "Zm"); print }' "$work/s" >"$work/m"
$d --start "$work/still" --collisions 40000 --measure speeds --every 0.3 \
    -o /dev/null --summary "$work/s"
cat "$work/m" >>"$work/s"
says 'Z of a gas on the move is that of the same gas at rest' \
    's["Zm_error"] < 0.05 && s["Z_virial_error"] < 0.05 &&
     abs(s["Zm"] - s["Z_virial"]) < 4 * (s["Zm_error"] + s["Z_virial_error"])'
says 'its speeds have the same law' \
    's["v4_finite"] == s["move_finite"] && s["move_error"] < 0.02 &&
     abs(s["move"] - s["move_finite"]) < 4 * s["move_error"]'
$d --start "$work/moving" --until 600 --measure brownian --every 0.1 \
    -o "$work/path" --summary "$work/s"
near 'the heavy disk on the move has its share of the heat' V2_exact \
    0.152380952381 1e-9
says 'and no more' 's["V2_error"] < 0.05 * s["V2"] &&
    abs(s["V2"] - s["V2_exact"]) < 4 * s["V2_error"]'

# Relaxation: the first collisions, 64/225 of <v^4> for each of a disk; at
# 0.19 of them another run has 0.2784. Of 750 collisions: 3 per cent.
for seed in 1 2 3 4 5 6 7 8; do
    $d --disks 1000 --packing 0.05 --start random \
        --measure relaxation --every 0.5 --until 3 --seed $seed
done >"$work/r"
holds 'the first collisions raise <v^4> by 64/225 each' awk '
    !/^#/ && $1 == 0 { bad += ($3 - 1) ^ 2 > 1e-12 }
    !/^#/ && $1 == 1 { c += $2 / 8; v += ($3 - 1) / 8 }
    END { print c, v, v / c, bad; exit bad || c < 0.15 || c > 0.25 ||
        (v / c - 0.2784) ^ 2 > 0.035 ^ 2 }' "$work/r"
# MPPhys's gas, 240 times as large: 3000 runs of the small one have this.
$d --disks 60000 --radius 0.1 --box 116.1895004,77.45966692 \
    --measure relaxation --every 0.05 --until 2.6 -o "$work/large"
holds '<v^4> relaxes as in three thousand runs of 250 disks' awk 'BEGIN {
        n = split("1 2 3 5 8 12", at); split("1.262 1.472 1.629 1.821 1.934 1.971", want) }
    !/^#/ { while (k < n && $2 >= at[k + 1]) { ++k
            v = a + ($3 - a) * (at[k] - c) / ($2 - c)
            print at[k], v, want[k]; bad += (v - want[k]) ^ 2 > 0.033 ^ 2 }
        c = $2; a = $3 }
    END { exit bad || k != n }' "$work/large"
holds 'H of equal speeds is that of one ring' awk '
    !/^#/ && $1 == 0 { a = 20 / 21; b = 22 / 21; n++
        d = $4 + log(3.14159265358979 * (b * b - a * a)); bad += d * d > 1e-12 }
    END { exit bad || n != 8 }' "$work/r"
$d --disks 1000 --packing 0.2 --measure relaxation --every 1 --until 24 \
    -o "$work/r"
holds 'H ends at -1 - ln pi, within the bias of the bins' awk '
    !/^#/ && $2 > 12 { n++; h += $4 }
    END { h /= n; print n, h; exit !(h < -2.09 && h > -2.16) }' "$work/r"

# The heavy disk: slope of its correlation at the start.
$d --disks 400 --radius 0.5 --heavy 40,2 --start random --temperature 1 \
    --box 39.79149,39.79149 --boundary periodic --warmup 5 \
    --measure brownian --every 0.1 --until 250 -o "$work/b" --summary "$work/s"
near 'M <V^2> is kT, less its share of the momentum' V2_exact 0.02272727273 1e-9
near 'it is hit as often as kinetic theory says' heavy_rate 2.478 0.4
says 'the correlation begins with the slope that the collisions make' \
    'abs(s["slope"] - s["slope_exact"]) < 4 * s["slope_error"] &&
     s["slope_error"] < 0.1 * s["slope_exact"] &&
     abs(s["slope_exact"] / s["heavy_rate"] / 0.0012195 - 1) < 1e-3'
holds 'at first it flies freely: the displacement is 2 C t^2' awk '
    !/^#/ { if (n++ == 0) c = $2; else if (n == 2) m = $4 }
    END { r = m / (2 * c * 0.01); print r; exit !(r > 0.98 && r < 1.0) }' \
    "$work/b"

# Continued, looked at, moved by another engine: the same bytes.
rows() { grep -v '^#' "$1"; }
for box in periodic walls; do
    run="$d --disks 60 --packing 0.4 --boundary $box --seed 5"
    $run --every 0.7 --samples 40 -o "$work/whole"
    $run --every 0.7 --samples 13 -o "$work/part"
    $d --start "$work/part" --every 0.7 --until 28 -o "$work/rest"
    rows "$work/rest" >"$work/rest.rows"
    rows "$work/whole" | tail -n "$(wc -l <"$work/rest.rows")" >"$work/end.rows"
    holds "$box: a state in a file is continued exactly" \
        cmp "$work/rest.rows" "$work/end.rows"
    $run --every 28 --samples 1 -o "$work/once"
    holds "$box: looking changes nothing" sh -c "grep -v '^#' '$work/whole' | tail -n 60 |
        cut -d ' ' -f 2- >'$work/x'; tail -n 60 '$work/once' | cut -d ' ' -f 2- |
        cmp - '$work/x'"
    for engine in pairs cells; do
        $run --every 7 --samples 4 --engine $engine -o "$work/$engine"
    done
    holds "$box: two engines, the same bytes" cmp "$work/pairs" "$work/cells"
done
$d --dimensions 3 --disks 20 --packing 0.2 --boundary periodic --every 1 \
    --samples 6 -o "$work/whole"
$d --dimensions 3 --disks 20 --packing 0.2 --boundary periodic --every 1 \
    --samples 2 -o "$work/part"
$d --start "$work/part" --every 1 --samples 4 | grep -v '^#' >"$work/rest.rows"
rows "$work/whole" | tail -n "$(wc -l <"$work/rest.rows")" >"$work/end.rows"
holds 'spheres are continued exactly' cmp "$work/rest.rows" "$work/end.rows"

# A file by hand: two disks of 1 kg and 3 kg, head on, meet after 1 s.
printf '# box 10 10 walls\n0 1 1 0.5 2 5 2 0\n0 2 3 0.5 5 5 0 0\n' >"$work/two"
$d --start "$work/two" --until 2 --summary "$work/s" | tail -n 2 >"$work/x"
holds 'two disks head on' awk '
    NR == 1 { bad += ($5 - 3) ^ 2 > 1e-24 || ($7 + 1) ^ 2 > 1e-24 || $9 != 4 || $11 != 1 }
    NR == 2 { bad += ($5 - 6) ^ 2 > 1e-24 || ($7 - 1) ^ 2 > 1e-24 || $11 != 1 }
    END { exit bad || NR != 2 }' "$work/x"
# sigma J / (D N kT t) = 1 * 3 / (2 * 2 * 1/2... kT = 2 K / (D N) = 1 J.
near 'its virial' Z_virial 1.375 1e-12
$d --start "$work/two" --until 2 --restitution 0.5 -o /dev/null \
    --summary "$work/s"
# (1 - e^2) mu w^2 / 2 = 0.75 * 0.75 * 4 / 2 of 2 J.
near 'with half the speed of approach left' energy_change -0.5625 1e-12
says 'no pressure is claimed of a gas that cools' '!("Z_virial" in s)'

# A mixture: equal energies, whatever the mass.
printf '20 1 0.5 # light\n\n20 8 1\n' >"$work/kinds"
$d --species "$work/kinds" --packing 0.3 --boundary periodic --start random \
    --every 2 --samples 500 -o "$work/m" --summary "$work/s"
near 'a mixture fills what was asked for' packing 0.3 1e-12
holds 'light and heavy have the same energy' awk '!/^#/ && NF {
        K[$3] += $3 * ($7 ^ 2 + $8 ^ 2) / 2; n[$3]++ }
    END { r = K[1] / n[1] / (K[8] / n[8]); print r, n[1], n[8]
        exit !(n[1] == n[8] && r > 0.94 && r < 1.06) }' "$work/m"

# The pressure of a run without a clock is one row, that of the summary. By
# (7.10) the two pressures differ by the rim that no centre enters, R = 0.5.
$d -N 50 --box 12,11 --radius 0.5 --collisions 20000 --measure pressure \
    -o "$work/t" --summary "$work/s"
holds 'a pressure without --every is that of the run' awk '
    FNR == NR { s[$1] = $2 }
    FNR != NR && !/^#/ { ++n; good = $1 > 0 && $2 == s["Z_wall_x"] &&
        $3 == s["Z_wall_y"] && $4 == s["Z_virial"] }
    END { exit !(n == 1 && good) }' "$work/s" "$work/t"
says 'its virial is the mean of Z_wall (1 - 2R/L)' \
    'abs((s["Z_wall_x"] * 11 / 12 + s["Z_wall_y"] * 10 / 11) / 2 - s["Z_virial"]) < 0.01'

# Four disks under gravity: the exact law of heights of four points, whose
# box is higher than they can get; 30 bins of 100, where more than a
# thousand of the looks fall. The exponential of an endless gas is far off.
$d -N 4 --radius 0.01 --box 1,0.5 --start random --seed 2 --warmup 0 \
    --until 0 -o "$work/low"
$d --start "$work/low" --box 1,2.5 --gravity 2 --every 0.5 --until 100000 \
    --measure positions -o "$work/h" --summary "$work/s"
near 'what falls keeps its energy' energy_error 0 1e-11
says 'no pressure is claimed of a gas with weight' '!("Z_virial" in s)'
holds 'heights follow the law of four disks, and not the exponential' awk '
    function law(y) { y = 1 - 2 * (y > .01 ? y - .01 : 0) / E
        return y > 0 ? y ^ 7 : 0 }
    function endless(y) { return exp(-2 * (y > .01 ? y - .01 : 0) / kT) }
    FNR == NR { if ($1 == "kT") { kT = $2; E = 8 * kT }; next }
    /^#/ { next }
    $5 > 0 && n < 30 { y = 2.5 * $1; ++n
        p += ((law(y) - law(y + .025)) / .025 - $4) ^ 2 / $5 ^ 2
        q += ((endless(y) - endless(y + .025)) / .025 - $4) ^ 2 / $5 ^ 2 }
    END { print p, q, n; exit !(n == 30 && p < 60 && q > 300) }' \
    "$work/s" "$work/h"

# The same without sides: the momentum along the floor is kept, zero, and a
# half is missing in the exponent; the law of a box with sides is far off.
$d -N 4 --radius 0.01 --box 1,0.5 --boundary floor --start random --seed 2 \
    --warmup 0 --until 0 -o "$work/low"
for e in pairs cells; do
    $d --start "$work/low" --box 1,2.5 --gravity 2 --every 0.5 \
        --until 100000 --measure positions --engine $e -o "$work/$e" \
        --summary "$work/s"
    near "what falls without sides keeps its energy, $e" \
        energy_error 0 1e-11
done
holds 'without sides cells give the bits of pairs' \
    cmp "$work/pairs" "$work/cells"
holds 'without sides half a power less, and not the law of a box' awk '
    function law(y, power) { y = 1 - 2 * (y > .01 ? y - .01 : 0) / E
        return y > 0 ? y ^ power : 0 }
    FNR == NR { if ($1 == "kT") E = 7.5 * $2; next }
    /^#/ { next }
    $5 > 0 && n < 30 { y = 2.5 * $1; ++n
        p += ((law(y, 6.5) - law(y + .025, 6.5)) / .025 - $4) ^ 2 / $5 ^ 2
        q += ((law(y, 7) - law(y + .025, 7)) / .025 - $4) ^ 2 / $5 ^ 2 }
    END { print p, q, n; exit !(n == 30 && p < 60 && q > 300) }' \
    "$work/s" "$work/cells"

# 400 disks that take room, in a box without sides: their density obeys
# ln(rho / rho0) + b (rho - rho0) = -m g y / kT, b = 4 pi r^2, up to the
# third virial coefficient: 4.7 eta^2 of the density, 1.5 % at the floor.
# The exponential is off by 4 eta, a fifth. Above y are h (rho + b rho^2/2)
# disks, h = kT/mg; the heights share kT (1 + b <rho>/2) N of the energy.
# The first bin holds those that nobody pushes from below. Over 50 others
# chi-square is 50 +- 10, and more for neighbours that hang together.
$d -N 400 --radius 0.003 --box 1,0.25 --boundary floor --start random \
    --warmup 0 --until 0 -o "$work/low"
$d --start "$work/low" --box 1,2 --gravity 2 --every 0.25 --until 100 \
    --measure positions -o "$work/h" --summary "$work/s"
near '400 that fall keep their energy' energy_error 0 1e-11
holds 'disks that take room obey the second virial coefficient' awk '
    function above(y, i, x, t) {
        y = y > r ? y - r : 0
        if (b == 0)
            return exp(-y / h)
        for (i = 0; i < 20; ++i) {
            if (i == 0)
                x = rho0 * exp(-y / h)
            t = log(x / rho0) + b * (x - rho0) + y / h
            x -= t / (1 / x + b)
        }
        return (x + b * x * x / 2) / (rho0 + b * rho0 * rho0 / 2)
    }
    function chi2(k, i, q, sum) {
        kT = E / (2 * N - .5)
        for (i = 0; i < 50; ++i) {
            h = kT / 2
            rho0 = b ? (sqrt(1 + 2 * b * N / h) - 1) / b : N / h
            mean = h / N * (rho0 ^ 2 / 2 + b * rho0 ^ 3 / 3)
            kT = E / (2 * N - .5 + N * b * mean / 2)
        }
        for (i = 1; i <= 50; ++i) {
            q = (above(.02 * i) - above(.02 * i + .02)) / .02
            sum += ((q - p[i]) / e[i]) ^ 2
        }
        return sum
    }
    FNR == NR { if ($1 == "kT") E = $2 * (4 * 400 - 1) / 2; next }
    /^#/ { next }
    { p[n] = $4; e[n++] = $5 }
    END { N = 400; r = .003
        ideal = chi2(); b = 4 * 3.14159265 * r * r; room = chi2()
        print "# " ideal, room > "/dev/stderr"; exit !(room < 90 && ideal > 130) }' \
    "$work/s" "$work/h"
refuses 2 "narrow to be periodic: .*more than 1.2" \
    $d -N 2 --radius 0.3 --box 1.1,5 --boundary floor --gravity 1
refuses 2 'not in a box with a floor' $d --boundary floor --measure speeds \
    --every 1
$d -N 4 --radius 0.1 --box 3,3 --boundary periodic --until 1 -o "$work/p"
refuses 2 'needs a floor' $d --start "$work/p" --gravity 1
$d -N 4 --radius 0.1 --box 3,3 --gravity 1 --warmup 0 --until 3 -o "$work/p"
$d -N 4 --radius 0.1 --box 3,3 --gravity 1 --warmup 0 --until 1 -o "$work/q"
$d --start "$work/q" --gravity 1 --until 3 -o "$work/r"
holds 'a state under gravity may be gone on from' awk '/^#/ || !NF { next }
    FNR == NR { for (k = 5; k <= 8; ++k) last[$2, k] = $k; next }
    { for (k = 5; k <= 8; ++k) off[$2, k] = $k - last[$2, k]; ++n }
    END { for (k in off) if (off[k] ^ 2 > 1e-18) exit 1; exit n != 8 }' \
    "$work/p" "$work/r"

# One that lies on the floor: given so it is refused, and a run that gets
# there ends.
printf '# box 3 3 floor\n0 1 1 0.1 1 0.1 1 0 1 0.1 0\n' >"$work/p"
refuses 2 'disk 1 lies on the floor at rest' $d --start "$work/p" --gravity 1
sed 's/1 0.1 1 0 /1 0.6 1 0 /; s/1 0.1 0$/1 0.6 0/' "$work/p" >"$work/q"
refuses 1 'disk 1 lies on the floor at t = 3 s' $d --start "$work/q" \
    --gravity 1 --restitution 0.5 --until 100 -o "$work/r"
echo 1..90
