#!/bin/sh
# step against trajectories in quadruple precision: the 8th order method, two
# implicit ones and GSL's adaptive method, each at a tolerance of its own.
. tests/programs/common
here=tests/programs/trajectories
step=build/bin/step
scene=build/bin/scene

# The listing of the paper, as it is printed.
cat >"$work/sun-earth" <<'E2'
# filename: data.plist
#---- ID   x   y   z     m    c   r     color (rgb)
  pos  0  0.0 0.0 0.0   1.0  0.0 0.1    1.0 1.0 0.0
  pos  1  1.0 0.0 0.0   3e-6 0.0 0.03   0.3 0.3 1.0
#---- ID  vx   vy     vz
  vel  0  0.0  0.0   0.0
  vel  1  0.0 0.0172 0.0
#---- ID  x y z  // fixed=0, free=1
  vfix 0  1 1 0
  vfix 1  1 1 0
#---- gravitational Gauss constant
  k2  2.9584e-4
#---- time step
  dt  0.03
E2
$scene circumbinary -o "$work/circumbinary"
$scene figure-eight -o "$work/figure-eight"
$scene double-pendulum -o "$work/double-pendulum"
$scene double-pendulum --damping 0.5 -o "$work/double-pendulum-damped"

# follows NAME METHOD TOLERANCE OPTION...: the largest difference of a place
# or velocity to the reference, over all rows, in the units of the scene.
follows() {
    name=$1 method=$2 tolerance=$3
    shift 3
    what="$name by $method to $tolerance"
    worst=$($here/worst "$name" "$work/$name" "$method" "$@" 2>&1)
    if awk -v w="${worst:-nothing}" -v t="$tolerance" \
        'BEGIN { exit !(w ~ /^[0-9]/ && w + 0 <= t + 0) }'
    then ok "$what${SAY:+: $worst}"; else not_ok "$what" "differs by $worst"; fi
}

# Rounding adds up as the steps do, and along the orbit as their square: ten
# years of days come to 4e-12 with plain sums.
follows sun-earth kahan-li8 2e-11 --dt 1 --until 3650 --every 365 --sums plain
follows sun-earth kahan-li8 2e-13 --dt 1 --until 3650 --every 365
follows sun-earth gauss4 1e-6 --dt 1 --until 3650 --every 365
follows circumbinary kahan-li8 1e-11 --dt 0.5 --until 400 --every 50
follows figure-eight kahan-li8 1e-12 --dt 0.009884240598322205 \
    --until 6.3259139829262112 --every 0.7907392478657764
# Order 2 and the seed's own step: the error is the method's.
follows double-pendulum leapfrog 1e-2 --until 20 --every 0.5
follows double-pendulum kahan-li8 2e-12 --until 20 --every 0.5
# With friction in it the method is of the second order (chapter 8).
follows double-pendulum-damped kahan-li8 5e-8 --until 20 --every 0.5
follows double-pendulum-damped gauss4 1e-6 --until 20 --every 0.5

if $step "$work/sun-earth" --method rk8pd --until 0.03 -o "$work/got" \
    2>/dev/null; then
    follows sun-earth rk8pd 2e-11 --dt 5 --until 3650 --every 365
    follows circumbinary rk8pd 1e-11 --dt 5 --until 400 --every 50
    follows figure-eight rk8pd 1e-11 --dt 0.15814784957315528 \
        --until 6.3259139829262112 --every 0.7907392478657764
    follows double-pendulum rk8pd 1e-11 --dt 0.1 --until 20 --every 0.5
    follows double-pendulum-damped rk8pd 1e-11 --dt 0.1 --until 20 --every 0.5
else
    refuses 2 'no rk8pd; install GSL' $step "$work/sun-earth" --method rk8pd
fi
echo 1..14
