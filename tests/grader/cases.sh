#!/bin/sh
# Files that once earned what they should not, or brought the judge down: each is
# judged at home and graded, and both say the same of it, a state and the points
# of the public tests, which its first line gives: /* 01a crashed: why */, and in
# a line `earns:` the points, or none. And the judge has no rights that it does
# not need.
. tests/programs/common
here=tests/grader/cases
out=$work/out
mkdir "$out"

head_of() { sed -n "1s/^\/\* \([0-9][0-9][a-z]\) \([a-z ]*\): .*/$1/p" "$file"; }
earns() { sed -n 's/^\/\* earns: \([0-9]*\) \*\/$/\1/p' "$file" | grep . || echo 0; }

for file in "$here"/*.c; do
    ex=$(head_of '\1')
    mkdir -p "$out/in/$(basename "$file" .c)"
    cp "$file" "$out/in/$(basename "$file" .c)/$(ls solutions | grep "^$ex")"
done
# One mistake that later tests take for another one.
mkdir -p "$out/in/once"
cp tests/exercises/01a/wrong-lab.c "$out/in/once/01a-collide.c"
build/grade/grade --hidden 1 --jobs 2 --output "$out/graded" "$out/in" \
    >"$out/grading" 2>&1
at_home() {
    build/check/examine --as "$ex" --file "$file" >"$out/said" 2>&1
    grep -q "^$ex .* $state  *$(earns) of " "$out/said" ||
        { cat "$out/said" && false; }
}
in_the_grader() {
    result=$out/graded/marks/$(basename "$file" .c)/$ex.json
    got=$(awk '/^   "hidden": / { hidden = /true/ } /^   "points": / { p = $2 + 0 }
        /^   "state": "passed"/ && !hidden { earned += p }
        END { print earned + 0 }' "$result")
    grep -q "^ \"state\": \"$state\"" "$result" && [ "$got" = "$(earns)" ] ||
        { echo "$got points" && cat "$result" && false; }
}
for file in "$here"/*.c; do
    ex=$(head_of '\1') state=$(head_of '\2')
    holds "$(basename "$file" .c) $state at home" at_home
    holds "$(basename "$file" .c) $state in the grader" in_the_grader
done

once() {
    grep -o '\[[a-z-]*\]\|An earlier test has named a' "$out/graded/marks/once/01a.json" |
        sort -u >"$out/names"
    cat "$out/names"
    [ "$(grep -c '^\[' "$out/names")" -eq 1 ] && grep -q '^An earlier' "$out/names"
}
holds 'one mistake is named for each answer, and later tests refer to it' once

# Who looks at two ticks is asked about that, too, and not only about what passes.
short() {
    build/check/examine --as 05e --file tests/exercises/05e/wrong-short.c |
        tr -s ' \n' ' ' >"$out/said"
    grep -o 'input .*' "$out/said"
    grep -q 'each bounce loses .* and how long do you look' "$out/said"
}
holds 'who does not look for long is asked how long he looks' short

# ---- the judge's rights ----

# A judge that waits for the answer of a sandbox: what the kernel lets it do.
mkfifo "$out/answers" "$out/requests"
user=0
[ "$(id -u)" -ne 0 ] || user=20001
confined() {
    printf '%032d' 0 >"$out/report"
    build/grade/01a.judge 1 0 $user 3<>"$out/report" 5<>"$out/answers" \
        6<>"$out/requests" &
    judge=$!
    for _ in 1 2 3 4 5 6 7 8 9 10; do
        grep -q '^State:.*[SD]' "/proc/$judge/status" &&
            grep -q '^Seccomp:.*2' "/proc/$judge/status" && break
        sleep 0.1
    done
    cat "/proc/$judge/status"
    kill $judge
    wait $judge
    grep -q '^Seccomp:.*2$' "$work/said" && grep -q '^NoNewPrivs:.*1$' "$work/said" &&
        grep -q '^CapEff:.*\<0*$' "$work/said" &&
        { [ $user -eq 0 ] || grep -q "^Uid:[^0-9]*$user[^0-9]*$user" "$work/said"; }
}
rights='a judge has neither the rights nor the calls of who started it'
# While a file is graded that never ends, its judge can be looked at.
graded_so() {
    mkdir -p "$out/loop/one"
    sed 's/^{$/{ for (volatile int i = 0; i == 0;) i = 0;/' \
        solutions/01a-collide.c >"$out/loop/one/01a-collide.c"
    build/grade/grade --hidden 1 --jobs 1 --exercises 01a --seconds 1 \
        --output "$out/looped" "$out/loop" >"$out/grading" 2>&1 &
    grader=$!
    seen=
    while kill -0 $grader 2>/dev/null; do
        seen="$seen $(ps -eo uid=,args= | sed -n "s,^ *\([0-9]*\) .*$PWD/build/grade/01a.judge.*,\1,p")"
        sleep 0.1
    done
    wait $grader
    echo "seen: $seen"
    # Between fork and exec it is still root for a moment.
    echo "$seen" | grep -q '\<[2-5][0-9][0-9][0-9][13579]\>' &&
        [ "$(grep -c '"state": "timed out"' "$out"/looped/marks/one/01a.json)" -gt 1 ]
}
if [ -r /proc/self/status ]; then
    holds "$rights" confined
else
    echo "# note: no /proc here, so nobody looks at the judge's rights"
    echo "ok $suite: $rights"
fi
if [ $user -ne 0 ]; then
    holds 'nor has the one that grades' graded_so
else
    echo "# note: who is not root grades as himself"
    echo "ok $suite: nor has the one that grades"
fi
echo "1..$((2 * $(ls "$here"/*.c | wc -l) + 4))"
