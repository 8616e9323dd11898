#!/bin/sh
# A function that answers right and also writes one value before or behind a
# place that it was given has not passed, neither at home nor in the grader.
# Every place of every exercise is tried: the overrun is planted into the
# worked solution, and which of them happens is said by the environment, so
# that an exercise is compiled once for home and once for the box.
set -u
out=$(mktemp -d) || exit 1
trap 'rm -rf "$out"' EXIT
trap 'exit 1' HUP INT TERM
topic=outside

# These only return a value.
without='01c 01d 03c 05a 05c 08d 09c'

# EXERCISE FUNCTION PLACE, how many values it has, and "suite" where the suite
# looks behind it (02b: and before it) by itself and knows better words.
places='01a velocities_after v 2
01b measure_collision mass_ratio 1
01b measure_collision restitution 1
02a next_meeting left 1
02b sample x samples suite
02c next_valid stale 1
02d positions_at x n
02d positions_at v n
03a equal_bins edge bins+1
03b bin_surprise z 1
03d error_by_blocks error 1
03d error_by_blocks inefficiency 1
04a piston_slopes slope 2
04b decay_time tau 1
04b decay_time sigma 1
05b falling_pair_time height 1
05d wall_z z 2
06a throw_disks x n
06a throw_disks y n
06b mean_square x n
06b mean_square y n
06b mean_square accepted 1
06c depletion overlap 1
07a cells_around around 9
07b speed_below fourth 1
07c compressibility pressure 1
08a drift_kick_drift x n suite
08a drift_kick_drift v n suite
08b three_eighths a 16
08b three_eighths b 4
08b tableau_step y n suite
08c measure_order order 1
09a potential_energy potential n
09b binary_speeds v1 1
09b binary_speeds v2 1
10a dashpot on_a 3
10a dashpot on_b 3
10b oscillate velocity 1
10c membrane_modes omega (g->nx-2)*(g->ny-2) suite
11a part_spheres a 1
11a part_spheres b 1
11b cradle v n suite
12a pareto_front front n suite
12b choose_step step 1
12c leave_out budget 1
12c leave_out bound 1
12d one_line along 3'

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

all_named() {
    for folder in tests/exercises/*/; do
        ex=$(basename "$folder")
        echo "$without" "$places" | tr ' ' '\n' | grep -q -x "$ex" ||
            { echo "$ex is not named here"; return 1; }
    done
}
verdict 'every exercise has its places named, or has none' all_named

# plant EXERCISE: its solution, with the overruns, to $out/EXERCISE.c.
plant() {
    echo "$places" | grep "^$1 " | awk -v solution="$2" '
        { what[$2] = what[$2] sprintf( \
            "    if (planted(\"%s<\"))\n" \
            "        memset(%s - 1, 7, sizeof *%s);\n" \
            "    if (planted(\"%s>\"))\n" \
            "        memset(%s + (%s), 7, sizeof *%s);\n",
            $3, $3, $3, $3, $3, $4, $3) }
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

linker=
if command -v ld.gold >/dev/null 2>&1; then # see all.sh
    mkdir "$out/linker" && ln -s "$(command -v ld.gold)" "$out/linker/ld" &&
        linker=$out/linker
fi
home=$(sed -n 1p build/check/flags) libraries=$(sed -n 2p build/check/flags)
base=$(sed -n 1p build/grade/flags)
build() { # EXERCISE
    # shellcheck disable=SC2086
    COMPILER_PATH=$linker $home -w -Isrc -Isrc/examiner -o "$out/home" \
        "$out/planted.c" "build/check/$1.suite.o" $libraries &&
        $base -w -Isrc/examiner -o "$out/boxed" "$out/planted.c" \
            "build/grade/$1.inside.o" -lm
}

# The runner, and the judge with the program of the box beside it.
at_home() { # TEST
    ASAN_OPTIONS=detect_leaks=0:symbolize=0 "$out/home" "$1" \
        3<>"$out/report" >"$out/said" 2>&1
}
mkfifo "$out/requests" "$out/answers" || exit 1
in_the_grader() { # TEST
    "$out/boxed" 3<"$out/requests" 4>"$out/answers" >"$out/said" 2>&1 &
    {
        dd bs=1 count=1 <&4 >/dev/null 2>&1 # it has come to its main
        "build/grade/$ex.judge" "$1" 3<>"$out/report"
    } 5>"$out/requests" 4<"$out/answers"
    set -- $?
    wait # for the box, which must not hear what is meant for the next
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
    side=before
    case $2 in *'>') side=behind ;; esac
    case $1 in
    at_home) grep -q 'use-after-poison' "$out/said" && return ;;
    esac
    grep -q "^0* says quantity what stands $side ${2%?}\$" "$out/report" &&
        return
    echo "$places" | grep -q "^$ex [a-z_]* ${2%?} .* suite\$" &&
        grep -q '^0* verdict failed' "$out/report" && return
    cat "$out/report" "$out/said"
    return 1
}

for ex in $(echo "$places" | cut -d ' ' -f 1 | uniq); do
    set -- solutions/"$ex"-*.c
    plant "$ex" "$1" >"$out/planted.c"
    verdict "$ex can be built" build "$ex"
    for where in at_home in_the_grader; do
        verdict "$ex passes $where" passes $where
        for place in $(echo "$places" | grep "^$ex " | cut -d ' ' -f 3); do
            verdict "$ex: before $place, $where" found $where "$place<"
            verdict "$ex: behind $place, $where" found $where "$place>"
        done
    done
done

# Without sanitizers the guards have to do alone.
ex=01a
plain() {
    plant $ex solutions/$ex-collide.c >"$out/planted.c" &&
        $base -Isrc -Dvelocities_after=suite_velocities_after -r -nostdlib \
            -o "$out/suite.o" tests/exercises/$ex/suite.c \
            tests/exercises/$ex/border.c &&
        $base -w -Isrc -Isrc/examiner -DBORDER_INSIDE -o "$out/home" \
            "$out/planted.c" "$out/suite.o" tests/exercises/$ex/border.c \
            src/examiner/check.c src/examiner/hidden.c src/examiner/heed.c \
            src/examiner/home.c src/examiner/place.c src/examiner/border.c \
            src/toolbox/random.c ${libraries#* }
}
verdict "$ex can be built without sanitizers" plain
verdict "$ex passes at home without sanitizers" passes at_home
verdict "$ex: before v, without sanitizers" found at_home 'v<'
verdict "$ex: behind v, without sanitizers" found at_home 'v>'
echo 1..292
