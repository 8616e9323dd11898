#!/bin/sh
# A run of step that is killed, at any moment and any number of times, ends
# with the bytes of one that was not.
. tests/programs/common
step=build/bin/step

# killed_at_checkpoint SCENE OPTION...: lets step go on with $work/part until
# it has written a checkpoint that is not the last one, and kills it then: so
# the speed of the machine does not matter. False if it ended before that.
killed_at_checkpoint() {
    cp "$work/part.checkpoint" "$work/last" 2>"$work/said" || : >"$work/last"
    $step "$@" -o "$work/part" --resume 2>"$work/said" &
    run=$!
    while kill -0 $run 2>"$work/said"; do
        if [ -e "$work/part.checkpoint" ] &&
            ! cmp -s "$work/last" "$work/part.checkpoint"; then
            kill -9 $run 2>"$work/said" || break
            wait $run 2>"$work/said"
            return 0
        fi
        sleep 0.01
    done
    wait $run
    return 1
}

# survives NAME OPTION...: killed again and again. It is fed the scene $scene.
survives() {
    run_of=$1
    shift
    $step "$scene" "$@" -o "$work/whole" 2>"$work/said" ||
        not_ok "$run_of" "$(cat "$work/said")"
    rm -f "$work"/part*
    killed=0
    while [ $killed -lt 4 ] && killed_at_checkpoint "$scene" "$@"; do
        killed=$((killed + 1))
    done
    $step "$scene" "$@" -o "$work/part" --resume 2>"$work/said"
    holds "$run_of: killed several times" test $killed -ge 3
    holds "$run_of: the same bytes" cmp "$work/whole" "$work/part"
    holds "$run_of: nothing is left beside the table" \
        sh -c "! ls '$work'/part.checkpoint '$work'/part.rows"
}

scene=$work/scene
{ cat tests/programs/rough.plist && echo dt 0.001; } >"$scene"
# A checkpoint after each bite of steps; about a second of a run.
survives 'damped leapfrog' --until 300 --every 0.5 --checkpoint 0
survives 'compensated sums' --until 300 --every 0.5 --checkpoint 0 \
    --compensated --observe t,energy,z:2 --track 1
survives 'an implicit method' --until 60 --every 0.1 --checkpoint 0 \
    --method gauss4
sed '/^damp/d; s/0.3$/0/' "$scene" >"$work/free"
scene=$work/free
if $step "$scene" --method rk8pd --until 0.001 -o "$work/whole" 2>/dev/null
then
    survives 'rk8pd' --until 30 --dt 0.01 --every 0.1 --checkpoint 0 \
        --method rk8pd
fi
build/bin/scene gas -o "$work/gas"
scene=$work/gas
survives 'contacts' --until 120 --every 0.5 --checkpoint 0 \
    --observe energy,momentum,collisions --track 3,5

# Rows that were written after the checkpoint are computed again.
scene=$work/free
$step "$scene" --until 9000 --every 0.5 -o "$work/whole"
rm -f "$work"/part*
killed_at_checkpoint "$scene" --until 9000 --every 0.5 --checkpoint 0
echo '9999 these are no numbers of ours' >>"$work/part.rows"
$step "$scene" --until 9000 --every 0.5 --checkpoint 0 --resume \
    -o "$work/part"
# shellcheck disable=SC2016
holds 'what was written behind the checkpoint is cut' sh -c '
    sed 2d "$1" >"$1.a"; sed 2d "$2" >"$2.a"; cmp "$1.a" "$2.a"' \
    sh "$work/whole" "$work/part"

# An interrupted run has its rows, says so, and can go on.
$step "$scene" --until 9000 --every 0.5 -o "$work/part" 2>"$work/told" &
run=$!
sleep 0.1
kill -TERM $run
wait $run
holds 'interrupted: status 1' test $? -eq 1
holds 'one line' grep -qx 'step: interrupted; [0-9]* % was done' "$work/told"
lines=$(wc -l <"$work/part")
holds 'the rows so far are in the table' \
    sh -c "test $lines -gt 25 && head -n $lines '$work/whole' | cmp - '$work/part'"
$step "$scene" --until 9000 --every 0.5 -o "$work/part" --resume
holds 'and the rest follows' cmp "$work/whole" "$work/part"

# What does not belong together is refused.
rm -f "$work"/part*
killed_at_checkpoint "$scene" --until 9000 --every 0.5 --checkpoint 0
refuses 2 'part.checkpoint: is of another command' \
    $step "$scene" --until 9000 --every 1 --checkpoint 0 -o "$work/part" --resume
cp "$work/part.checkpoint" "$work/kept"
cp "$work/part.rows" "$work/part.rows.kept"
sed '/^#= end/d' "$work/kept" >"$work/part.checkpoint"
again="$step $scene --until 9000 --every 0.5 --checkpoint 0 -o $work/part --resume"
# shellcheck disable=SC2086
refuses 2 'part.checkpoint: no checkpoint, or a damaged one' $again
sed '/^#= steps/d' "$work/kept" >"$work/part.checkpoint"
# shellcheck disable=SC2086
refuses 2 'part.checkpoint: no checkpoint, or a damaged one' $again
sed 's/^pos 1 .*/pos 1 0 0/' "$work/kept" >"$work/part.checkpoint"
# shellcheck disable=SC2086
refuses 2 'part.checkpoint:[0-9]*: ' $again
cp "$work/kept" "$work/part.checkpoint"
: >"$work/part.rows"
# shellcheck disable=SC2086
refuses 2 'part.rows: has fewer rows than the checkpoint says' $again
rm "$work/part.rows"
# shellcheck disable=SC2086
refuses 2 'part.rows: No such file' $again
# Each of these has been taken for a checkpoint once.
cp "$work/part.rows.kept" "$work/part.rows"
for garbled in 's/^#= length .*/#= length x/' '/^#= length/d' \
    's/^#= steps .*/#= steps -5/' 's/^#= steps .*/#= steps nan/' \
    's/^#= steps .*/#= steps 7.5/' 's/^#= steps .*/#= steps 1e300/' \
    's/^#= rows .*/#= rows 0/' 's/^#= end/#= accelerations 0\n&/'
do
    sed "$garbled" "$work/kept" >"$work/part.checkpoint"
    # shellcheck disable=SC2086
    refuses 2 'part.checkpoint: no checkpoint, or a damaged one' $again
done
for lines in 1 3 5 7; do
    head -n -$lines "$work/kept" >"$work/part.checkpoint"
    # shellcheck disable=SC2086
    refuses 2 'part.checkpoint: no checkpoint, or a damaged one' $again
done
cp "$work/kept" "$work/part.checkpoint"
sed -i '1s/1/2/' "$work/part.rows"
# shellcheck disable=SC2086
refuses 2 'part.rows: has other rows than the checkpoint says' $again

# Nor is another scene, of the same name. But the scene need not be there.
cp "$work/part.rows.kept" "$work/part.rows"
cp "$scene" "$work/scene.kept"
sed -i 's/^k2 .*/k2 0.2/' "$scene"
# shellcheck disable=SC2086
refuses 2 'is not the scene that .*part.checkpoint began with' $again
rm "$scene"
# shellcheck disable=SC2086
holds 'a run goes on without its scene' $again
# shellcheck disable=SC2016
holds 'and ends with the same bytes' sh -c '
    sed 2d "$1" >"$1.a"; sed 2d "$2" | cmp - "$1.a"' \
    sh "$work/whole" "$work/part"
cp "$work/scene.kept" "$scene"

# The scene of a checkpoint is read to its last line, and a damped leapfrog
# needs all of its accelerations.
scene=$work/scene
rm -f "$work"/part*
killed_at_checkpoint "$scene" --until 300 --every 0.5 --checkpoint 0
again="$step $scene --until 300 --every 0.5 --checkpoint 0 -o $work/part --resume"
cp "$work/part.checkpoint" "$work/kept"
for garbled in '/^vel 2/q' '/^k2/,$d' '/^kept 1/,$d' \
    's/^#= depth .*/#= depth inf/' 's/^#= energy .*/#= energy nan/'
do
    sed "$garbled" "$work/kept" >"$work/part.checkpoint"
    # shellcheck disable=SC2086
    refuses 2 'part.checkpoint: no checkpoint, or a damaged one' $again
done
for garbled in '/^kept 0/d' '/^kept [02]/d' 's/^kept 2 .*/kept 2 0 0/'; do
    sed "$garbled" "$work/kept" >"$work/part.checkpoint"
    # shellcheck disable=SC2086
    refuses 2 'part.checkpoint:[0-9]*: found .*, expected ' $again
done
cp "$work/kept" "$work/part.checkpoint"
# shellcheck disable=SC2086
holds 'as it was it goes on' $again
$step "$scene" --until 300 --every 0.5 --checkpoint 0 -o "$work/whole"
holds 'to the same bytes' cmp "$work/whole" "$work/part"
scene=$work/free
$step "$scene" --until 9000 --every 0.5 -o "$work/whole"

# The summary of a run in two parts has all of it but the times; leapfrog
# asks for one acceleration more.
# (Here there is one row, at the start, which the rest does not see.)
$step "$scene" --until 9000 --every 10000 -o "$work/a" --summary "$work/sa"
rm -f "$work"/part*
killed_at_checkpoint "$scene" --until 9000 --every 10000 --checkpoint 0
holds 'its rest' $step "$scene" --until 9000 --every 10000 --checkpoint 0 \
    -o "$work/part" --resume --summary "$work/sb"
# shellcheck disable=SC2016
holds 'the summary of a run in two parts' sh -c '
    for s in "$1" "$2"; do sed -i "/seconds/d;/per_second/d;/^eval/d;/^#/d" "$s"
    done; diff "$1" "$2"' sh "$work/sa" "$work/sb"

# On a full disk (here: a limit of the file) no row is lost that is not
# computed again.
for limit in 8 64; do
    for seconds in 0 60; do
        rm -f "$work"/part*
        # shellcheck disable=SC3045
        (ulimit -f $limit && $step "$scene" --until 1000 --every 0.5 \
            --checkpoint $seconds -o "$work/part") 2>"$work/said"
        holds 'a full disk: status 1' test $? -eq 1
        $step "$scene" --until 1000 --every 0.5 --checkpoint $seconds \
            -o "$work/part" --resume
        lines=$(wc -l <"$work/part")
        # shellcheck disable=SC2016
        holds 'a full disk: the same rows' sh -c '
            head -n "$3" "$1" | sed 2d >"$1.a"; sed 2d "$2" | cmp - "$1.a"' \
            sh "$work/whole" "$work/part" "$lines"
    done
done

# Without --resume the run begins anew.
$step "$scene" --until 9000 --every 0.5 -o "$work/part"
holds 'without --resume all begins anew' cmp "$work/whole" "$work/part"
