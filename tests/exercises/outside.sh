#!/bin/sh
# A function that answers right and also writes one value before or behind a
# output that it was given, next to it or a dozen values further on, has not
# passed, neither at home nor in the grader.
# Every output of every exercise is tried: the overrun is planted into the
# worked solution, and which of them happens is said by the environment, so
# that an exercise is compiled once for home and once for the sandbox.
set -u
out=$(mktemp -d) || exit 1
trap 'rm -rf "$out"' EXIT
trap 'exit 1' HUP INT TERM
topic=outside

# Each remote.c, or what is made from call.h.
remotes=$out/remotes
for folder in tests/exercises/[0-9][0-9][a-z]; do
    ex=${folder##*/}
    mkdir -p "$remotes/$ex"
    if [ -e "$folder/call.h" ]; then
        awk -f tests/remote.awk "$folder/call.h"
    else
        cat "$folder/remote.c"
    fi >"$remotes/$ex/remote.c"
done

# What it says about the outputs that it gives, a line for each,
#   /* output: FUNCTION OUTPUT VALUES */      or      /* output: none */
# with how many values the output has, and "suite" behind it where the suite
# looks behind it (02b: and before it) by itself and knows better words.
[ $# -gt 0 ] || set -- $(ls solutions | grep '^[0-9]' | cut -c 1-3)
outputs_of() { # EXERCISE...
    for ex; do
        sed -n "s,^/\\* output: \\(.*\\) \\*/\$,$ex \\1,p" \
            "$remotes/$ex/remote.c"
    done
}
outputs=$(outputs_of "$@")
without=$(echo "$outputs" | sed -n 's/ none$//p')
outputs=$(echo "$outputs" | grep -v ' none$')

# verdict WHAT COMMAND...: one line of result; the command says why.
verdict() {
    what=$1
    shift
    if "$@" >"$out/why" 2>&1; then
        echo "ok $topic: $what"
    else
        echo "not ok $topic: $what - $(head -c 300 "$out/why" | tr '\n' '~')"
    fi
}

all_named() { # HOME EXERCISE...
    home=$1
    shift
    for ex; do
        given=$(grep -o 'remote_output[a-z_]*("[^"]*"' "$home/$ex/remote.c" |
            sed 's/.*("//; s/"//' | sort -u)
        named=$(echo "$outputs" | awk -v ex="$ex" '$1 == ex { print $3 }' |
            sort -u)
        [ "$given" = "$named" ] || {
            echo "$ex: remote.c gives" $given, and names $named
            return 1
        }
        [ -n "$named" ] || echo "$without" | grep -q -x "$ex" ||
            { echo "$ex: remote.c has no line with an output"; return 1; }
    done
}
verdict 'every exercise has its outputs named, or has none' \
    all_named "$remotes" "$@"
mkdir "$out/99a" && sed 's,^/\* output:.*,,' "$remotes/02a/remote.c" \
    >"$out/99a/remote.c"
unnamed() { ! all_named "$out" 99a; }
verdict 'and one that names none is seen' unnamed

# plant EXERCISE: its solution, with the overruns, to $out/EXERCISE.c.
plant() {
    echo "$outputs" | grep "^$1 " | awk -v solution="$2" '
        { what[$2] = what[$2] sprintf( \
            "    if (planted(\"%s<\"))\n" \
            "        memset(%s - 1, 7, sizeof *%s);\n" \
            "    if (planted(\"%s>\"))\n" \
            "        memset(%s + (%s), 7, sizeof *%s);\n" \
            "    if (planted(\"%s>>\"))\n" \
            "        memset(%s + (%s) + 12, 7, sizeof *%s);\n",
            $3, $3, $3, $3, $3, $4, $3, $3, $3, $4, $3) }
        END {
            print "#include <stdlib.h>\n#include <string.h>"
            print "static int planted(const char *what)\n{"
            print "    const char *wanted = getenv(\"PLANT\");"
            print "    return wanted && strcmp(wanted, what) == 0;\n}"
            while ((getline line < solution) > 0) {
                print line
                for (name in what)
                    if (line ~ "^[a-z].*[ *]" name "\\(")
                        in_it = name
                if (line == "{" && in_it != "") {
                    printf "%s", what[in_it]
                    in_it = ""
                }
            }
        }'
}

. tests/exercises/linker
home=$(sed -n 1p build/check/flags) libraries=$(sed -n 2p build/check/flags)
base=$(sed -n 1p build/grade/flags)
build() { # EXERCISE
    # shellcheck disable=SC2086
    COMPILER_PATH=$linker $home -w -Isrc -Isrc/examiner -o "$out/home" \
        "$out/planted.c" "build/check/$1.suite.o" $libraries &&
        $base -w -Isrc/examiner -o "$out/boxed" "$out/planted.c" \
            "build/grade/$1.inside.o" -lm
}

# The runner, and the judge with the program of the sandbox beside it.
at_home() { # TEST
    ASAN_OPTIONS=detect_leaks=0:symbolize=0 "$out/home" "$1" \
        3<>"$out/report" >"$out/said" 2>&1
}
mkfifo "$out/requests" "$out/answers" || exit 1
in_the_grader() { # TEST
    "$out/boxed" 3<"$out/requests" 4>"$out/answers" >"$out/said" 2>&1 &
    {
        dd bs=1 count=1 <&5 >/dev/null 2>&1 # it has come to its main
        "build/grade/$ex.judge" "$1" 3<>"$out/report"
    } 6>"$out/requests" 5<"$out/answers"
    set -- $?
    wait # for the sandbox, which must not hear what is meant for the next
    return "$1"
}

# test_passes WHERE TEST; the test's report stays.
test_passes() {
    printf '%032d' 0 >"$out/report"
    "$1" "$2"
    ended=$?
    [ $ended -eq 0 ] && grep -q '^0* verdict passed' "$out/report"
}
passes() { # WHERE
    test_passes "$1" 1 || cat "$out/report" "$out/said"
    grep -q '^0* verdict passed' "$out/report"
}

# found WHERE PLANT: the first test that calls the function tells of it.
found() {
    PLANT=$2
    export PLANT
    tests=$(grep -c '^test' "build/check/$ex.list")
    n=1
    while [ $n -le "$tests" ] && test_passes "$1" $n; do
        n=$((n + 1))
    done
    unset PLANT
    [ $n -le "$tests" ] || { echo "all $tests tests pass"; return 1; }
    side=before name=${2%%[<>]*}
    case $2 in *'>') side=behind ;; esac
    case $1 in
    at_home) grep -q 'use-after-poison' "$out/said" && return ;;
    esac
    grep -q "^0* says quantity what stands $side $name\$" "$out/report" &&
        return
    echo "$outputs" | grep -q "^$ex [a-z_]* $name .* suite\$" &&
        grep -q '^0* verdict failed' "$out/report" && return
    cat "$out/report" "$out/said"
    return 1
}

for ex in $(echo "$outputs" | cut -d ' ' -f 1 | uniq); do
    set -- solutions/"$ex"-*.c
    plant "$ex" "$1" >"$out/planted.c"
    verdict "$ex can be built" build "$ex"
    for where in at_home in_the_grader; do
        verdict "$ex passes $where" passes $where
        for place in $(echo "$outputs" | grep "^$ex " | cut -d ' ' -f 3); do
            verdict "$ex: before $place, $where" found $where "$place<"
            verdict "$ex: behind $place, $where" found $where "$place>"
            verdict "$ex: far behind $place, $where" found $where "$place>>"
        done
    done
done

# Of all exercises two checks; for each with outputs its build and two passes,
# and six for each output; and five below.
planned=$((7 + 3 * $(echo "$outputs" | cut -d ' ' -f 1 | uniq | grep -c .) +
    6 * $(echo "$outputs" | grep -c .)))

# Without sanitizers the guards have to do alone.
ex=01a outputs=$(outputs_of 01a)
plain() {
    plant $ex solutions/$ex-collide.c >"$out/planted.c" &&
        $base -Isrc -Dvelocities_after=suite_velocities_after -r -nostdlib \
            -o "$out/suite.o" tests/exercises/$ex/suite.c \
            "$remotes/$ex/remote.c" &&
        $base -w -Isrc -Isrc/examiner -DREMOTE_SERVER -o "$out/home" \
            "$out/planted.c" "$out/suite.o" "$remotes/$ex/remote.c" \
            src/examiner/check.c src/examiner/no_hidden.c src/examiner/no_callback.c \
            src/examiner/local.c src/examiner/guards.c src/examiner/remote.c \
            src/toolbox/random.c ${libraries#* }
}
verdict "$ex can be built without sanitizers" plain
verdict "$ex passes at home without sanitizers" passes at_home
verdict "$ex: before v, without sanitizers" found at_home 'v<'
verdict "$ex: behind v, without sanitizers" found at_home 'v>'
verdict "$ex: far behind v, without sanitizers" found at_home 'v>>'
echo "1..$planned"
