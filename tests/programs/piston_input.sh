#!/bin/sh
# Bad commands and bad tables: one clear line, the right status.
. tests/programs/common
p=build/bin/piston

refuses 2 "'fly'.*run" $p --study fly
refuses 2 "method: 'euler'" $p --method euler
refuses 2 "step: '0'" $p --step 0
refuses 2 "step: 'nan'" $p --step nan
refuses 2 "mass: '-1'" $p --mass -1
refuses 2 "energies: '3' is not two numbers" $p --energies 3
refuses 2 "energies: '3,0' is not two numbers" $p --energies 3,0
refuses 2 "gas-masses: '1,-1' is not two" $p --gas-masses 1,-1
refuses 2 "start: 12 is not inside the box, 0 to 12" $p --start 12
refuses 2 "start: 0 is not inside" $p --start 0
refuses 2 "start to the right" $p --study cost --velocity 0
refuses 2 "study measure needs --table" $p --study measure
refuses 2 "is no decay" $p --study measure --table x --fit 0.01,0.1
refuses 2 "both go to" $p --summary -
refuses 2 "stray" $p stray

refuses 1 "nowhere: No such file" $p --study measure --table "$work/nowhere"
refuses 1 "nowhere/out" $p -o "$work/nowhere/out"

# Tables that bonkers did not write, or wrote only half.
head='# 1 t [s] time
# 2 energy [J] of all
# 3 x1 [m] mean
# 4 v1 [m/s] mean
# 5 T1 [J] mean
# 6 x2 [m] mean
# 7 v2 [m/s] mean
# 8 T2 [J] mean'
rows='0 4 1 0 1 5 0 3
1 4 1 0 1 5 0 3
2 4 1 0 1 7 0 3'
bad() { # NAME PATTERN TEXT
    printf '%s\n' "$3" >"$work/$1"
    refuses 1 "$1:$2" $p --study measure --body 2 --table "$work/$1"
}
bad short '10: fewer than three rows' "$head
$(echo "$rows" | sed 1d)"
bad plain '1: the head names no x, v and T' "$rows"
bad torn '10: a row without all its numbers' "$head
0 4 1 0 1 5 0 3
1 4 1 0 1 5 0"
bad letters '9: a row without all its numbers' "$head
0 4 1 0 one 5 0 3"
: >"$work/empty"
refuses 1 'empty: fewer than three rows' \
    $p --study measure --table "$work/empty"
printf '%s\n' "$head" "$rows" >"$work/good"
refuses 1 'good:9: the head names no x, v and T' \
    $p --study measure --body 3 --table "$work/good"
holds 'a table of two bodies is read' \
    $p --study measure --body 2 --window 1 --table "$work/good" \
    --summary "$work/s" -o /dev/null
holds 'its shares are one quarter and three' \
    awk '$1 == "share_start" { exit $2 != 0.75 }' "$work/s"
holds 'standard input is read as well' \
    sh -c "$p --study measure --body 2 --window 1 --table - -o /dev/null \
        <'$work/good'"
# A single run has no energies, but masses in its head: here 1 J and 3 J.
cat >"$work/single" <<'EOF'
# masses: 2 6
# 1 t [s] time
# 2 energy [J] of all
# 3 xL [m] of the left wall
# 4 vL [m/s] of the left wall
# 5 x1 [m] of mover 1
# 6 v1 [m/s] of mover 1
# 7 x2 [m] of mover 2
# 8 v2 [m/s] of mover 2
0 4 0 0 1 1 5 -1
1 4 0 0 2 1 4 -1
2 4 0 0 3 1 4 -1
EOF
holds 'a single run is read by its masses' \
    $p --study gases --body 2 --table "$work/single" -o "$work/gases"
holds 'energies, temperature and pressure are those of the run' \
    awk '!/^#/ && ++n == 3 { print
        right = ($2 == 4 && $3 == -1 && $4 == 3 && $5 == 1 && $6 == 0 && $7 == 2 && $9 == 0.5)
    } END { exit !right }' "$work/gases"
echo 1..28
