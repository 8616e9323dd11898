#!/bin/sh
# A run of step that is killed, at any moment and any number of times, ends
# with the bytes of one that was not.
. tests/programs/common
step=build/bin/step

# A run is stopped where a call of its own says so, and not by the clock: on a
# machine with much else to do a script that looks for a file now and then
# comes too late, and finds that the run has ended.
cat >"$work/at.c" <<'END'
#define _GNU_SOURCE
#include <dlfcn.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Raises the signal $AT_SIGNAL in the call number $AT_NUMBER of $AT_CALL. */
static void count(const char *call)
{
    static int calls;
    const char *wanted = getenv("AT_CALL");
    if (wanted && strcmp(wanted, call) == 0 &&
        ++calls == atoi(getenv("AT_NUMBER")))
        raise(atoi(getenv("AT_SIGNAL")));
}

int rename(const char *old, const char *new)
{
    int (*real)(const char *, const char *);
    *(void **)&real = dlsym(RTLD_NEXT, "rename");
    const int result = real(old, new);
    count("rename");
    return result;
}

int clock_gettime(clockid_t id, struct timespec *now)
{
    int (*real)(clockid_t, struct timespec *);
    *(void **)&real = dlsym(RTLD_NEXT, "clock_gettime");
    count("clock_gettime");
    return real(id, now);
}
END
${CC:-cc} -shared -fPIC -o "$work/at.so" "$work/at.c" -ldl || exit 1

# at CALL NUMBER SIGNAL COMMAND...: runs it, and has that call raise a signal.
at() {
    at_call=$1 at_number=$2 at_signal=$3
    shift 3
    env AT_CALL="$at_call" AT_NUMBER="$at_number" AT_SIGNAL="$at_signal" \
        LD_PRELOAD="$work/at.so" "$@"
}

# killed_at CALL NUMBER SCENE OPTION...: lets step go on with $work/part, and
# kills it there. False if it ended before.
killed_at() {
    call=$1 number=$2
    shift 2
    at "$call" "$number" 9 $step "$@" -o "$work/part" --resume 2>"$work/said"
    [ $? -eq 137 ]
}

# killed_at_checkpoint SCENE OPTION...: as soon as it has written a second
# checkpoint. (The last rename is that of the table.)
killed_at_checkpoint() { killed_at rename 2 "$@"; }

on_the_way=600 # of some 18000 such calls of the runs below: some 200 rows

# stopped SCENE OPTION...: begins a run in the background, as $run, and
# returns when it has stopped with rows in its file.
stopped() {
    AT_CALL=clock_gettime AT_NUMBER=$on_the_way AT_SIGNAL=19 \
        LD_PRELOAD=$work/at.so $step "$@" 2>"$work/err" &
    run=$!
    until ps -o stat= -p $run | grep -q T; do
        kill -0 $run 2>"$work/said" || break
        sleep 0.01
    done
    holds 'a run that has stopped on its way' test -s "$work/part.rows"
}

# survives NAME OPTION...: killed again and again. It is fed the scene $scene.
survives() {
    run_of=$1
    shift
    $step "$scene" "$@" -o "$work/whole" 2>"$work/said" ||
        not_ok "$run_of" "$(cat "$work/said")"
    rm -f "$work"/part*
    # Behind a checkpoint, and between two of them.
    killed=0
    for moment in 'rename 1' 'clock_gettime 7' 'rename 2' 'clock_gettime 4'; do
        # shellcheck disable=SC2086
        killed_at $moment "$scene" "$@" && killed=$((killed + 1))
    done
    $step "$scene" "$@" -o "$work/part" --resume 2>"$work/said"
    holds "$run_of: killed several times" test $killed -eq 4
    holds "$run_of: the same bytes" cmp "$work/whole" "$work/part"
    holds "$run_of: nothing is left beside the table" \
        sh -c "! ls '$work'/part.checkpoint '$work'/part.rows"
}

scene=$work/scene
{ cat tests/programs/rough.plist && echo dt 0.001; } >"$scene"
# A checkpoint after each bite of steps; about a second of a run.
survives 'damped leapfrog' --until 300.0004 --every 0.5 --checkpoint 0
survives 'compensated sums' --until 300.0004 --every 0.5 --checkpoint 0 \
    --sums compensated --observe t,energy,z:2 --track 1
survives 'an implicit method' --until 60 --every 0.1 --checkpoint 0 \
    --method gauss4
# Rows closer together than the steps: a checkpoint falls into a step.
survives 'a pair' --until 200.0004 --dt 0.01 --every 0.1 --checkpoint 0 \
    --method dopri5 --tolerance 1e-9
survives "Radau's method" --until 200.0004 --dt 0.01 --every 0.1 \
    --checkpoint 0 --method radau15
# Each tree is grown from the bodies in the order of their numbers.
rough=$scene scene=$work/ring
build/bin/scene ring --particles 300 -o "$scene"
survives 'a tree' --until 40000 --every 40 --checkpoint 0 --kernel tree --track 7
scene=$rough
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
$step "$scene" --until 3000 --every 0.5 -o "$work/whole"
rm -f "$work"/part*
killed_at_checkpoint "$scene" --until 3000 --every 0.5 --checkpoint 0
echo '9999 these are no numbers of ours' >>"$work/part.rows"
$step "$scene" --until 3000 --every 0.5 --checkpoint 0 --resume \
    -o "$work/part"
# shellcheck disable=SC2016
holds 'what was written behind the checkpoint is cut' sh -c '
    sed 2d "$1" >"$1.a"; sed 2d "$2" >"$2.a"; cmp "$1.a" "$2.a"' \
    sh "$work/whole" "$work/part"

# An interrupted run has its rows, says so, and can go on.
at clock_gettime $on_the_way 15 $step "$scene" --until 3000 --every 0.5 -o "$work/part" \
    2>"$work/told"
holds 'interrupted: status 1' test $? -eq 1
holds 'one line' grep -qx 'step: interrupted; [0-9]* % was done' "$work/told"
lines=$(wc -l <"$work/part")
holds 'the rows so far are in the table' \
    sh -c "test $lines -gt 25 && head -n $lines '$work/whole' | cmp - '$work/part'"
$step "$scene" --until 3000 --every 0.5 -o "$work/part" --resume
holds 'and the rest follows' cmp "$work/whole" "$work/part"

# What does not belong together is refused.
rm -f "$work"/part*
killed_at_checkpoint "$scene" --until 3000 --every 0.5 --checkpoint 0
refuses 2 'part.checkpoint: is of another command' \
    $step "$scene" --until 3000 --every 1 --checkpoint 0 -o "$work/part" --resume
again="$step $scene --until 3000 --every 0.5 --checkpoint 0 -o $work/part --resume"
# (Nor are rows or a checkpoint that somebody has changed: tests/library/checkpoint.c.)

# Nor is another scene, of the same name. But the scene need not be there.
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

# A damped leapfrog needs its accelerations.
scene=$work/scene
rm -f "$work"/part*
killed_at_checkpoint "$scene" --until 300 --every 0.5 --checkpoint 0
again="$step $scene --until 300 --every 0.5 --checkpoint 0 -o $work/part --resume"
# shellcheck disable=SC2086
holds 'as it was it goes on' $again
$step "$scene" --until 300 --every 0.5 --checkpoint 0 -o "$work/whole"
holds 'to the same bytes' cmp "$work/whole" "$work/part"
scene=$work/free
$step "$scene" --until 3000 --every 0.5 -o "$work/whole"

# The summary of a run in two parts has all of it but the times; leapfrog
# asks for one acceleration more.
# (Here there is one row, at the start, which the rest does not see.)
$step "$scene" --until 3000 --every 10000 -o "$work/a" --summary "$work/sa"
rm -f "$work"/part*
killed_at_checkpoint "$scene" --until 3000 --every 10000 --checkpoint 0
holds 'its rest' $step "$scene" --until 3000 --every 10000 --checkpoint 0 \
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

# What is kept has a checkpoint, or is not kept.
rm -f "$work"/part*
# shellcheck disable=SC3045
(ulimit -f 8 && $step "$scene" --until 1000 --every 0.5 \
    -o "$work/part") 2>"$work/said"
holds 'rows without a checkpoint are not left' sh -c "
    ! ls '$work/part.rows' || ls '$work/part.checkpoint'"
at clock_gettime $on_the_way 1 $step "$scene" --until 3000 --every 0.5 -o "$work/part" \
    2>"$work/said"
holds 'nor after the terminal was closed' ls "$work/part.rows" \
    "$work/part.checkpoint"
$step "$scene" --until 3000 --every 0.5 -o "$work/part" --resume
holds 'and that run goes on' cmp "$work/whole" "$work/part"

# Two runs do not write one table, and what is copied into it is what was
# written.
stopped "$scene" --until 3000 --every 0.5 -o "$work/part"
for resume in '' --resume; do
    # shellcheck disable=SC2086
    refuses 2 'part.rows: another run is writing it' \
        $step "$scene" --until 3000 --every 0.5 -o "$work/part" $resume
done
kill -CONT $run
wait $run
holds 'the first run is not disturbed' cmp "$work/whole" "$work/part"
rm -f "$work"/part*
stopped "$scene" --until 3000 --every 0.5 -o "$work/part"
printf 7 | dd of="$work/part.rows" bs=1 seek=30 conv=notrunc 2>"$work/said"
kill -CONT $run
wait $run
holds 'rows that somebody has changed: status 1' test $? -eq 1
holds 'it says so' grep -q 'part.rows: has other rows than were written' \
    "$work/err"
holds 'and there is no table of them' test ! -e "$work/part"

# Without --resume the run begins anew.
$step "$scene" --until 3000 --every 0.5 -o "$work/part"
holds 'without --resume all begins anew' cmp "$work/whole" "$work/part"
echo 1..57
