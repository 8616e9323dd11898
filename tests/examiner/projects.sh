#!/bin/sh
# Projects: the stub of each, right programs of different structure, and one
# wrong program for each mistake that its suite knows. At home once; the others
# run as in the grader, the judge beside the sandbox's program, without its walls.
# The wrong ones, and some right ones, are changes of the worked solution,
# tests/exercises/P1/*.sed. The first line of a wrong one names the mistake, the
# stage that finds it, which of the functions that the suite hands out it comes
# to, and whether it never ends.
#   tests/examiner/projects.sh [PROJECT]...      all, or P1
. tests/programs/common
out=$work/out
mkdir "$out"
root=$(pwd)
[ $# -gt 0 ] || set -- $(ls solutions | sed -n 's/^\(P[0-9]\)-.*\.c$/\1/p')
for file in build/check/examine build/grade/flags $(
    for ex; do
        echo "build/check/$ex.suite.o build/grade/$ex.judge" \
            "build/grade/$ex.inside.o"
    done); do
    [ -e "$file" ] || {
        echo "not ok projects - $file is missing: make test"
        exit 1
    }
done

# says STATUS PATTERN FILE: what the examiner at home ends with, and says.
says() {
    build/check/examine --strict --as "$ex" --file "$3" >"$out/said" 2>&1
    [ $? -eq "$1" ] && grep -q -e "$2" "$out/said" ||
        { cat "$out/said" && false; }
}
at_home() {
    points=$(awk '/^test/ { sum += $2 } END { print sum }' build/check/$ex.list)
    holds "$ex: the stub is not begun" says 0 "^$ex .* not begun" \
        $home/stub.c
    { cat $home/stub.c && echo '/* my first line */'; } >"$out/stub.c"
    holds "$ex: an empty table earns nothing" \
        says 1 "^$ex .* failed  *0 of $points points" "$out/stub.c"
    holds "$ex: its story is what was run, and the files" \
        grep -q "^  input .*$ex \([a-z]* \)\{0,1\}[a-z]*\.txt " "$out/said"
    holds "$ex: the book has the equations that it names" sh -c "
        grep -o '\"eq:[a-z0-9-]*\"' $home/suite.c | tr -d '\"' | sort -u |
            while read -r label; do
                grep -q \"^\$label \" tests/equations.txt || echo \$label
            done | grep . && exit 1; exit 0"
    holds "$ex: the solution passes at home" \
        says 0 "^$ex .* passed  *$points of $points" "$solution"
}

# ---- a student's own folder: hints of a stage, and what is left ----

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
own_folder() {
    mkdir -p "$out/kit/build/check" "$out/kit/exercises"
    for file in src tests solutions build/check/examine build/check/flags \
        build/check/libcheck.a build/check/P1.list build/check/P1.suite.o \
        build/check/P1.given.o; do
        ln -s "$root/$file" "$out/kit/$file"
    done
    sed -f $home/wrong-clock.sed solutions/P1-bonkers.c >"$out/clock.c"
    holds 'the stub has the hint of the first stage' \
        gives 0 'Stage 1\. .*' $home/stub.c --hint P1
    holds 'who fails in stage 3 has its hint' \
        gives 0 'Stage 3\. .*' "$out/clock.c" --hint P1
    holds 'and no other' sh -c "! grep -e 'Stage [^3]' '$out/said' &&
        grep -x 'P1, Bonkers, upright: hint 1 of 1' '$out/said'"
    holds 'what was given there is remembered' \
        gives 0 '.*, the last one again; there are no more' "$out/clock.c" --hint P1
    holds 'and does not count in another stage' \
        gives 0 '.*: hint 1 of 1' $home/stub.c --hint P1
    holds 'who passes is sent on to a person' \
        gives 0 'What is left is for a person: P1.gp and P1.txt\.' \
        solutions/P1-bonkers.c P1
    holds 'and has no hint' gives 0 'P1 passes; there is nothing to hint at\.' \
        solutions/P1-bonkers.c --hint P1
    holds 'who does not pass is not' sh -c "cd '$out/kit' &&
        cp '$out/clock.c' exercises/P1-bonkers.c && build/check/examine P1 \
        >'$out/said'; ! grep 'for a person' '$out/said'"
}

# ---- the judge and the sandbox's program ----

cc="$(sed -n 1p build/grade/flags | sed 's/-fmax.*//') -w -g0"
. tests/exercises/linker
[ -z "$linker" ] || export COMPILER_PATH="$linker"
mkdir "$out/desk" && mkfifo "$out/requests" "$out/answers" || exit 1

# built FILE [N]...: the student's programs, with what is given for the
# header's function, or with all of it; one that is given nothing.
built() {
    from=$1
    shift
    # shellcheck disable=SC2086
    $cc $quickly -Isrc/examiner -DEXAMINER_GIVES -c -o "$out/answer.o" "$from" ||
        return
    [ "$given" ] && [ $# -gt 0 ] || set -- ${all_given:-0}
    for n; do
        # shellcheck disable=SC2086
        $cc -o "$out/program$n" "$out/answer.o" "$box" -lm \
            ${given:+-Wl,-u,${given}_$n,--defsym=$given=${given}_$n} || return
    done
}
quickly=
allowed=5 # seconds; twice that on the wall, where others are at work, too
# stage N [SEED]: the report of a stage, to $out/report; 0 when it is passed.
stage() {
    printf '%032d' 0 >"$out/report"
    (cd "$out/desk" && ulimit -S -t "$allowed" &&
        exec ../box 3<"$out/requests" 4>"$out/answers") 2>"$out/complaint" &
    {
        dd bs=1 count=1 <&5 >/dev/null 2>&1 # it has come to its main
        "build/grade/$ex.judge" "$@" 3<>"$out/report"
    } 6>"$out/requests" 5<"$out/answers" 2>/dev/null
    wait $!
    grep -q '^0* verdict passed' "$out/report"
}
all_stages() { # FILE
    built "$1" || return
    awk '/^test/ { ++n; print n; if ($3) print n, 1234 + n }' \
        "build/check/$ex.list" >"$out/stages"
    while read -r n seed; do
        # shellcheck disable=SC2086
        stage $n $seed </dev/null ||
            { echo "stage $n $seed" && cat "$out/report" && return 1; }
    done <"$out/stages"
}
# A wrong program runs for less time than the compiler would optimize it, and
# prints the same without, for no operation is contracted.
recognised() { # NAME STAGE WHICH HOW
    quickly=-O0 allowed=5
    [ -z "$4" ] || allowed=1
    # shellcheck disable=SC2086
    built "$out/wrong.c" ${3:-0} || return
    ! stage "$2" && grep -q -F "[$1]" "$out/report" ||
        { cat "$out/report" && false; }
}
# The worked program, which forges how often it has called force: in the memory
# where some runs count, and in a file of the name that it once had. (Two such
# programs earned all points in a trial of the second edition.)
forges() { # EXPRESSION QUANTITY
    sed -e 's/^#include "force.h"/#define _GNU_SOURCE\n#include <fcntl.h>\n&/' \
        -e 's/^#include <math.h>/&\n#include <sys\/mman.h>\n#include <unistd.h>/' \
        -e 's/^int main(/static void forge(long k)\
{\
    long *page = mmap(NULL, sizeof k, PROT_READ | PROT_WRITE, MAP_SHARED, 3, 0);\
    const int file = open("calls", O_RDWR | O_CREAT, 0600);\
    if (page != MAP_FAILED)\
        *page = k;\
    calls = pwrite(file, \&k, sizeof k, 0) == sizeof k ? k : -7;\
}\
&/' \
        -e "s/^    printf(\"# pick/    forge($1);\\n&/" "$solution" >"$out/forger.c"
    quickly=-O0 allowed=5
    built "$out/forger.c" $all_given || return
    ! stage 6 && grep -q "says quantity $2" "$out/report" ||
        { cat "$out/report" && false; }
}
# The worked program, with rows in which the second number of a body follows the
# first without a blank: it is told so. (1e-300 and 1.5 were read as 1e-3001 and
# 0.5, so that a value looked wrong, and 1.5 and -2 passed.)
glued() { # FORMAT
    sed "s/printf(\" %.17g %.17g/printf(\" %.17g$1/" "$solution" >"$out/glued.c"
    quickly=-O0 allowed=5
    ! cmp -s "$solution" "$out/glued.c" && built "$out/glued.c" $all_given || return
    ! stage 1 &&
        tr '\n' ' ' <"$out/report" | grep -q 'says quantity rows in the table .*'$(
        )'says question Columns run together in row [0-9]*: found `[-+.0-9e]*`, expected' ||
        { cat "$out/report" && false; }
}
in_the_grader() {
    box=$root/build/grade/$ex.inside.o
    given=$(nm "$box" 2>/dev/null | sed -n 's/.* T \([a-z]*\)_0$/\1/p')
    all_given=$([ -z "$given" ] || nm "$box" | sed -n "s/.* T ${given}_//p")
    # shellcheck disable=SC2086
    $cc -o "$out/box" "$box" -lm -Wl,-u,sandbox_main,--defsym=main=sandbox_main || exit 1
    quickly=
    for file in "$home"/right-*.c; do
        holds "$file passes, and what is hidden too" all_stages "$file"
    done
    for file in "$home"/right-*.sed; do
        [ -e "$file" ] || continue
        sed -f "$file" "$solution" >"$out/right.c"
        holds "$file passes, and what is hidden too" all_stages "$out/right.c"
    done
    for file in "$home"/wrong-*.sed; do
        about=$(sed -n '1s/^# mistake: //p' "$file")
        name=${about%%,*}
        which=$(echo "$about" | sed -n 's/.*, given \([0-9 ]*\).*/\1/p')
        ends=$(echo "$about" | sed -n 's/.*, never ends$/never/p')
        n=$(echo "$about" | sed 's/.*, stage \([1-9]\).*/\1/')
        sed -f "$file" "$solution" >"$out/wrong.c"
        holds "$file is [$name]" recognised "$name" "$n" "$which" "$ends"
    done
    holds "$ex: columns that run together are named" glued %.17g
    holds "$ex: and those that a sign parts" glued %+.17g
    if [ "$ex" = P4 ]; then
        holds 'P4: the calls of its pick are no count of all' \
            forges '(long)price(best.order, (double)best.steps)' CALLS
        holds 'P4: nor is a number below zero' \
            forges -20000 '1 if force was called at all'
    fi
    holds "$ex: every mistake that the suite knows has a wrong program" sh -c "
        for name in \$(tr -d '\n' <$home/suite.c |
            grep -o '\"[a-z]*-[a-z-]*\" *[,:]\|\[[a-z]*-[a-z-]*\]' |
            tr -d '\", :[]'); do
            grep -q \"^# mistake: \$name,\" $home/wrong-*.sed || echo \$name
        done | grep . && exit 1; exit 0"
}

# Of each eight checks, and one for each program but the solution.
planned=0
for ex; do
    home=tests/exercises/$ex
    solution=$(echo solutions/"$ex"-*.c)
    at_home
    [ "$ex" != P1 ] || own_folder
    in_the_grader
    planned=$((planned + 8 + 8 * $(echo "$ex" | grep -c P1) +
        2 * $(echo "$ex" | grep -c P4) +
        $(ls "$home"/right-* "$home"/wrong-*.sed | wc -l)))
done
echo "1..$planned"
