#!/bin/sh
# Project P1: its stub, right programs of different structure, and one wrong
# program for each mistake that the suite knows. At home once; the others run
# as in the grader, the judge beside the box's program, without its walls.
# The wrong ones are changes of the worked solution, tests/exercises/P1/*.sed.
set -u
out=$(mktemp -d) || exit 1
trap 'rm -rf "$out"' EXIT
trap 'exit 1' HUP INT TERM
home=tests/exercises/P1
root=$(pwd)
for file in build/check/examine build/check/P1.suite.o build/grade/P1.judge \
    build/grade/P1.inside.o build/grade/flags; do
    [ -e $file ] || {
        echo "not ok projects - $file is missing: make test"
        exit 1
    }
done

# verdict WHAT COMMAND...: one line of result.
verdict() {
    what=$1
    shift
    if "$@" >"$out/why" 2>&1; then
        echo "ok projects: $what"
    else
        echo "not ok projects: $what - $(head -c 400 "$out/why" | tr '\n' '~')"
    fi
}

# says STATUS PATTERN FILE: what the examiner at home ends with, and says.
says() {
    build/check/examine --strict --as P1 --file "$3" >"$out/said" 2>&1
    [ $? -eq "$1" ] && grep -q -e "$2" "$out/said" ||
        { cat "$out/said" && false; }
}
verdict 'the stub is not begun' says 0 '^P1 .* not begun' $home/stub.c
{ cat $home/stub.c && echo '/* my first line */'; } >"$out/P1-stub.c"
verdict 'an empty table earns nothing' \
    says 1 '^P1 .* failed  *0 of 25 points' "$out/P1-stub.c"
verdict 'its story is what was run, and rows' \
    grep -q '^  input  *P1 beads.txt .*; in beads.txt:' "$out/said"
verdict 'the solution passes at home' says 0 '^P1 .* passed  *25 of 25' \
    solutions/P1-bonkers.c

# ---- a student's own folder: hints of a stage, and what is left ----

mkdir -p "$out/kit/build/check" "$out/kit/exercises"
for file in src tests solutions build/check/examine build/check/flags \
    build/check/libcheck.a build/check/P1.list build/check/P1.suite.o \
    build/check/P1.given.o; do
    ln -s "$root/$file" "$out/kit/$file"
done
# gives STATUS TEXT FILE OPTION...: the same of his own file, and here TEXT is
# all of a line.
gives() {
    want=$1 text=$2
    cp "$3" "$out/kit/exercises/P1-bonkers.c"
    shift 3
    (cd "$out/kit" && build/check/examine "$@") >"$out/said" 2>&1
    [ $? -eq "$want" ] && grep -q -x -e "$text" "$out/said" ||
        { cat "$out/said" && false; }
}
sed -f $home/wrong-clock.sed solutions/P1-bonkers.c >"$out/clock.c"
verdict 'the stub has the hint of the first stage' \
    gives 0 'Stage 1\. .*' $home/stub.c --hint P1
verdict 'who fails in stage 3 has its hint' \
    gives 0 'Stage 3\. .*' "$out/clock.c" --hint P1
verdict 'and no other' sh -c "! grep -e 'Stage [^3]' '$out/said' &&
    grep -x 'P1, Bonkers, upright: hint 1 of 1' '$out/said'"
verdict 'what was given there is remembered' \
    gives 0 '.*, the last one again; there are no more' "$out/clock.c" --hint P1
verdict 'and does not count in another stage' \
    gives 0 '.*: hint 1 of 1' $home/stub.c --hint P1
verdict 'who passes is sent on to a person' \
    gives 0 'What is left is for a person: P1.gp and P1.txt\.' \
    solutions/P1-bonkers.c P1
verdict 'and has no hint' gives 0 'P1 passes; there is nothing to hint at\.' \
    solutions/P1-bonkers.c --hint P1
verdict 'who does not pass is not' sh -c "cd '$out/kit' &&
    cp '$out/clock.c' exercises/P1-bonkers.c && build/check/examine P1 \
    >'$out/said'; ! grep 'for a person' '$out/said'"

# ---- the judge and the box's program ----

cc="$(sed -n 1p build/grade/flags | sed 's/-fmax.*//') -w -g0"
if command -v ld.gold >/dev/null 2>&1; then # see tests/exercises/all.sh
    mkdir "$out/linker" && ln -s "$(command -v ld.gold)" "$out/linker/ld" &&
        export COMPILER_PATH="$out/linker"
fi
box=$root/build/grade/P1.inside.o
# shellcheck disable=SC2086
$cc -o "$out/box" "$box" -Wl,-u,box_main,--defsym=main=box_main || exit 1
mkdir "$out/desk" && mkfifo "$out/requests" "$out/answers" || exit 1

# built FILE LAW...: the student's programs.
built() {
    from=$1
    shift
    # shellcheck disable=SC2086
    $cc -Isrc/examiner -DCOLLIDE_GIVEN -c -o "$out/answer.o" "$from" ||
        return
    for law; do
        # shellcheck disable=SC2086
        $cc -o "$out/program$law" "$out/answer.o" "$box" -lm \
            -Wl,-u,collide_$law,--defsym=collide=collide_$law || return
    done
}
allowed=5 # seconds; twice that on the wall, where others are at work, too
# stage N [SEED]: the report of a stage, to $out/report; 0 when it is passed.
stage() {
    printf '%032d' 0 >"$out/report"
    (cd "$out/desk" && ulimit -S -t "$allowed" &&
        exec ../box 3<"$out/requests" 4>"$out/answers") 2>"$out/complaint" &
    {
        dd bs=1 count=1 <&4 >/dev/null 2>&1 # it has come to its main
        build/grade/P1.judge "$@" 3<>"$out/report"
    } 5>"$out/requests" 4<"$out/answers" 2>/dev/null
    wait $!
    grep -q '^0* verdict passed' "$out/report"
}
all_stages() { # FILE
    built "$1" 0 1 2 3 4 5 6 7 || return
    for n in 1 2 3 4 5 6; do
        stage $n || { echo "stage $n" && cat "$out/report" && return 1; }
    done
    stage 2 1234 && stage 5 99 || { cat "$out/report" && false; }
}
for file in $home/right-*.c; do
    verdict "$file passes, and what is hidden too" all_stages "$file"
done
recognised() { # NAME STAGE LAW...
    name=$1 n=$2 allowed=5
    shift 2
    case $name in root-zero-again | nothing-happened) allowed=1 ;; esac
    built "$out/wrong.c" "$@" || return
    ! stage "$n" && grep -q -F "[$name]" "$out/report" ||
        { cat "$out/report" && false; }
}
for file in "$home"/wrong-*.sed; do
    sed -n '1s/^# mistake: \(.*\), stage \([1-6]\)$/\1 \2/p' "$file" >"$out/of"
    read -r name n <"$out/of"
    sed -f "$file" solutions/P1-bonkers.c >"$out/wrong.c"
    case $name in # the laws that stage 4 comes to, in its turn
    false-alarm) laws=7 ;;
    check-missing) laws='7 5' ;;
    nothing-happened) laws='7 5 6 2 3' ;;
    no-number-passes) laws='7 5 6 2' ;;
    check-gives-up) laws='7 5 6' ;;
    *) laws=0 ;;
    esac
    # shellcheck disable=SC2086
    verdict "$file is [$name]" recognised "$name" "$n" $laws
done
verdict 'every mistake that the suite knows has a wrong program' sh -c "
    for name in \$(grep -o '\"[a-z]*-[a-z-]*\",\$' $home/suite.c |
        tr -d '\",'); do
        grep -q \"^# mistake: \$name,\" $home/wrong-*.sed || echo \$name
    done | grep . && exit 1; exit 0"
echo "1..$((13 + $(ls $home/right-*.c $home/wrong-*.sed | wc -l)))"
