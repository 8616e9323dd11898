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
answers 'energy 1.125 -> 1.125 seen from the wall' \
    --velocities 1,-0.5 --inverse-masses 1,0
answers 'change -19 % (expected -19 %)$' --velocities 1,1,0,0 \
    --inverse-masses 0.5,0.5 --normal 3,3 --restitution 0.7874007874
answers 'collide: warning: energy off by .* machine epsilons' \
    --velocities 1,-1e-3 --inverse-masses 1,1.1e-6 --form complement
answers 'form smaller' --tests 11
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

# Every form in the plane, with normals of any length: to 16 eps and 6.
for form in cm difference impulse complement smaller; do
    $c --tests 20000 --dimensions 2 --form $form --summary "$work/s" \
        -o /dev/null
    holds "form $form in 2 dimensions: energy to 16 eps, rms below 2" \
        awk '$1 == "energy_error_max" { e = $2 }
             $1 == "energy_error_rms" { r = $2 }
             $1 == "momentum_error_rms" { p = $2 }
             $1 == "momentum_error_max" { m = $2 }
             END { print e, r, p, m
                 exit !(e < 16 && r > 0.2 && r < 2 && r < e && p < 1.5 && p < m) }' \
        "$work/s"
done

# A summary by hand has what is after, and another seed is another run.
$c --velocities 1,0 --inverse-masses 1,0.25 --summary "$work/s" -o /dev/null
holds 'the summary has the velocities after' \
    awk '$1 == "v1_x" { a = $2 } $1 == "v2_x" { b = $2 }
         END { exit !(a < -0.59 && a > -0.61 && b > 0.39 && b < 0.41) }' "$work/s"
$c --tests 3 --seed 1 >"$work/one"
$c --tests 3 --seed 2 >"$work/two"
holds 'another seed is another run' sh -c "! cmp -s $work/one $work/two"

# The program that checks itself passes; with a wrong law it fails, and with
# none it passes, as the chapter says.
holds 'check-collide passes' build/bin/check-collide
checked() { # SED-SCRIPT: the status of the program so changed
    sed "$1" src/programs/check-collide.c >"$work/check.c" &&
        ! cmp -s "$work/check.c" src/programs/check-collide.c &&
        ${CC-cc} "$work/check.c" -o "$work/check" -lm && "$work/check"
}
holds 'a wrong fraction is caught' sh -c 'test "$1" = 1' - \
    "$(checked 's|2 \* b / (a + b)|2 * b / (a + a)|' >&2; echo $?)"
holds 'a law that does nothing is not' checked 's|2 \* [ab] /|0 /|'
echo 1..31
