#!/bin/sh
# What the studies of chapter 10 show, against theory and against reference
# values computed for this book in quadruple precision.
. tests/programs/summaries
studies=build/bin/springs-studies

# Errors of second order, (omega h)^2 t / 24 and less: h = 0.05, t = 15.
study regimes
between 'three regimes, to the error of the step' regimes worst 1e-5 1.6e-3
# The difference of two exponentials at 1 + 1e-10: eps / sqrt(2e-10) = 2e-11.
study critical
between 'near the limit the textbook loses digits' critical book_error \
    1e-14 1e-10

# The printed dashpot: L falls to exp(-5), the axial one leaves it.
study spin
between 'the printed dashpot ends rotation' spin left 0.006737 0.006739
between 'the axial one does not' spin axial_change -1e-12 1e-12

study errors
between 'leapfrog at 1 ms: 2.75e-5' errors leapfrog_1e-3 2.7e-5 2.8e-5
between 'RK4 at 1 ms: 2.3e-8' errors rk4_1e-3 2.2e-8 2.4e-8
holds 'Kahan and Li come to rounding' awk '
    /^# kahan/ { inside = 1 } !NF { inside = 0 }
    inside && $3 + 0 == $3 && $3 < 1e-12 { found = 1 }
    END { exit !found }' "$work/errors.dat"

# Rod and spring: second order in the step, 1/D in the stiffness.
study rod
holds 'the rod is of second order' awk '
    !NF { exit } /^#/ { next } { e[++n] = $2 }
    END { r = e[n - 3] / e[n - 2]; print r; exit !(r > 3.9 && r < 4.1) }' \
    "$work/rod.dat"
holds 'the spring becomes a rod as 1/D' awk '
    /^#/ { next } !NF { ++block; next } block == 2 { d[++n] = $1 * $2 }
    END { print d[n], d[n - 2]; r = d[n] / d[n - 2]
        exit !(r > 0.9 && r < 1.1) }' "$work/rod.dat"

# Limits: theory over 70.74605996 and 15.103518 rad/s, found to 1e-3.
study limits
between 'leapfrog, pendulum' limits pendulum_leapfrog 0.02824 0.02830
# The limits 2 sqrt 2/70.74606 and 2 sqrt 2/15.103518, and what the search
# may add: a growth by half in 2000 and 1000 steps, 3e-5 and 6e-5 of them.
between 'RK4, pendulum' limits pendulum_rk4 0.039979 0.039982
between 'RK4, membrane' limits membrane_rk4 0.18726 0.18729
between 'Yoshida 4, pendulum' limits pendulum_yoshida4 0.02222 0.02226
between 'PEFRL, pendulum' limits pendulum_pefrl 0.04221 0.04230
between 'leapfrog, membrane' limits membrane_leapfrog 0.13229 0.13255
between 'Euler: none' limits pendulum_euler 0 0
holds 'implicit: any' grep -qx 'pendulum_implicit-midpoint inf' \
    "$work/limits"

study silent
between 'RK4 damps in silence' silent rk4 0 2e-4
between 'what it should not' silent yoshida4 5e-4 7e-4

# A T = 7.4162987092 l sqrt(m/D) at small amplitudes; at 0.1 m 3.102307881.
study quartic
between 'no linear mode' quartic AT 0.299660 0.299672
between 'the period at 0.1 m' quartic T_0.1 3.1023077 3.1023080
study membranes
between 'the loose membrane, 10 s' membranes a_10 -0.979768 -0.979767
between 'it leaves its mode' membranes rest_5 0.07 0.074
between 'the taut one does not' membranes taut_rest_40 0 1e-3
# (A / 0.13 m)^2 of the amplitude 1e-5 is 6e-9, and the step's error.
study dispersion
between 'the discrete dispersion' dispersion worst 0 1e-5
study sag
between 'eight times the load, twice the depth' sag ratio 1.98 2.03

study beams
between 'the beam at rest' beams still_usual 0.4201093054 0.4201093056
between 'linear theory' beams linear_usual 0.42499999 0.42500001
between 'heavy' beams still_heavy 2.969760828 2.969760829
between 'the second frequency' beams second 8.93555666 8.93555667
between 'the third' beams third 10.1679044 10.1679046
between 'the fastest' beams fastest 74.8249253 74.8249254
between 'twice the depth at the turning point' beams lowest_light 0.083 0.086
between 'no diagonals: a mechanism' beams loose_no_diagonals 5 5

for study in path shapes work; do
    study $study
    holds "$study has a table" test "$(wc -l <"$work/$study.dat")" -gt 40
done
echo 1..37
