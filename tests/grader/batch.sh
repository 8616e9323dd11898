#!/bin/sh
# A batch that is interrupted goes on, and grades nothing twice; what is late
# is tried once more; what a student deserves depends on his file, the seed
# and nothing else.
topic='batch'
. tests/grader/hostile/kit

# ---- which exercises, which options ----

kit
usage() { # TEXT OPTION...
    words=$1
    shift
    (cd "$scratch/kit" && build/grade/grade "$@") >"$scratch/said" 2>&1
    status=$?
    ended 2 || return 1
    grep -q -e "$words" "$scratch/said" && [ "$(wc -l <"$scratch/said")" -le 2 ] ||
        why "$(cat "$scratch/said")"
}
mkdir -p "$scratch/none" "$scratch/one/anna"
echo 'int x;' >"$scratch/one/anna/01a-collide.c"
verdict 'no jobs' usage "--jobs: '0'" --jobs 0 "$scratch/one"
verdict 'half a job' usage "--jobs: '1.5'" --jobs 1.5 "$scratch/one"
verdict 'a word for a seed' usage "--hidden: 'abc'" --hidden abc "$scratch/one"
verdict 'a seed below zero' usage "--hidden: '-1'" --hidden -1 "$scratch/one"
verdict 'a seed of 65 bits' usage '--hidden' --hidden 18446744073709551616 \
    "$scratch/one"
verdict 'no time' usage "--seconds: '0'" --seconds 0 "$scratch/one"
verdict 'an unknown report' usage "'pdf'" --report junit,pdf "$scratch/one"
verdict 'part of the name of a report' usage "'jun'" --report jun \
    "$scratch/one"
verdict 'a report that is written in any case' usage "'csv'.* always" \
    --report junit,csv "$scratch/one"
verdict 'an unknown exercise' usage "'99z'" --exercises 99z "$scratch/one"
verdict 'an unknown exercise among known ones' usage "'99z'" \
    --exercises 01a,99z "$scratch/one"
verdict 'an unknown option' usage '--help' --fast "$scratch/one"
verdict 'no folder' usage 'which folder' --jobs 1
verdict 'two folders' usage 'which folder' "$scratch/one" "$scratch/none"
verdict 'a folder that is not there' usage 'No such file' "$scratch/nowhere"
verdict 'a folder without students' usage 'neither' "$scratch/none"
verdict 'a file for a folder' usage 'Not a directory' "$scratch/kit/build/grade/flags"
verdict 'an output that is a file' usage 'flags' --output build/grade/flags \
    "$scratch/one"
nothing() {
    set -- "$scratch"/kit/build/grade/work.*
    [ ! -e "$1" ] || why "there is $1"
}
verdict 'after a wrong command nothing is left' nothing

# ---- interrupted ----

# Ten students, who take half a second each; all files differ.
for n in 0 1 2 3 4 5 6 7 8 9; do
    honest "$scratch/ten" && mkdir -p "$scratch/ten/s$n" &&
        { cat "$scratch/ten/honest/01a-collide.c" && echo "/* $n */"; } \
            >"$scratch/ten/s$n/01a-collide.c"
done
graded() {
    find "$scratch/out" -name '01a.json' 2>/dev/null | wc -l
}
# interrupt SIGNAL: begins a batch, and stops it when some are graded.
interrupt() {
    before=$(graded)
    out=$scratch/out
    (cd "$scratch/kit" && exec build/grade/grade --exercises 01a --jobs 2 \
        --hidden "$seed" --seconds 2 --output "$out" \
        "$scratch/ten") >"$scratch/said" 2>&1 </dev/null &
    batch=$!
    tries=0
    while [ "$(graded)" -lt $((before + 3)) ] && [ $tries -lt 300 ]; do
        sleep 0.1
        tries=$((tries + 1))
    done
    kill "-$1" "$batch"
    wait "$batch" 2>/dev/null
    status=$?
}
halfway() {
    [ "$(graded)" -ge 3 ] && [ "$(graded)" -lt 12 ] || why "$(graded) graded"
}
whole() { # every result that there is, is one
    for file in "$scratch"/out/marks/*; do
        [ -e "$file/01a.json" ] || continue
        name=${file##*/}
        case $name in
        partly) judged partly failed $((full - first)) || return 1 ;;
        *) judged "$name" passed "$full" || return 1 ;;
        esac
    done
}
told() {
    grep -q -e "$1" "$scratch/said" || why "$(cat "$scratch/said")"
}
stamps() {
    (cd "$scratch/out/marks" && ls -i --time-style=full-iso -l ./*/01a.json)
}
interrupt INT
verdict 'a batch that is interrupted says so' ended 2
verdict 'and says how to go on' told 'interrupted with [0-9]* of 12'
verdict 'it was half done' halfway
verdict 'what was done is whole' whole
verdict 'nothing is left' nothing
stamps >"$scratch/first"
interrupt KILL
verdict 'what was done before a batch was killed is whole' whole
stamps >"$scratch/second"
kept() { # FILE: all that is in it is as it was
    stamps | sort >"$scratch/now"
    sort "$1" | comm -23 - "$scratch/now" >"$scratch/lost"
    [ ! -s "$scratch/lost" ] || why "graded again: $(cat "$scratch/lost")"
}
verdict 'a batch that goes on grades nothing again' kept "$scratch/first"
grade "$scratch/ten" "$scratch/out" --seconds 2
verdict 'a batch that was killed goes on' ended 0
verdict 'and grades nothing again' kept "$scratch/second"
all() {
    [ "$(graded)" -eq 12 ] || why "$(graded) graded"
}
verdict 'in the end all are graded' all
verdict 'and as they deserve' whole
parts() {
    left=$(find "$scratch/out" -name '*.part')
    [ -z "$left" ] || why "$left"
    nothing
}
verdict 'no half file is left of it' parts

# In the middle of a test: the program in the sandbox must not outlive the batch.
cat >"$scratch/wait.c" <<'END'
#define _GNU_SOURCE
#include "exercise.h"
#include <sys/prctl.h>
#include <unistd.h>

static void trick(void)
{
    prctl(PR_SET_NAME, "bonkers-waits", 0, 0, 0);
    for (;;)
        pause();
}
END
prepare "$scratch/wait.c" "$scratch/wait/anna"
alive() {
    ps -eo comm= 2>/dev/null | grep -q bonkers-waits
}
outlived() { # SIGNAL
    (cd "$scratch/kit" && exec build/grade/grade --exercises 01a \
        --seconds 30 --output "$scratch/waited" "$scratch/wait") \
        >"$scratch/said" 2>&1 </dev/null &
    batch=$!
    tries=0
    while ! alive && [ $tries -lt 600 ]; do
        sleep 0.1
        tries=$((tries + 1))
    done
    if ! alive; then
        # What comes late must not be there when other tests look.
        kill -TERM "$batch"
        wait "$batch"
        why 'it did not come to its test in a minute' || return 1
    fi
    kill "-$1" "$batch"
    wait "$batch" 2>/dev/null
    tries=0
    while alive && [ $tries -lt 30 ]; do
        sleep 0.1
        tries=$((tries + 1))
    done
    ! alive || why 'it lives on'
}
for signal in INT TERM HUP KILL; do
    verdict "with a batch that gets SIG$signal ends the program in its sandbox" \
        outlived "$signal"
done

# ---- graded again or not ----

stamps >"$scratch/first"
changed() { # NAME...: these and no others have been graded again
    stamps | sort >"$scratch/now"
    sort "$scratch/first" | comm -13 - "$scratch/now" |
        sed 's|.*/\([^/]*\)/01a.json|\1|' | sort | tr '\n' ' ' >"$scratch/again"
    stamps >"$scratch/first"
    [ "$(cat "$scratch/again")" = "$*${1:+ }" ] ||
        why "graded again: $(cat "$scratch/again")"
}
grade "$scratch/ten" "$scratch/out" --seconds 2
verdict 'the same command grades nothing' changed
grade "$scratch/ten" "$scratch/out" --seconds 2 --jobs 1 --report junit
verdict 'other reports and jobs grade nothing' changed
echo '/* again */' >>"$scratch/ten/s3/01a-collide.c"
echo 'int x;' >"$scratch/ten/s5/01a-collide.c"
touch "$scratch/ten/s6/01a-collide.c"
grade "$scratch/ten" "$scratch/out" --seconds 2
verdict 'what was edited is graded again, what was touched is not' \
    changed s3 s5
verdict 'and as it deserves now' judged s5 'does not build' 0
rm "$scratch/ten/s7/01a-collide.c"
grade "$scratch/ten" "$scratch/out" --seconds 2
verdict 'what was taken away earns nothing' judged s7 'not begun' 0
stamps >"$scratch/first"
echo '{"key": "' >"$(result s8)"
grade "$scratch/ten" "$scratch/out" --seconds 2
verdict 'a result that is damaged is made again' changed s8

# ---- late ----

# A loop for one pair of masses; a crash for another; a program that is late
# for some seconds after now, as on a machine with too much to do; one that
# is always late.
late() { # NAME CODE
    mkdir -p "$scratch/late/$1"
    cat >"$scratch/late/$1/01a-collide.c" <<END
#include "exercise.h"
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    const double centre = (im2 * u1 + im1 * u2) / (im1 + im2);
    $2
    v[0] = 2.0 * centre - u1;
    v[1] = 2.0 * centre - u2;
}
END
}
late one 'while (u1 == 2.0 && im1 == 0.25)
        ;'
late crash 'if (u1 == 2.0 && im1 == 0.25)
        abort();'
late idle 'v[0] = u1, v[1] = u2;
    return;'
late z-always 'for (;;)
        pause();'
# All begin at once, and he is the last to be tried again: some ten seconds
# from now, for one before him takes six of them, and three at his second try.
late zz-once "while (u1 == 3.0 && time(NULL) < $(date +%s) + 7)
        sleep(1);"
grade "$scratch/late" "$scratch/out" --jobs 4
verdict 'a batch with programs that are late ends well' ended 0
again() { # NAME TRIES
    grep -q "^ \"tries\": $2," "$(result "$1")" ||
        why "$(grep tries "$(result "$1")")"
}
second=$(awk '/^test/ && ++n == 2 { print $2 }' build/grade/01a.list)
verdict 'a loop costs the points of its test alone' \
    judged one 'timed out' $((full - second))
# Unless the clock on the wall was first, because this machine is busy: a loop
# of ours has less than three quarters of a processor, too.
busy() {
    from=$(date +%s.%N)
    sh -c 'i=0; while [ $i -lt 2000000 ]; do i=$((i + 1)); done; times' |
        awk -v from="$from" 'NR == 1 { gsub(/m/, " "); gsub(/s/, "")
            "date +%s.%N" | getline now
            exit !(60 * ($1 + $3) + $2 + $4 < 0.75 * (now - from)) }'
}
once() {
    for try in 1 2 3; do
        again one 1 && return
        rm "$(result one)"
        grade "$scratch/late" "$scratch/out" --jobs 1
    done
    busy && echo '# note: too busy here to tell a loop by the time it computes'
}
verdict 'by the time of a processor, which needs no second try' once
verdict 'a crash costs the points of its test alone' \
    judged crash crashed $((full - second))
verdict 'it was tried once' again crash 1
verdict 'who does nothing has nothing, whatever that conserves' \
    judged idle failed 0
verdict 'who was late once has all points' judged zz-once passed "$full"
verdict 'at the second try' again zz-once 2
verdict 'who is always late has none' judged z-always 'timed out' 0
waited() {
    [ "$(grep -c '^   "state": "timed out"' "$(result z-always)")" -eq 3 ] ||
        why "$(grep '^   "state"' "$(result z-always)" | sort | uniq -c)"
}
verdict 'and after three tests nobody waits for him any more' waited
stamps >"$scratch/first"
grade "$scratch/late" "$scratch/out"
verdict 'nobody is tried a third time' changed

# He ends in 0.4 s of the processor, loops for that pair, and ends in 1.3 s.
late slow 'const double wanted = u1 == u2 ? 0.4 : im1 * im2 == 0.0 ? 1.3 : 0.0;
    while ((double)clock() < wanted * CLOCKS_PER_SEC)
        ;
    while (u1 == 2.0 && im1 == 0.25)
        ;'
mkdir "$scratch/slow" && mv "$scratch/late/slow" "$scratch/slow"
grade "$scratch/slow" "$scratch/out" --seconds 4
his_time() {
    judged slow 'timed out' $((full - second)) && return
    busy && echo '# note: too busy here to tell who is slow'
}
verdict 'who is slow and ends keeps his time when one test is late' his_time

# ---- the seed ----

# Somebody who has learnt all inputs that he has seen, and what belongs to
# them. They are taken from the suite by a function that writes them down.
cat >"$scratch/pen.c" <<'END'
#include <stdio.h>
#include <unistd.h>

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2]);

void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    const double centre = (im2 * u1 + im1 * u2) / (im1 + im2);
    dprintf(4, "{%a, %a, %a, %a},\n", u1, u2, im1, im2);
    v[0] = 2.0 * centre - u1;
    v[1] = 2.0 * centre - u2;
}
END
compiler=$(sed -n 1p build/grade/flags)
libraries=$(sed -n '2s/^[^ ]* //p' build/check/flags)
# shellcheck disable=SC2086
$compiler -Isrc -o "$scratch/pen" "$scratch/pen.c" tests/exercises/01a/hidden.c \
    tests/exercises/01a/suite.c build/grade/libjudge.a $libraries \
    2>"$scratch/said"
verdict 'the inputs of the suite can be written down' [ -x "$scratch/pen" ]
# write_down SEED FIRST LAST
write_down() {
    for n in $(seq "$2" "$3"); do
        printf '%032d' 0 >"$scratch/report"
        # shellcheck disable=SC2086
        "$scratch/pen" "$n" $1 3<>"$scratch/report" 4>>"$scratch/table" \
            >/dev/null 2>&1
    done
}
learn() { # FOLDER
    mkdir -p "$1"
    {
        echo '#include "exercise.h"
#include <math.h>
static const double known[][4] = {'
        sort -u "$scratch/table"
        echo '};
void velocities_after(double u1, double u2, double im1, double im2,
                      double v[2])
{
    const double centre = (im2 * u1 + im1 * u2) / (im1 + im2);
    v[0] = v[1] = NAN;
    for (unsigned i = 0; i < sizeof known / sizeof known[0]; ++i)
        if (known[i][0] == u1 && known[i][1] == u2 && known[i][2] == im1 &&
            known[i][3] == im2) {
            v[0] = 2.0 * centre - u1;
            v[1] = 2.0 * centre - u2;
        }
}'
    } >"$1/01a-collide.c"
}
tests=$(grep -c '^test' build/grade/01a.list)
hidden=$(grep -c '^hidden' build/grade/01a.list)
public=$(awk '/^test/ { s += $2 } END { print s }' build/grade/01a.list)
: >"$scratch/table"
write_down '' 1 "$tests"
learn "$scratch/learnt/public"
write_down "$seed" 1 $((tests + hidden))
learn "$scratch/learnt/told"
honest "$scratch/learnt"
grade "$scratch/learnt" "$scratch/out"
verdict 'who knows the public inputs has their points and no others' \
    judged public failed "$public"
verdict 'who knows the hidden ones of this seed has all' \
    judged told passed "$full"
cp "$(result honest)" "$scratch/honest.one"
grade "$scratch/learnt" "$scratch/out" --hidden 739147
verdict 'with another seed he has not' judged told failed "$public"
reported() { # KIND...: also these, and always what people read
    rm "$out/grades.csv"
    grade "$scratch/learnt" "$out" --hidden 739147 --report "$*"
    for kind; do
        [ -e "$out/$kind/honest.json" ] || why "no $kind" || return 1
    done
    grep -q '^"honest",' "$out/grades.csv" || why 'no spreadsheet' || return 1
    grep -q '^possible ' "$scratch/said" || why 'no table' || return 1
    grep -q '^For a human eye:' "$scratch/said" || why 'no list'
}
verdict 'whatever is reported, there are table, list and spreadsheet' \
    reported gradescope github
own_times() { # each test has its own, and together they are not the whole
    awk -F'[ ,:]+' '/^   "seconds"/ { ++n; sum += $3; different += $3 != last
        last = $3 } /^ "seconds"/ { all = $3 }
        END { exit !(n > 5 && different > 1 && sum > 0 && sum < all) }' \
        "$(result honest)" || why "$(grep seconds "$(result honest)")"
}
verdict 'each test has its own time' own_times
# Two with the same file: to the nanosecond they take the same time.
honest "$scratch/same"
cp -r "$scratch/same/honest" "$scratch/same/twin"
grade "$scratch/same" "$scratch/out" --jobs 4
twins() {
    [ "$(grep -c 'seconds"' "$(result twin)")" -gt 10 ] &&
        [ "$(grep 'seconds"' "$(result honest)")" = \
            "$(grep 'seconds"' "$(result twin)")" ] &&
        grep -q '^ "student": "twin",' "$(result twin)" ||
        why "$(head -8 "$(result twin)")"
}
verdict 'what two hand in is graded once, under either name' twins
verdict 'and earns the same' judged twin passed "$full"
verdict 'an honest student has all with any seed' judged honest passed "$full"
verdict 'another one has what she deserves with any seed' \
    judged partly failed $((full - first))

# ---- the same marks, whoever works beside one ----

for trick in exit-sanitizer prints segv forged-reply compile-include; do
    prepare "$hostile/$trick.c" "$scratch/learnt/$trick"
done
marks() { # JOBS
    grade "$scratch/learnt" "$scratch/jobs$1" --jobs "$1"
    for file in "$scratch/jobs$1"/marks/*/01a.json; do
        sed '/^ *"\(build_\)\{0,1\}seconds":/d' "$file"
    done >"$scratch/marks$1"
}
marks 1
marks 4
alike() {
    [ -s "$scratch/marks1" ] && cmp -s "$scratch/marks1" "$scratch/marks4" ||
        why "$(diff "$scratch/marks1" "$scratch/marks4" | head -20)"
}
verdict 'four jobs at a time give the same marks as one' alike
drawn() {
    grade "$scratch/one" "$scratch/drawn" --hidden "$seed"
    rm -rf "$scratch/drawn"
    (cd "$scratch/kit" && for n in 1 2; do
        build/grade/grade --exercises 01a --output \
            "$scratch/drawn" "$scratch/one" | sed -n 's/.*seed \([0-9]*\).*/\1/p'
    done) >"$scratch/seeds" 2>&1
    [ "$(wc -l <"$scratch/seeds")" -eq 2 ] &&
        [ "$(uniq "$scratch/seeds" | wc -l)" -eq 1 ] &&
        [ "$(uniq "$scratch/seeds")" != "$seed" ] || why "$(cat "$scratch/seeds")"
}
verdict 'a seed that is not given is drawn once and kept' drawn
verdict 'nothing is left in the end' nothing
echo 1..66
