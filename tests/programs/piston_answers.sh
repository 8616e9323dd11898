#!/bin/sh
# What piston says: the model against exact numbers, the measurements
# against a table whose answers are known, and the theory against the
# particles. Reference values computed for this book by a program of its
# own.
. tests/programs/summaries
p=build/bin/piston
b=build/bin/bonkers

# The model. Digits as given; x_max from rows 0.1 s apart is less than
# a (w 0.05)^2/2 = 1e-4 short.
$p --gas-masses 0,0 --until 200 -o "$work/swing" --summary "$work/s"
near 'eleven, small swing' period_small 37.69911 5e-6
near 'eleven, large swing' period_large 20.20642 5e-6
near 'eleven, isothermal guess' period_isothermal 65.29678 5e-6
near 'eleven, turning point' x_max 9.8275 1e-4
near 'eleven, other turning point' x_min 2.1725 1e-4
near 'no gas mass, no added mass' period_small_added 37.69911 5e-6
near 'no gas mass, no sound' period_acoustic 37.69911 5e-6
holds 'the swing has a row for each tenth of a second' \
    awk '!/^#/ { n++; t = $1 } END { exit !(n == 2001 && t == 200) }' \
    "$work/swing"
holds 'the energies of a row add up, but for the energy error of the steps' \
    awk '$1 == "energy_error" { allowed = $2 * 80 / 3 }
        !/^#/ && NF == 6 { e = $4 + $5 + $6 - 80 / 3; if (e < 0) e = -e
            if (e > worst) worst = e }
        END { print worst, allowed
            exit !(worst > 0 && worst <= allowed * (1 + 1e-9) && allowed < 3e-4) }' \
    "$work/s" "$work/swing"
$p --velocity 0.1 -o /dev/null --summary "$work/s"
near 'small swing with added mass' period_small_added 39.73835 5e-6
near 'small swing with sound' period_acoustic 39.77915 5e-6
near 'true swing, bare' period_large 37.23662 5e-6
near 'true swing with added mass' period_large_added 39.29878 5e-6

# Ways to a period: the finest of each agree.
$p --study cost --velocity 0.1 -o "$work/cost"
holds 'steps and quadrature agree to 1e-8, unequal steps do not' awk '
    $1 == "leapfrog" && $2 == 1 { leap = $4; if ($3 == 1) coarse = $4 }
    $1 == "rk4" && $2 == 1 { rk4 = $4 }
    $1 == "quadrature" && $2 == 1 { exact = $4 }
    END { print leap, rk4, exact, coarse
        exit !((leap / exact - 1) ^ 2 < 1e-16 && (rk4 / exact - 1) ^ 2 < 1e-20 &&
            (coarse / exact - 1) ^ 2 > 1e-7) }' "$work/cost"

# A table made by hand: period 20, decay time 50, shares 1/3 + 0.4 exp(-t/50),
# but 0.1 more before 30 s, and no more decay after 305 s: the fit must
# leave both ends out.
awk 'BEGIN {
    print "# 1 t [s] time\n# 2 energy [J] all"
    for (i = 1; i <= 3; ++i)
        printf "# %d x%d [m] x\n# %d v%d [m/s] v\n# %d T%d [J] T\n",
            3 * i, i, 3 * i + 1, i, 3 * i + 2, i
    for (n = 0; n <= 4000; ++n) {
        t = n / 10
        s = 1 / 3 + (t < 30) / 10 + (t < 305 ? 0.4 * exp(-t / 50) : 0.0005)
        x = 6 + sin(t * 3.14159265358979 / 10)
        printf "%.15g 9 1 0 %.15g %.15g 0 %.15g 9 0 %.15g\n", t, 4 * (1 - s),
            x, 9 * s, 5 * (1 - s)
    } }' >"$work/made"
$p --study measure --body 2 --window 10 --at 5,105 --fit 0.2,0.001 \
    --table "$work/made" -o "$work/windows" --summary "$work/s"
near 'a made table: movers' movers 3 0
near 'a made table: share at the start' share_start 0.833333333 1e-8
near 'a made table: period' period 20 1e-6
near 'a made table: no scatter of the period' period_spread 0 1e-6
near 'a made table: half a period' first_half 10 1e-6
near 'a made table: reach' reach 1 1e-12
# The mean of exp(-t/50) over rows 0 to 9.9 is (1-e^-0.2)/(1-e^-0.002)/100;
# four tenths of it, a third and a tenth.
near 'a made table: share in the first window' share_1 0.7962345 1e-6
near 'a made table: decay time' tau 50 1e-6
near 'a made table: no scatter of the decay' tau_error 0 1e-6
holds 'a made table: the fit passes through the windows' awk '!/^#/ &&
    $1 > 30 && $1 < 300 { n++; bad += ($2 - $3) ^ 2 > 1e-12 }
    END { exit bad || n < 20 }' "$work/windows"

# Two windows that are high enough make no fit: no column of it, and no nan.
head -n 130 "$work/made" >"$work/short"
$p --study measure --body 2 --window 4 --table "$work/short" -o "$work/windows"
holds 'too short a table: the head says that there is no fit' grep -qx \
    '# no fit: 0 windows between its bounds, 3 needed' "$work/windows"
holds 'and the rows have no column of it' awk '/^#/ { next }
    { ++n; bad += NF != 2 || /nan/ } END { exit bad || n != 2 }' "$work/windows"

# Four movers, the second of them the piston: 1 J to its left, 3 + 5 J to
# its right, at 4 m of 12.
cat >"$work/four" <<'EOF'
# 1 t [s] time
# 2 energy [J] all
# 3 x1 [m] x
# 4 v1 [m/s] v
# 5 T1 [J] T
# 6 x2 [m] x
# 7 v2 [m/s] v
# 8 T2 [J] T
# 9 x3 [m] x
# 10 v3 [m/s] v
# 11 T3 [J] T
# 12 x4 [m] x
# 13 v4 [m/s] v
# 14 T4 [J] T
0 11 1 0 1 4 7 2 9 0 3 10 0 5
1 11 1 0 1 4 7 2 9 0 3 10 0 5
2 11 1 0 1 4 7 2 9 0 3 10 0 5
EOF
$p --study gases --body 2 --table "$work/four" -o "$work/gases"
holds 'energies, temperatures and pressures of unequal gases' \
    awk '$1 == 2 { print; right = $2 == 4 && $3 == 7 && $4 == 2 &&
            $5 == 1 && $6 == 8 && $7 == 2 && $8 == 8 && $9 == 0.5 && $10 == 2 }
        END { exit !right }' "$work/gases"

# The eleven. Period 20.3 +- 0.3; shares to 4 standard errors: 0.0025 for
# 2000 starts, 0.002 of the reference.
$b --preset piston --ensemble 2000 --every 0.5075 --until 903 2>"$work/err" |
    $p --study measure --table - --at 50,100,200,400,800 --fit 0.07,0.02 \
        -o /dev/null --summary "$work/s"
near 'eleven: three quarters at the start' share_start 0.75 1e-9
near 'eleven: period' period 20.3 0.3
near 'eleven: share at 50 s' share_1 0.2300 0.013
near 'eleven: share at 100 s' share_2 0.1763 0.013
near 'eleven: share at 200 s' share_3 0.1401 0.013
near 'eleven: share at 400 s' share_4 0.1104 0.013
near 'eleven: share at 800 s' share_5 0.0954 0.013
# One over e in 215 +- 15 s; ensembles of 2000 starts scatter by 15 s:
# 4 (15^2 + 15^2)^(1/2) = 85.
near 'eleven: decay time' tau 215 85

echo 1..35
