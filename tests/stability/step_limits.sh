#!/bin/sh
# Where step fails: what its bound on the energy sees, and what it does not.
. tests/programs/common
step=build/bin/step
w=$work
build/bin/scene double-pendulum -o "$w/pendulum"
build/bin/scene sun-earth -o "$w/sun"
less() { # NAME A B: A < B
    holds "$1: $2 < $3" awk -v a="$2" -v b="$3" \
        'BEGIN { exit !(a ~ /[0-9]/ && a + 0 < b + 0) }'
}

# Leapfrog's limit on the double pendulum is 0.02827 s: just below it runs
# for a minute, just above it is stopped within seconds, and no row of it
# has more than the bound times the scale (|E| + depth < 10 J).
holds 'just below the limit it runs' \
    $step "$w/pendulum" --dt 0.028 --until 60 -o "$w/t" --summary "$w/s"
less 'and keeps its energy' "$(key "$w/s" energy_error)" 0.01
$step "$w/pendulum" --dt 0.0285 --every 0.0285 --until 60 --observe energy \
    -o "$w/t" --summary "$w/s" 2>/dev/null
holds 'just above it is stopped' grep -qx 'end energy' "$w/s"
less 'soon' "$(key "$w/s" time)" 5
holds 'before its rows are nonsense' \
    awk '!/^#/ && $2 > 100 { exit 1 }' "$w/t"

# RK4 beyond its limit loses energy, in silence: the summary alone shows it.
holds 'RK4 loses energy and nobody says so' $step "$w/pendulum" \
    --method rk4 --dt 0.025 --until 10 -o "$w/t" --summary "$w/s"
less "though a good run does not" 1e-4 "$(key "$w/s" energy_error)"
$step "$w/pendulum" --method rk4 --dt 0.001 --until 10 -o "$w/t" \
    --summary "$w/s"
less 'a short step' "$(key "$w/s" energy_error)" 1e-6

# Euler's Earth flies away and is stopped by no bound: it cannot gain more
# than it lacks to be free, a third of the scale.
holds 'a wrong orbit is a run' $step "$w/sun" --method euler --dt 1 \
    --until 100000 --bound 0.34 -o "$w/t"
$step "$w/sun" --method euler --dt 1 --until 3650 --bound 0.1 -o "$w/t" \
    --summary "$w/s" 2>/dev/null
holds 'but for a smaller bound' grep -qx 'end energy' "$w/s"
echo 1..10
