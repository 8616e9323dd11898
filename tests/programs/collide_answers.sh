#!/bin/sh
# What collide prints, against exact fractions.
. tests/programs/common
c=build/bin/collide

answers() { # PATTERN OPTION...
    pattern=$1
    shift
    if $c "$@" 2>&1 | grep -q -e "$pattern"; then ok "collide $*"; else
        not_ok "collide $*" "no '$pattern' in: $($c "$@" 2>&1 | tr '\n' ' ')"
    fi
}
answers 'mass 1: velocity 1 -> -0.6$' --velocities 1,0 --inverse-masses 1,0.25
answers 'mass 4: velocity 0 -> 0.4$' --velocities 1,0 --inverse-masses 1,0.25
answers 'velocity 0,0 -> 0.909091,0.909091$' \
    --velocities 1,0,0,0 --inverse-masses 0.1,1 --normal 0.7,0.7
answers 'velocity 1,0 -> 0.5,-0.5$' \
    --velocities 1,0,0,0 --inverse-masses 0.1,0.1 --normal 0.7,0.7
answers 'velocity 1,0,0 -> 0.5,-0.5,0$' --velocities 1,0,0,0,0,0 \
    --inverse-masses 0.1,0.1 --normal 3,3,0
answers 'a wall: velocity -0.5 -> -0.5$' \
    --velocities 1,-0.5 --inverse-masses 1,0
answers 'the wall takes 3$' --velocities 1,-0.5 --inverse-masses 1,0
answers 'change -60 % (expected -60 %)$' --velocities 1,0 \
    --inverse-masses 1,0.25 --restitution 0.5
answers 'collide: note: the bodies move apart' \
    --velocities 0,1 --inverse-masses 1,1
for form in cm difference impulse complement smaller; do
    answers "10 collisions, form $form" --form $form --dimensions 2
done

# A million random collisions: no more than 8 eps in energy, 4 in momentum.
for d in 1 2 3; do
    $c --tests 1000000 --dimensions $d --summary "$work/s" -o /dev/null
    holds "a million in $d dimensions: energy to 16 eps, momentum to 6" \
        awk '$1 == "energy_error_max" { e = $2 } $1 == "momentum_error_max" { p = $2 }
             END { print e, p; exit !(e > 0.5 && e < 16 && p > 0.5 && p < 6) }' \
        "$work/s"
done
