#!/bin/sh
# Scenes made to mislead bonk, in misleading/, each with its story. Every
# pick is held against a run of another kind: step with many small steps of
# a high order, or disks by events. The error must be within the tolerance,
# and what looks as if it could be left out must not be.
. tests/programs/common
bonk=build/bin/bonk
step=build/bin/step
here=tests/stability/misleading
w=$work

# apart A B SCALE: the largest difference of a place in any row, over SCALE.
apart() { awk -v scale="$3" -f tests/stability/apart.awk "$1" "$2"; }

# check SCENE UNTIL E REFERENCE: runs bonk; the table of the other run is
# there. The true error is within E, and within a tenth of what was found
# or, where that is closer, of E: that is what an estimate is good for. With
# contacts a fifth: the finest companion may itself be off by an eighth.
check() {
    holds "$1 at $3" $bonk "$here/$1.plist" --until "$2" --tolerance "$3" \
        -o "$w/picked" --summary "$w/summary"
    error=$(apart "$w/picked" "$4" "$(key "$w/summary" scale)")
    found=$(key "$w/summary" error_found)
    holds "$1 at $3: error $error, found $found" awk -v e="$3" \
        -v error="$error" -v found="$found" -v part="${5:-10}" 'BEGIN {
            exit !(error ~ /[0-9]/ && error <= e && found <= e &&
                error <= found + e / part) }'
}
model() { holds "$1 takes $2" grep -q "^model $2" "$w/summary"; }
never() { holds "$1 does not take $2" sh -c "! grep -q '^model.*$2' $w/summary"; }

# steps SCENE UNTIL METHOD NUMBER [CONTACT]: the other run, so many steps in
# each row.
steps() {
    more=${5:+--contact $5}
    every=$(awk -v t="$2" 'BEGIN { printf "%.17g", t / 16 }')
    dt=$(awk -v d="$every" -v n="$4" 'BEGIN { printf "%.17g", d / n }')
    # shellcheck disable=SC2086
    $step "$here/$1.plist" --until "$2" --method "$3" --dt "$dt" \
        --every "$every" $more -o "$w/reference"
}
# held SCENE UNTIL METHOD NUMBER E...: both, for each of the tolerances.
held() {
    steps "$1" "$2" "$3" "$4"
    scene=$1 until=$2
    shift 4
    for e; do check "$scene" "$until" "$e" "$w/reference"; done
}
# within NAME E: what was picked, against the other run.
within() {
    error=$(apart "$w/picked" "$w/reference" "$(key "$w/summary" scale)")
    holds "$1: error $error" awk -v error="$error" -v e="$2" \
        'BEGIN { exit !(error ~ /[0-9]/ && error <= e + 0) }'
    rm -f "$w/picked"
}
# rows SCENE UNTIL EVERY E [BONK'S OPTIONS]: the pick with rows of its own.
rows() {
    scene=$1 until=$2 every=$3 e=$4
    shift 4
    holds "$scene $*" $bonk "$here/$scene.plist" --until "$until" \
        --every "$every" --tolerance "$e" -o "$w/picked" \
        --summary "$w/summary" "$@"
    within "$scene $*" "$e"
}
# by SCENE UNTIL EVERY METHOD DT [OPTIONS]: the other run with rows of its own.
by() {
    scene=$1 until=$2 every=$3 method=$4 dt=$5
    shift 5
    $step "$here/$scene.plist" --until "$until" --every "$every" \
        --method "$method" --dt "$dt" "$@" -o "$w/reference"
}

# A comet after nine tenths of the run, at a fifteenth of the distance.
held late-comet 30 kahan-li8 1500 1e-3 1e-6

# Eccentricity .99 from its slow end.
held apocentre 6.2 kahan-li8 3000 1e-3 1e-6

# A small mass in resonance must not be left out at 1e-3, though for the
# first two turns it could be.
held resonant 200 kahan-li8 400 1e-3
never resonant no-light
holds 'resonant: nobody notices it in two turns' $bonk \
    "$here/resonant.plist" --until 12.5 --tolerance 1e-3 \
    --model kepler,no-light -o "$w/t"
refuses 1 'kepler,no-light is off by' $bonk "$here/resonant.plist" \
    --until 200 --tolerance 1e-3 --model kepler,no-light -o "$w/t2"
holds 'resonant: nothing is left in its place' test ! -e "$w/t2"

# Nothing stretches the stiff spring, so it costs no small steps: it would
# take 36000 of them in all.
cheap() { holds 'never-stretched: no small steps' awk \
    -v c="$(key "$w/summary" cost)" 'BEGIN { exit !(c < 1e-4) }'; }
steps never-stretched 10 gauss4 200
check never-stretched 10 1e-3 "$w/reference"
cheap
check never-stretched 10 1e-6 "$w/reference"
cheap

# Far and heavy is not nothing.
held far-and-heavy 3 kahan-li8 100 1e-3 1e-6
never far-and-heavy no-

# Equal masses but for one part in a million: 2e-6 m/s at each collision.
sed 's/^walls.*/walls hard hard open/; s/^box.*/box 0 4 -9 9 0 0/' \
    "$here/but-for-one.plist" >"$w/plane"
$bonk "$w/plane" --until 200 --tolerance 1e-9 --model disks -o "$w/reference"
check but-for-one 200 1e-9 "$w/reference"
never but-for-one relabel

# Nearly a line: nobody may take it for one when 1e-9 has grown to the
# tolerance. The other run has its zero in the corner of
# its box, where a place of 1e-9 is rounded as 9 is: after twenty seconds
# that has grown to 3e-7, which it says itself.
sed 's/^walls.*/walls hard hard open/; s/^box.*/box 0 3 -9 9 0 0/' \
    "$here/nearly-line.plist" >"$w/plane"
for t in 5 20; do
    $bonk "$w/plane" --until $t --tolerance 1e-6 --model disks \
        -o "$w/reference$t"
done
check nearly-line 5 1e-6 "$w/reference5"
never nearly-line no-across
check nearly-line 20 1e-5 "$w/reference20"
never nearly-line no-across

# After a hundred turns two bodies meet at a millionth, where steps are to be
# short; rows say nothing of it, least of all if there is one only. Truth: the
# comet by 34 digits. Even steps by hand are off, and that is said.
for every in 40 640; do
    holds "far-meeting, row by row of $every" $bonk \
        "$here/far-meeting.plist" --until 640 --every $every \
        --tolerance 1e-3 --observe x:2,y:2 -o "$w/picked"
    holds 'far-meeting: the comet' awk -v x=1.1963289936 -v y=0.473502370025 \
        '!/^#/ { a = $2 - x; b = $3 - y }
        END { exit !(NR > 0 && a * a < 3.6e-6 && b * b < 3.6e-6) }' "$w/picked"
    rm -f "$w/picked"
done
refuses 1 'off by' $bonk "$here/far-meeting.plist" \
    --until 640 --tolerance 1e-3 --model pefrl:20480 --reason 60 -o "$w/far"
holds 'far-meeting: nothing is left in its place' test ! -e "$w/far"

# What a grain does is nothing, until the star multiplies it.
held weak-first 6 kahan-li8 100000 1e-3
never weak-first no-light

# A grain that the finer of two runs leapt over as well as the coarser: 8.5e-6
# was found, wrong by 3.9e-4. And a mass that both leapt over, out of rest on a
# stiff spring: 5.2e-4 was found, wrong by 9.1e-3.
by both-leap 7.7 0.48125 radau15 0.48125 --tolerance 1e-13
check both-leap 7.7 8.2e-5 "$w/reference"
located() { # NAME UNTIL EVERY E
    by "$1" "$2" "$3" radau15 "$3" --tolerance 1e-13 --contact located
    rows "$@"
}
located leapt-over 0.0287032833 2.87032833e-05 6.7e-3
# Two that stepped alike agreed: 4.6e-5 was found, wrong by 1.4e-3.
located alike-steps 3.7434677922642612 1.8717338961321306 9.5e-4

# By rounding a ball misses another that it overlaps by 2.4e-15: 1.4e-6 was
# found, wrong by 5.4e-6. No run can say.
refuses 1 'rounding' $bonk "$here/by-a-hair.plist" \
    --until 2.319346000313404 --tolerance 5.3e-6 -o "$w/t13"

# Rows at which the body is at rest: the ball is met in between.
turn=6.2831853071795862
by small-ball $turn $turn leapfrog ${turn}e-6
for plan in '' '--model leapfrog:15'; do
    # shellcheck disable=SC2086
    rows small-ball $turn $turn 1e-2 $plan
done
# The same with points on a line, which no step is sure to see.
sed '/^pos/s/ 0.001$/ 0/' "$here/small-ball.plist" >"$w/points"
refuses 1 'points on a line collide only' $bonk "$w/points" --until 6 \
    --tolerance 1e-2 -o "$w/t4"

# Twelve steps, twice and four times as many agree to a millionth where the
# spring turns round, and are all wrong by six per cent. What is right is
# known: between two ends it swings about 1 m, and then about -1 m.
for t in 50 63; do
    awk -v t=$t 'BEGIN {
        q = atan2(sqrt(5), -2)  # 1 + 1.5 cos q = 0
        for (k = 0; k <= 16; ++k) {
            s = k * t / 16; s -= 4 * q * int(s / (4 * q))
            x = s < q ? 1 + 1.5 * cos(s) : s < 3 * q ? \
                -1 - 1.5 * cos(s - 2 * q) : 1 + 1.5 * cos(4 * q - s)
            printf "%.17g 0 0 0 0 0 0 %.17g 0 0 0 0 0\n", k * t / 16, x
        } }' >"$w/reference"
    check through-anchor $t 1e-2 "$w/reference"
    check through-anchor $t 1e-3 "$w/reference"
done
for n in 12 24 48; do
    refuses 1 'off by' $bonk "$here/through-anchor.plist" --until 63 \
        --tolerance 1e-2 --model pefrl:$n -o "$w/t5"
done

# A ball thrown on a parabola grazes another one, on a chord that is a
# fortieth of it; a grain without mass passes another at a millionth of what
# its way bends; springs stiffer than any step are stretched; and a ball that
# bounces once does so in the second half of a step, or in the first.
steps grazing 3.3 leapfrog 250 located
check grazing 3.3 1e-3 "$w/reference"
by bent-way 3.2 0.2 dopri5 0.01 --tolerance 1e-12
check bent-way 3.2 1e-3 "$w/reference"
# What no step can follow two modes can, with squares (3 +- sqrt 5)/2 of D/m.
holds 'stiff-stretched' $bonk "$here/stiff-stretched.plist" --until 160 \
    --tolerance 1e-2 -o "$w/picked" --summary "$w/summary"
model stiff-stretched oscillator
holds 'stiff-stretched: its places' awk '!/^#/ { x = y = 0
        for (r = -1; r < 2; r += 2) {
            l = (3 + r * sqrt(5)) / 2
            q = (1 + (2 - l) * 2.5) / (1 + (2 - l)^2) * cos(1e7 * sqrt(l) * $1)
            x += q; y += (2 - l) * q
        }
        d = ($8 - x)^2 + ($14 - y)^2; most = d > most ? d : most; ++rows }
    END { exit !(rows == 17 && most < 1e-10) }' "$w/picked"
# Whatever is held against it has steps to pay for: 3 s tell as well as 60.
refuses 1 'beyond reason' $bonk "$here/stiff-stretched.plist" --until 160 \
    --tolerance 1e-2 --model gauss4:1 --reason 3 -o "$w/t7"
for t in 0.61 0.68 0.733 0.912; do
    steps one-bounce $t leapfrog 12000
    check one-bounce $t 1e-3 "$w/reference" 5
done

# A contact at half a thousandth of a row before a row ends is late by the
# same in every run that has this end for the end of a step; and so is all
# that follows. The truth is a parabola.
awk 'BEGIN {
    for (k = 0; k <= 16; ++k) {
        t = k * 1.0000625 / 16; s = t <= 0.5 ? t : 1 - t
        printf "%.17g 0 %.17g 0 0 0 0 0 0 0 0 0 0\n", t, 1.45 - 5 * s * s
    } }' >"$w/reference"
check row-end 1.0000625 1e-4 "$w/reference" 5
check row-end 1.0000625 1e-5 "$w/reference" 5

# A swing that dies in RK4, whatever the step, and loses its phase in the
# implicit methods: two runs agree, and both are wrong. The true error of the
# pick before: 3.7e-4, where 5e-7 had been found.
held dies-out 8 kahan-li8 1000 3e-4 1e-5
for plan in rk4:160 gauss4:64 implicit-midpoint:64; do
    refuses 1 'off by' $bonk "$here/dies-out.plist" --until 8 \
        --tolerance 1e-4 --model $plan -o "$w/t8"
done

# An error that is the sum of two orders: half the step differs by a fourth of
# it. True before: 2.0e-7 for a tolerance of 1e-7, with 4.8e-8 found.
held two-orders 19.6782 rk4 2000 1e-7 1e-8

# A swing that is small, fast, and pushes what is slow. True before: 1.2e-3,
# with 1.3e-4 found. And a pull that decides how deep a graze is: true before,
# without the pull: 5.3e-5, with 7.6e-6 found.
by slow-push 7.6041 0.1901025 rk4 9.5051249999999999e-05
rows slow-push 7.6041 0.1901025 3e-4
by pulled-graze 2.8164808211694012 0.40235440302420017 leapfrog \
    1.3411813434140006e-06
rows pulled-graze 2.8164808211694012 0.40235440302420017 1e-5

# A dashpot that turns round with its spring. True before: 2.9e-5 at 9.7e-6,
# with 8.6e-6 found.
held axial-turn 0.4083612484591192 rk4 4000 9.7e-6

# Starts that every step makes another scene of, chosen or by hand.
for scene in overlap outside; do
    refuses 1 'at the start bodies overlap' $bonk "$here/$scene.plist" \
        --until 3 --tolerance 1e-3 -o "$w/t11"
    refuses 1 'at the start bodies overlap' $bonk "$here/$scene.plist" \
        --until 3 --tolerance 1e-3 --model leapfrog:100 -o "$w/t11"
done

# Passages in which RK4 loses energy, in half the step as well. True before:
# 7.8e-2 with 3.6e-3 found at 1e-2, of x alone.
held plunge 8 kahan-li8 50000 0.5 1e-2
never plunge rk4

# A clock that is the same number in all units of mass: 1e6 s at 1e-12 were
# granted with 2.8e-16 found, and wrong by 3.4e-11. What is refused here is a
# tenth of it, wrong by 2.3e-11 of 0.4. Truth: the place
# 0.4 cos(wt) + 0.3 sin(wt)/w, w = sqrt(2), by 34 digits and by 50.
refuses 1 'rounding' $bonk "$here/long-swing.plist" --until 1e5 \
    --tolerance 1e-13 -o "$w/t10"
holds 'long-swing' $bonk "$here/long-swing.plist" --until 1e6 --every 1e6 \
    --tolerance 1e-9 --observe x:1 -o "$w/picked" --summary "$w/summary"
model long-swing oscillator
holds 'long-swing: its place' awk '!/^#/ { d = $2 - 0.45275091099883398 }
    END { exit !(d * d < 1e-18 * 0.16) }' "$w/picked"

# A period that is a difference: 1e-7 was granted with 1.5e-8 found, and wrong
# by 4.1e-7. Truth: the place by 34 digits, of two bodies of 1 and 0.0189.
refuses 1 'rounding decides' $bonk "$here/wound-clock.plist" --until 115236 \
    --tolerance 1e-7 --reason 5 -o "$w/t10"
holds 'wound-clock' $bonk "$here/wound-clock.plist" --until 115236 \
    --every 115236 --tolerance 1e-5 --observe x:1,y:1 -o "$w/picked" \
    --summary "$w/summary"
model wound-clock kepler
holds 'wound-clock: its place' awk -v found="$(key "$w/summary" error_found)" \
    '!/^#/ { x = ($2 - 0.075348602276626151662) / 0.0185704
        y = ($3 - 15793.789279719716147) / 0.0185704 }
    END { exit !(x * x < found * found && y * y < found * found) }' "$w/picked"

# Forces that might jump, and do not, or by next to nothing. And
# modes of a turn that nothing holds, which are known to rounding.
held never-meet 1.9 rk4 4000 2e-6
steps weak-kink 5.9 rk4 8191
check weak-kink 5.9 3e-5 "$w/reference" 5
held neutral-turn 288 kahan-li8 200 1.6e-3
model neutral-turn modes

# A heavy body remembers for longer than blocks can see: 0.6556 was given,
# with two errors of 0.0097, where the mean of the whole run is 0.6226.
refuses 1 'does not settle' $bonk "$here/remembers.plist" --until 829.5 \
    --tolerance 0.01 --observe mean:x:7 -o "$w/t9"

# One row only: whoever is late by whole turns agrees with himself.
t=117.45341159552609
by whole-turns $t $t kahan-li8 0.0058726705797763045
rows whole-turns $t $t 1e-2

# A ball that bounces under friction, every time lower; and two points that
# pass each other so near that a disk would have been hit.
steps bounces 2.374372754265058 kahan-li8 1000 located
check bounces 2.374372754265058 1e-3 "$w/reference"
held passing-points 0.8 leapfrog 8 1e-3

# Whether it grazes, places so far away are too coarse to say: 1.6e-11 was
# found, wrong by 2.9e-6. The other run has the held ball at the origin, which
# changes no distance.
far=4408.0983678277962 t=1.0099892090330702
moved() { awk -v far="$1" -v columns="$2" 'BEGIN { n = split(columns, c) }
    !/^#/ && ($1 == "pos" || $1 + 0 == $1) { for (i = 1; i <= n; ++i)
        $c[i] = sprintf("%.17g", $c[i] + far) }
    { print }'; }
moved -$far 3 <"$here/far-graze.plist" >"$w/near"
$step "$w/near" --until $t --every 0.063124325564566888 --method kahan-li8 \
    --dt 0.00063124325564566888 --contact located -o "$w/near-rows"
moved $far '2 8' <"$w/near-rows" >"$w/reference"
check far-graze $t 4.8e-9 "$w/reference"

# Two of the finest runs there are agreed by chance: 2.1e-5 was found, wrong by
# 4.3e-5. A third one says that it is rounding that decides.
refuses 1 'rounding' $bonk "$here/alike-by-chance.plist" \
    --until 6.0576892286630963 --every 0.030288446143315482 \
    --tolerance 3.4e-5 -o "$w/t12"

# A twin erred by chance as the run did: 4.0e-11 was found, wrong by 9.5e-10.
# Of six twins at least one is far away. The last row is that of an
# extrapolation in 113 bits; its velocities are not compared.
hair=$here/twin-by-chance.plist
{
    printf '1.5'
    printf ' %s %s 0 0 0 0' \
        0.2130065907132234909 0.5830614856708043281 \
        0.4427454592375480847 0.4891100250951567419 \
        0.3418965695169474202 0.2480991979947531944 \
        0.8566297135830740713 0.3312723849312450663 \
        0.6454314039468474239 0.8578981419038174531 \
        0.6126450174358714194 0.2614817449264247834
} >"$w/reference"
for e in 1e-3 4.7e-9; do
    holds "twin-by-chance at $e" $bonk "$hair" --until 1.5 --tolerance $e \
        -o "$w/all" --summary "$w/summary"
    awk '$1 == 1.5' "$w/all" >"$w/picked"
    error=$(apart "$w/picked" "$w/reference" "$(key "$w/summary" scale)")
    found=$(key "$w/summary" error_found)
    holds "twin-by-chance at $e: error $error, found $found" awk -v e=$e \
        -v error="$error" -v found="$found" 'BEGIN {
            exit !(error > 9e-10 && error <= found && found <= e) }'
done
for e in 4.2e-11 9e-10; do
    refuses 1 'horizon' $bonk "$hair" --until 1.5 --tolerance $e -o "$w/t14"
done

# The cheapest way is not the one whose first run promises most. Of the pair
# leapfrog:160 is off by eight times the scene: taken for an error of the second
# order that foretold a price of eleven times pefrl:112, which was picked at 2.3
# times the price of leapfrog:192. The sixth order was not tried at all, where
# leapfrog:288 costs 1.9 times as much. Truth: kahan-li8, which differs from
# runs in long double by less than 2e-7 of the scene.
costs() { # SCENE PRICE: no more than a hundredth above this, s
    holds "$1 costs $2 s" awk -v c="$(key "$w/summary" cost)" -v most="$2" \
        'BEGIN { exit !(c > 0 && c <= 1.01 * most) }'
}
held lost-pair 3 kahan-li8 1000 1e-2
model lost-pair leapfrog:192
costs lost-pair 1.435e-4
held uneven-fall 120 kahan-li8 400 1e-2
model uneven-fall yoshida6:22
costs uneven-fall 1.708e-4

# What was run until it held has a price; of the others the story says that
# the order promises one, and of a method that is lost it says none.
$bonk "$here/uneven-fall.plist" --until 120 --tolerance 1e-2 --explain \
    -o "$w/t13" >"$w/story"
holds 'uneven-fall: a price that was not paid is a promise' grep -q \
    'a row; by its order pefrl would cost [0-9.]* times as much$' "$w/story"
holds 'and is none where the error is that of another way' grep -q \
    '^  kahan-li8:[0-9]* .* too far off to go on$' "$w/story"
echo 1..153
