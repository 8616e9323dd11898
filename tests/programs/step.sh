#!/bin/sh
# step: closed forms, every option, every error, and runs that blow up.
. tests/programs/common
step=build/bin/step
scene=build/bin/scene
w=$work

# near NAME GOT EXPECTED TOLERANCE
near() {
    holds "$1: $2 is $3 to $4" awk -v a="$2" -v b="$3" -v e="$4" \
        'BEGIN { d = a - b; exit !(a ~ /[0-9]/ && d <= e && -d <= e) }'
}
# cell ROW COLUMN FILE: of the rows, the first is 1.
cell() { grep -v '^#' "$3" | awk -v r="$1" -v c="$2" 'NR == r { print $c }'; }

# Sun and Earth: the period is 2 pi/k = 365.301 days, for masses of 1 and
# 0; leapfrog with 5000 steps an orbit is right to 2 pi (2 pi/5000)^2.
cat >"$w/sun" <<'E2'
pos 0  0 0 0  1 0 0.1
pos 1  1 0 0  0 0 0.1
vel 1  0 0.0172 0
k2 2.9584e-4
E2
$step "$w/sun" --dt 0.073060294269530 --until 365.30147134765 \
    --every 365.30147134765 -o "$w/t" --summary "$w/s"
near 'a year later: x' "$(cell 2 8 "$w/t")" 1 1e-6
near 'a year later: y' "$(cell 2 9 "$w/t")" 0 1e-5
near 'in steps' "$(key "$w/s" steps)" 5000 0
near 'evaluations' "$(key "$w/s" evaluations)" 5001 0
near 'rows' "$(key "$w/s" rows)" 2 0
holds 'it ends whole' grep -qx 'end whole' "$w/s"
near 'energy' "$(key "$w/s" energy_start)" 0 1e-12

# A file whose name has the end of a line in it: the head stays a head.
two_lines=$(printf '%s/sun\nand moon' "$w")
cp "$w/sun" "$two_lines"
$step "$two_lines" --dt 1 --until 1 --every 1 -o "$w/t"
near 'a name of two lines: rows that are not the head' \
    "$(grep -vc '^#' "$w/t")" 2 0
holds 'and it is written in one' grep -q "sun'\$'.n''and moon'" "$w/t"

# An oscillator, damped: q = e^(-t/10) (cos wt + sin(wt)/(10 w)), w^2 = .99.
cat >"$w/oscillator" <<'E2'
pos 0  0 0 0  1 0 0.1
pos 1  1 0 0  1 0 0.1
vfix 0  0 0 0
s 0  1 0
sl 0 1 0
dis 1  0.5 0 0
damp 0.2
dt 0.001
E2
exact=$(awk 'BEGIN { w = sqrt(.99); t = 10
    printf "%.12f", 1 + .5 * exp(-t / 10) * (cos(w*t) + sin(w*t) / (10 * w)) }')
for method in leapfrog rk4 implicit-midpoint gauss4; do
    $step "$w/oscillator" --method $method --until 10 --observe x:1,energy \
        --every 10 -o "$w/t"
    near "damped oscillator by $method" "$(cell 2 2 "$w/t")" "$exact" 2e-7
done

# A fall, by hand: z = -t^2, v = -2 t, leapfrog exact.
cat >"$w/fall" <<'E2'
pos 0  0 0 0  3 0 0
pos 1  5 0 0  1 0 0
grav 0 0 -2
dt 0.25
E2
$step "$w/fall" --until 2 --every 0.5 --track 1,0 --observe t,parts -o "$w/t"
holds 'every row is a multiple' sh -c "grep -v '^#' '$w/t' | cut -d ' ' -f 1 |
    tr '\n' ' ' | grep -qx '0 0.5 1 1.5 2 '"
holds 'a row: time, observables, the bodies tracked' \
    test "$(grep -v '^#' "$w/t" | tail -n 1)" = \
    '2 2 32 0 0 -32 5 0 -4 0 0 -4 0 0 -4 0 0 -4'
holds 'a column for each' test "$(grep -c '^# [0-9]* [^ ]* \[' "$w/t")" -eq 18
holds 'named by body' grep -q '^# 9 z:1 \[length\]' "$w/t"
$step "$w/fall" --until 2.1 -o "$w/a" --summary "$w/s" 2>"$w/told"
near 'what is left of the time is a step' "$(key "$w/s" steps)" 9 0
$step "$w/fall" -o "$w/a" --summary "$w/s"
near 'without --until a thousand steps' "$(key "$w/s" steps)" 1000 0
near 'and a hundred rows' "$(key "$w/s" rows)" 101 0
$step "$w/fall" --observe energy -o "$w/a" --summary "$w/s"
near 'or a thousand' "$(key "$w/s" rows)" 1001 0
$step "$w/fall" --until 0 -o "$w/a"
holds 'no step at all: one row' test "$(grep -vc '^#' "$w/a")" -eq 1
$step - --until 2 <"$w/fall" >"$w/a"
$step "$w/fall" --until 2 | sed 2d >"$w/b"
sed -i 2d "$w/a"
holds 'the scene may come from a pipe' cmp "$w/a" "$w/b"

mkfifo "$w/pipe"
cat "$w/fall" >"$w/pipe" &
$step "$w/pipe" --until 2 -o "$w/a"
sed -i 2d "$w/a"
holds 'and from a pipe with a name' cmp "$w/a" "$w/b"

# --every changes no bit; nor do threads; a saved scene goes on.
$scene ring --particles 200 -o "$w/ring"
$step "$w/ring" --until 400 --every 400 --track 7 -o "$w/a"
$step "$w/ring" --until 400 --every 4 --track 7 -o "$w/b"
holds '--every changes nothing' \
    test "$(tail -n 1 "$w/a")" = "$(tail -n 1 "$w/b")"
$step "$w/ring" --until 400 --every 4 --track 7 --threads 2 -o "$w/c"
holds 'nor do two threads' cmp "$w/b" "$w/c"
$step "$w/ring" --until 400 --every 400 -o "$w/a" --sums compensated
$step "$w/ring" --until 200 -o "$w/c" --sums compensated --save "$w/half"
$step "$w/half" --until 400 --every 200 -o "$w/c"
holds 'a saved scene goes on to the same bits' \
    test "$(tail -n 1 "$w/a")" = "$(tail -n 1 "$w/c")"

# Saved at a row in the middle, a scene goes on to the rows of a run in one
# piece, by every method, with friction and without, compensated or not. The
# step is 1/128, so that no time is rounded.
# goes_on NAME SCENE OPTION...
goes_on() {
    run_of=$1 begun=$2
    shift 2
    set -- "$@" --dt 0.0078125 --every 0.25
    : >"$w/b"
    $step "$begun" "$@" --until 8 -o "$w/a" &&
        $step "$begun" "$@" --until 4 -o "$w/c" --save "$w/saved" &&
        $step "$w/saved" "$@" --until 8 -o "$w/b"
    grep -v '^#' "$w/a" | tail -n 17 >"$w/whole"
    grep -v '^#' "$w/b" >"$w/rest"
    holds "$run_of: half of the rows" test "$(wc -l <"$w/rest")" -eq 17
    holds "$run_of goes on to the same bytes" cmp "$w/whole" "$w/rest"
    # Half a step more is a step of half the length.
    : >"$w/a"
    $step "$begun" "$@" --until 4.00390625 -o "$w/a" 2>"$w/told"
    $step "$w/saved" "$@" --dt 0.00390625 --every 0.00390625 \
        --until 4.00390625 -o "$w/b"
    holds "$run_of: half a step more" \
        test "$(tail -n 1 "$w/a")" = "$(tail -n 1 "$w/b")"
}
cp tests/programs/rough.plist "$w/rough"
sed '/^damp/d; s/0.3$/0/' "$w/rough" >"$w/free"
methods=$(methods)
own=$(echo "$methods" | wc -l)
holds 'there are methods' test "$own" -gt 1
$step "$w/free" --method rk8pd --dt 1 --until 1 -o "$w/a" 2>"$w/said" &&
    methods="$methods rk8pd"
for method in $methods; do
    for from in free rough; do
        goes_on "$from, $method" "$w/$from" --method "$method"
        [ "$method" = rk8pd ] || goes_on "$from, $method, compensated" \
            "$w/$from" --method "$method" --sums compensated
    done
done
# Along ellipses, where there are some.
$scene solar-system --planets 3 -o "$w/planets"
for method in wisdom-holman sbab4; do
    goes_on "planets, $method" "$w/planets" --method $method
    refuses 2 "$method: the scene has" $step "$w/rough" --method $method
done
refuses 2 'kernel: means nothing' $step "$w/planets" --kernel portable \
    --method sbab4
# And where others compute the forces, or bodies meet.
$scene membrane --nx 6 --ny 5 --damping 0.2 -o "$w/damped"
goes_on 'a damped membrane' "$w/damped"
$scene ring --particles 20 -o "$w/a"
{ cat "$w/a"; echo 'damp 1e-9'; } >"$w/damped"
goes_on 'a damped ring' "$w/damped"
$scene cradle -o "$w/a"
{ cat "$w/a"; echo 'damp 0.1'; } >"$w/damped"
goes_on 'a damped cradle' "$w/damped"
goes_on 'a damped cradle, compensated' "$w/damped" --sums compensated

# What leapfrog has kept matters, and a part of it is no scene.
$step "$w/rough" --dt 0.01 --until 4 -o "$w/c" --save "$w/saved"
holds 'an acceleration for each body' test "$(grep -c '^kept ' "$w/saved")" -eq 3
sed '/^kept/d' "$w/saved" >"$w/less"
last() { $step "$@" --until 8 --track 2 -o "$w/a" && tail -n 1 "$w/a"; }
holds 'without what was kept it is another run' \
    test "$(last "$w/saved")" != "$(last "$w/less")"
for option in '--method rk4' '--method yoshida4' '--dt 0.005'; do
    # shellcheck disable=SC2086
    holds "but not with $option" \
        test "$(last "$w/saved" $option)" = "$(last "$w/less" $option)"
done
sed '/^kept 1/d' "$w/saved" >"$w/less"
refuses 2 "less:[0-9]*: found 'kept', expected one for each of the 3 bodies" \
    $step "$w/less"
$step "$w/saved" --method rk4 --until 5 -o "$w/a" --save "$w/c"
holds 'nobody else keeps one' sh -c "! grep '^kept' '$w/c'"
$step "$w/ring" --until 400 --every 400 -o "$w/b"
$step "$w/ring" --until 400 --every 400 --kernel portable -o "$w/c" \
    --summary "$w/s"
holds 'portable is what auto takes' test "$(tail -n 1 "$w/b")" = \
    "$(tail -n 1 "$w/c")"
holds 'the summary names the kernel' grep -qx 'kernel portable' "$w/s"
# Of loops that are compiled for several processors, this one's.
vectors=plain
has() { grep -m 1 '^flags' /proc/cpuinfo | grep -qw "$1"; }
if nm "${step%% *}" | grep -q ' add_portable\.avx2$'; then
    if has avx2; then vectors=avx2; fi
    if has avx512f && has avx512vl && has avx512dq && has avx512bw; then
        vectors=avx512
    fi
fi
holds 'and the instructions' grep -qx "vectors $vectors" "$w/s"
fewer=0
if $step "$w/ring" --until 400 --every 400 --kernel avx512 -o "$w/c" \
    2>"$w/told"; then
    near 'avx512 is another rounding' "$(cell 2 2 "$w/c")" \
        "$(tail -n 1 "$w/b" | cut -d ' ' -f 2)" 1e-11
    holds 'and not the same bits' \
        test "$(tail -n 1 "$w/b")" != "$(tail -n 1 "$w/c")"
    holds 'avx512 stands in the head' \
        grep -q '^# command: .*--kernel avx512' "$w/c"
else
    holds 'avx512: this machine has none' \
        grep -qx 'step: --kernel: this machine has no avx512' "$w/told"
    fewer=2
fi

# A tree errs less with less of theta, and with none as rounding does. What it
# has wrong is the ring's own pull, some 1e-5 of the planet's.
for theta in 0 0.2 0.5; do
    $step "$w/ring" --until 400 --every 400 --kernel tree --theta $theta \
        -o "$w/tree$theta" --summary "$w/s$theta"
    tail -n 1 "$w/tree$theta" >"$w/last"
    tail -n 1 "$w/b" | awk 'NR == FNR { split($0, a); next }
        { for (i = 2; i <= NF; ++i) { d = $i - a[i]; if (d * d > m) m = d * d } }
        END { print sqrt(m) }' "$w/last" - >"$w/off$theta"
done
holds "the tree: $(echo $(cat "$w"/off*)) off" awk -v a="$(cat "$w/off0")" \
    -v b="$(cat "$w/off0.2")" -v c="$(cat "$w/off0.5")" \
    'BEGIN { exit !(a < 1e-11 && a < b && b < c && c < 1e-4) }'
holds 'the tree: the energy as by pairs' awk -v a="$(key "$w/s0.5" energy_error)" \
    -v b="$(key "$w/s0" energy_error)" 'BEGIN { exit !(a < 2 * b) }'
holds 'the tree is named' grep -qx 'kernel tree' "$w/s0.5"
$step "$w/ring" --until 400 --every 400 --kernel tree -o "$w/c" --threads 2
holds 'the tree: a half is what it takes, and two threads the same bytes' test \
    "$(tail -n 1 "$w/c")" = "$(tail -n 1 "$w/tree0.5")"
refuses 2 "theta: means nothing without --kernel tree" $step "$w/ring" --theta 0.4
refuses 2 "theta: '0.58' is not a number from 0 to 0.57" $step "$w/ring" \
    --kernel tree --theta 0.58
for method in dopri5 radau15 gauss4 implicit-midpoint rk8pd; do
    refuses 2 "kernel: the forces of a tree jump .* --method $method wants" \
        $step "$w/ring" --kernel tree --method $method
done
refuses 2 'kernel: means nothing without gravity of more than 32' \
    $step "$w/fall" --kernel tree

# Blow-ups: what came before stays, one line, status 1.
$scene double-pendulum -o "$w/pendulum"
refuses 1 'blew up after t = [0-9.]* (energy -0.8568, now [0-9.e+]*): try' \
    $step "$w/pendulum" --dt 0.03 --until 30 --every 0.03 -o "$w/t" \
    --summary "$w/s"
holds 'rows before are there' test "$(grep -vc '^#' "$w/t")" -gt 3
holds 'and no row that is nonsense' awk \
    '!/^#/ { for (i = 1; i <= NF; ++i) if ($i * $i > 1e4) exit 1 }' "$w/t"
holds 'the summary says why' grep -qx 'end energy' "$w/s"
holds 'nothing is left beside it' test ! -e "$w/t.checkpoint"
refuses 1 'blew up after t = .* (infinite coordinates): try' \
    $step "$w/pendulum" --dt 0.03 --until 300 --bound 1e300 -o "$w/t"
refuses 1 'blew up after t = ' \
    $step "$w/pendulum" --dt 0.01 --method euler --until 300 -o "$w/t"
refuses 1 'blew up after t = ' \
    $step "$w/pendulum" --dt 0.04 --method leapfrog --until 300 -o -
# But Euler's spiral has no more energy than there was: it is a run.
holds 'a spiral is no blow-up' $step "$w/sun" --dt 1 --method euler \
    --until 3650 -o "$w/t"
printf 'pos 0 0 0 0 1 0 0\npos 1 1 0 0 1 0 0\nk2 1\nsoft 0.001\ndt 0.01\n' \
    >"$w/meet"
refuses 1 'blew up' $step "$w/meet" --until 10 --every 0.01 -o "$w/t"

# At rest there is the energy of rounding errors, and it is no blow-up.
$scene membrane --amplitude 0 -o "$w/rest"
holds 'a grid at rest' $step "$w/rest" --observe energy -o "$w/t"
$scene cantilever --gravity 0 --dx 0.3 --dy 0.7 -o "$w/rest"
holds 'a beam at rest' $step "$w/rest" --observe energy -o "$w/t"

# Wrong commands.
refuses 2 'a scene is needed' $step
refuses 2 "there is a scene already, '$w/sun'" $step "$w/sun" "$w/fall"
refuses 2 'cannot read' $step "$w/none" --until 1
refuses 2 'line dt' $step "$w/sun" --until 1
refuses 2 "dt: '0'" $step "$w/sun" --dt 0
refuses 2 "dt: 1e-300 takes more than 9e15 steps" \
    $step "$w/sun" --dt 1e-300 --until 1
refuses 2 "until: 'soon'" $step "$w/sun" --until soon
refuses 2 'until: 1 is before the scene.s time, 200' $step "$w/half" --until 1
refuses 2 'every: 0.3 is no whole number of steps of 0.25; the nearest is 0.25' \
    $step "$w/fall" --every 0.3
refuses 2 'every: 0.1 .*the nearest is 0.25' $step "$w/fall" --every 0.1
refuses 2 "'magic'.*leapfrog" $step "$w/fall" --method magic
for method in $(methods); do
    holds "the refusal knows $method" grep -q " $method[, ]" "$work/err"
    holds "--help has a phrase for $method" \
        sh -c "$step --help | grep -q ' $method, order [0-9]*: [a-zA-Z]'"
done
refuses 2 "kernel: 'sse'" $step "$w/fall" --kernel sse
refuses 2 "rule: 'none'" $step "$w/fall" --rule none
refuses 2 "shift: 'none'" $step "$w/fall" --shift none
refuses 2 "order: 'none'" $step "$w/fall" --order none
refuses 2 "threads: '0'" $step "$w/fall" --threads 0
refuses 2 "bound: '0'" $step "$w/fall" --bound 0
refuses 2 "tolerance: '2'" $step "$w/fall" --tolerance 2
refuses 2 "checkpoint: '-1'" $step "$w/fall" --checkpoint -1
refuses 2 "observe: 'heat' is no observable" $step "$w/fall" --observe heat
refuses 2 "observe: 'z:2': z needs 1 of the bodies 0 to 1" \
    $step "$w/fall" --observe t,z:2
refuses 2 "track: '2' does not begin with one of the bodies 0 to 1" \
    $step "$w/fall" --track 2
refuses 2 "track: 'x' does not begin" $step "$w/fall" --track 0,x
refuses 2 'track: more bodies than there are' $step "$w/fall" --track 0,1,0
refuses 2 'resume: means nothing without --output' $step "$w/fall" --resume
for option in '--checkpoint 1' --resume; do
    # shellcheck disable=SC2086
    refuses 2 'means nothing without -o FILE, a regular file' \
        $step "$w/fall" $option -o /dev/null
done
refuses 2 "both go to '-'" $step "$w/fall" --summary -
refuses 1 'cannot write' $step "$w/fall" -o "$w/none/t"
refuses 1 'cannot write' $step "$w/fall" --save "$w/none/t" -o "$w/t"
printf 'pos 0 0 0 0 0 0 0\npos 1 1 0 0 1 0 0\ns 0 1 0\nsl 0 1 0\ndt 1\n' \
    >"$w/light"
refuses 2 'body 0 has no mass' $step "$w/light"
printf 'pos 0 0 0 0 1 0 0\ngrav 0 0 x\n' >"$w/bad"
refuses 2 'bad:2: ' $step "$w/bad"

# An adaptive method meets its contacts too: a ball that falls from 1 m by
# 2 m/s^2 is back there after 2 s, and after 20. Its 2 m/s at the floor are
# rounded by 2.2e-16 in each way down and each way up, and so is the height.
printf 'pos 0 0 0 1 1 0 .125\ngrav 0 0 -2\nbox 0 0 0 0 -.125 9
walls open open hard\ncontact\ndt 1\n' >"$w/ball"
$step "$w/ball" --method radau15 --contact located --until 20 --observe z:0 \
    -o "$w/t" --summary "$w/s"
near 'back up: z' "$(tail -n 1 "$w/t" | awk '{ print $2 }')" 1 4.4e-15
near 'back up: bounces' "$(key "$w/s" collisions)" 10 0
# A contact may wait in its step then, of which no checkpoint knows.
for option in '--checkpoint 5' --resume; do
    # shellcheck disable=SC2086
    refuses 2 "${option% *}: means nothing with located adaptive steps" $step \
        "$w/ball" --method radau15 --contact located --until 20 -o "$w/t" \
        $option
done
$step "$w/ball" --method leapfrog --contact located --until 2 -o "$w/t" \
    --checkpoint 0
holds "steps of one length keep checkpoints" test $? -eq 0

# Two bodies in one place: no row, and not the advice to take a smaller step.
printf 'pos 0 0 0 0 1 0 0\npos 1 0 0 0 1 0 0\nk2 1\ndt 1\n' >"$w/same"
refuses 2 'the energy at the start is -inf, expected a number: are two' \
    $step "$w/same" -o "$w/no"
holds 'and no file' sh -c "! ls '$w'/no*"

# Nor is the scene written over by a companion of the table.
for suffix in .rows .checkpoint; do
    cp "$w/fall" "$w/mine$suffix"
    refuses 2 "output: '$w/mine$suffix' is the scene" \
        $step "$w/mine$suffix" -o "$w/mine"
    holds 'the scene is as it was' cmp "$w/fall" "$w/mine$suffix"
    rm -f "$w/mine$suffix"
done
refuses 2 "save: '$w/t.rows' is a companion" \
    $step "$w/fall" -o "$w/t" --save "$w/t.rows"
refuses 2 "summary: '$w/t.checkpoint' is a companion" \
    $step "$w/fall" -o "$w/t" --summary "$w/t.checkpoint"

# Where a run has ended, another one may end too; and half a step is none.
$step "$w/fall" --dt 1.1 --until 3.3 --every 3.3 -o "$w/t" --save "$w/later"
$step "$w/later" --until 3.3 -o "$w/a" --summary "$w/s"
near 'no step to where we are' "$(key "$w/s" steps)" 0 0
refuses 2 'every: 1e+09 is no whole number' \
    $step "$w/fall" --dt 1.6 --every 1000000000.5

# An end between two steps has a shorter one, and says so.
$step "$w/fall" --dt 2 --until 3 --track 1 -o "$w/t" --summary "$w/s" \
    --save "$w/later" 2>"$w/told"
holds 'the last row is the end' test "$(echo $(grep -v '^#' "$w/t" |
    cut -d ' ' -f 1))" = '0 2 3'
holds 'it is said' test "$(cat "$w/told")" = 'step: --until: 3 is no whole '\
'number of steps of 2: the last one is shorter, 1'
near 'in the summary too' "$(key "$w/s" last_step)" 1 0
near 'as one step more' "$(key "$w/s" steps)" 2 0
near 'with its row' "$(key "$w/s" rows)" 3 0
near 'at its time' "$(key "$w/s" time)" 3 0
holds 'what is saved has the step of the others' grep -qx 'dt 2' "$w/later"
holds 'and the time of the end' grep -qx 'time 3' "$w/later"
$step "$w/fall" --dt 1e30 --until 3 --track 1 -o "$w/t" 2>"$w/told"
holds 'a step may be longer than the run' test "$(echo $(grep -v '^#' "$w/t" |
    cut -d ' ' -f 1))" = '0 3'
$step "$w/fall" --dt 0.25 --every 1 --until 2.3 --track 1 -o "$w/t" 2>"$w/told"
holds 'the end has a row between the others' \
    test "$(echo $(grep -v '^#' "$w/t" | cut -d ' ' -f 1))" = '0 1 2 2.2999999999999998'
$step "$w/fall" --until 2 -o "$w/t" --summary "$w/s" 2>"$w/told"
holds 'otherwise there is nothing to say' test ! -s "$w/told"
near 'and the last step is as long as the others' \
    "$(key "$w/s" last_step)" "$(key "$w/s" dt)" 0

# Standard output that is a file has no companions.
$step "$w/fall" --until 2 -o /dev/stdout 2>"$w/told" >"$w/b"
holds '/dev/stdout may be a file' test $? -eq 0
holds 'and has the rows' test "$(grep -vc '^#' "$w/b")" -eq 9

# A run that ends and is wrong says so: Euler's oscillator, (1 + h^2)^n, and
# leapfrog at its limit, which keeps the energy and shows nothing of the motion.
$scene oscillator --damping 0 -o "$w/spring"
$step "$w/spring" --method euler --dt 0.04 --until 20 -o "$w/a" \
    --summary "$w/s" 2>"$w/told"
holds 'an energy that grew is seen' grep -q 'note: .* 122 % of its' "$w/told"
near 'by the law' "$(key "$w/s" energy_error)" 1.2241185545 1e-9
holds 'the summary says it' grep -qx 'note energy' "$w/s"
$step "$w/spring" --dt 2 --until 200 -o "$w/a" --summary "$w/s" 2>"$w/told"
near 'at the limit no energy tells' "$(key "$w/s" energy_error)" 0 0
holds 'the step does' grep -q 'note: omega dt .* 2, and leapfrog' "$w/told"
holds 'and the summary' grep -qx 'note step' "$w/s"
$step "$w/spring" --dt 0.3 --until 300 -o "$w/a" --summary "$w/s" 2>"$w/told"
holds 'a healthy run says nothing' test ! -s "$w/told"
holds 'nor does its summary' grep -qx 'note none' "$w/s"
$scene oscillator --damping 0.1 -o "$w/damped"
$step "$w/damped" --until 20 -o "$w/a" --summary "$w/s" 2>"$w/told"
holds 'friction may take the energy' test ! -s "$w/told"

# One that blows up between two rows says what was seen last, and when.
$step "$w/spring" --dt 3 --until 30000 --every 30000 -o "$w/a" \
    --summary "$w/s" 2>"$w/told"
near 'infinite: when it was seen last' "$(key "$w/s" time)" 384 0
holds 'and what' awk '$1 == "energy_error" && $2 > 1e200 { seen = 1 }
    END { exit !seen }' "$w/s"
$step "$w/spring" --method rk4 --dt 2.9 --until 29000 --every 29000 \
    -o "$w/a" --summary "$w/s" 2>"$w/told"
near 'too much: when' "$(key "$w/s" time)" 29000 0
near 'and how much' "$(key "$w/s" energy_error)" 19.2587 1e-4

# The minimum setup writes what step does.
cat >"$w/data.plist" <<'E2'
pos 0  0 0 0  1.0  0 0.1
pos 1  1 0 0  3e-6 0 0.03
vel 1  0 0.0172 0
k2  2.9584e-4
dt  25
E2
build/bin/orbit "$w/data.plist" >"$w/a"
$step "$w/data.plist" --until 50000 --every 25 --observe x:1,y:1 |
    grep -v -e '^#' -e '^0 ' | awk '{ printf "%.9g %.9g %.9g\n", $1, $2, $3 }' \
    >"$w/b"
holds 'ten lines of C do what step does' cmp "$w/a" "$w/b"
refuses 2 'none' build/bin/orbit "$w/none"
refuses 2 "'--dt'" build/bin/orbit --dt 1
refuses 2 'one SCENE' build/bin/orbit "$w/data.plist" "$w/data.plist"
for option in --help --version; do
    holds "orbit knows $option" build/bin/orbit $option
done
if [ -e /dev/full ]; then
    build/bin/orbit "$w/data.plist" >/dev/full 2>"$w/told"
    holds 'ten lines of C notice a full disk' test $? -eq 1
fi
sed 's/^dt .*/dt 0.1/' "$w/pendulum" >"$w/wild"
build/bin/orbit "$w/wild" >"$w/a" 2>"$w/told"
holds 'and a run that blew up' test $? -eq 1
# What contacts after steps cannot see is told, or refused (tests/library/motion.c);
# found by trials of the second edition, where it ended whole, with note none.
cat >"$w/fast" <<'E2'
pos 0 -1 0 0 1 0 0.013
pos 1 1 0 0 1 0 0.013
vel 0 1 0 0
vel 1 -1 0 0
contact
dt 0.3
E2
for contact in contact 'linear 1000'; do
    sed "s/^contact/$contact/" "$w/fast" >"$w/pass"
    $step "$w/pass" --until 3 -o /dev/null -S "$w/s" 2>"$w/told"
    holds "$contact: who passes another unseen is told" \
        grep -q 'passed through each other within a step, 1 time (bodies 0 and 1' "$w/told"
    holds 'in the summary, too' grep -qx 'note passed' "$w/s"
    $step "$w/pass" --until 3 --dt 0.003 -o /dev/null -S "$w/s" 2>"$w/told"
    holds 'and not where short steps see them' grep -qx 'note none' "$w/s"
done
$step "$w/fast" --until 3 --contact located -O collisions -o "$w/t" -S "$w/s"
holds 'nor where their moment is found' grep -qx 'note none' "$w/s"
sed 's/^pos 1 1/pos 1 -0.98/' "$w/fast" >"$w/over"
$step "$w/over" --until 3 -o /dev/null -S "$w/s" 2>"$w/told"
holds 'who overlaps at the start is told' \
    grep -q 'at the start bodies overlapped.* by 0.006,' "$w/told"
holds 'in the summary, too' grep -qx 'note overlap' "$w/s"
echo "1..$((183 + 14 * own - fewer))"
