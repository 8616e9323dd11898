#!/bin/sh
# The failures of chapter 1 that the studies of collide-forms show, against
# the reference values: errors of one collision measured with 1e6 random
# pairs against quadruple precision, and exact counts of Galperin's
# collisions (the digits of pi). Maxima of other samples differ in the second
# digit, so bounds leave a third on each side.
. tests/programs/summaries
studies=build/bin/collide-forms

study mild --study rounding --mass-ratio 3.1622776601683795
between 'similar masses: the cm form errs by 6 eps' mild energy_max_cm 4.1 8.1
between 'similar masses: the smaller form by 2.7' mild energy_max_smaller 1.8 3.6

# The complement form loses the small fraction's digits: 500 eps in energy
# and 13000 in momentum, or more, at a mass ratio of 1e6.
study wild --study rounding --mass-ratio 1e6
between 'mass ratio 1e6: the complement ruins energy' \
    wild energy_max_complement 300 3000
between 'mass ratio 1e6: the complement ruins momentum' \
    wild momentum_max_complement 8000 100000
between 'mass ratio 1e6: the smaller form does not (energy)' \
    wild energy_max_smaller 0 4.3
between 'mass ratio 1e6: the smaller form does not (momentum)' \
    wild momentum_max_smaller 0 4

# A common velocity of 1e6: half an ulp for forms in d, 3 for the cm form.
study train --study rounding --mass-ratio 3.1622776601683795 --offset 1e6
between 'on a train the smaller form loses half a digit' \
    train velocity_max_smaller 0.2 0.3
between 'on a train the cm form loses three' train velocity_max_cm 2.1 4.1

# Galperin: the double forms count right to k = 7, the complement and single
# precision fail from k = 6 on.
study pi6 --study galperin --digits 6
study pi7 --study galperin --digits 7
for form in cm difference impulse smaller; do
    between "digits of pi, k=6: $form" pi6 count_$form 3141592 3141592
    between "digits of pi, k=7: $form" pi7 count_$form 31415926 31415926
done
between 'k=6: the complement counts wrong' pi6 count_complement 3141453 3141453
between 'k=6: single precision counts wrong' pi6 count_float 3141593 3200000
study pi5 --study galperin --digits 5
between 'k=5: single precision counts right' pi5 count_float 314159 314159

# The bias of eq:bias, added up collision by collision, is the drift: what is
# left is the random walk, 0.3 eps sqrt(n) = 1e-13 of 1.8e-10, less than 1 %.
study law --study drift --collisions 2000000
predicted=$(awk '$1 == "predicted_difference" { print $2 }' "$work/law")
between 'the drift is what the rounded fractions predict' \
    law energy_error_difference "$(awk "BEGIN { print 1.01 * $predicted }")" \
    "$(awk "BEGIN { print 0.99 * $predicted }")"

# Ten times the collisions, ten times the drift.
study drift --study drift --collisions 2000000 --seed 7
between 'the drift of the difference form is linear' drift slope 9.5 10.5
between 'the smaller form drifts a hundred times less' \
    drift improvement 100 1e9

# A ball that the wall hardly overtakes: its energy seen from the wall is
# tiny, and rounding is held against the speed on the ground. No alarm.
build/bin/collide --velocities 1,1,1.001,1 --inverse-masses 1,0 \
    --normal=-1,0.3 >"$work/slow" 2>&1
if grep -q 'warning' "$work/slow" || ! grep -q 'the wall takes' "$work/slow"
then
    not_ok 'no false alarm at a fast wall' "$(cat "$work/slow")"
else
    ok 'no false alarm at a fast wall'
fi
echo 1..23
