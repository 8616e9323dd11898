#!/bin/sh
# Doing nothing earns nothing. Of every stub these are made: itself; with its
# gap filled by the value that stands there; with the lines of its gap deleted;
# and with its functions empty, or returning 0, 1, or one of their arguments.
# None may pass a test that its suite does not call idle; and a test that
# none of them passes is not idle.
set -u
out=$(mktemp -d) || exit 1
trap 'rm -rf "$out"' EXIT
trap 'exit 1' HUP INT TERM
flags=build/grade/flags
[ -s "$flags" ] && [ -s build/grade/libjudge.a ] || {
    echo "not ok exercises - $flags is missing: make test"
    exit 1
}
# -O0 compiles in half the time; the answers are as wrong.
cc="$(sed -n 1p "$flags") -O0 -g0 -w -Isrc -Isrc/examiner"
. tests/exercises/linker
[ -z "$linker" ] || export COMPILER_PATH="$linker"
# shellcheck disable=SC2086
$cc -c -o "$out/record.o" tests/mutants/record.c || exit 1

# variant KIND [N] STUB: a stub that was given up; status 3 when it has no Nth
# argument to return.
variant() {
    awk -v kind="$1" -v wanted="$2" '
        function body(    n, i, parts, part) {
            if (head ~ /^void /)
                return
            value = kind == "one"
            if (kind == "argument") {
                n = split(substr(head, index(head, "(") + 1), parts, /[,)]/)
                for (i = part = 0; i < n; )
                    if (parts[++i] ~ /^ *(double|int|size_t) [a-z]/ &&
                        ++part == wanted) {
                        value = parts[i]
                        sub(/.* /, "", value)
                        found = 1
                    }
            }
            print "    return " value ";"
        }
        /^[a-z].*\(/ && !/^static/ && !/;$/ { head = ""; above = 1 }
        above { head = head " " $0; sub(/^ /, "", head); above = !/;$/ }
        /^{/ && head && above {
            above = 0
            within = 1
            print
            if (kind != "filled" && kind != "deleted")
                body()
            next
        }
        /^}/ { within = 0 }
        within && kind == "deleted" && /NOT_DONE_YET/ {
            if (/return/)
                print "    return 0;"
            next
        }
        within && kind != "deleted" && kind != "filled" { next }
        { print }
        kind == "filled" && /^#include "exercise.h"/ {
            print "#undef NOT_DONE_YET\n#define NOT_DONE_YET(value) (value)"
        }
        END { exit kind == "argument" && !found ? 3 : 0 }' "$3"
}

# tried NAME: what the tests say about $out/NAME.c, unless it does not build;
# with the students' inputs, and with a grader's.
tried() {
    # shellcheck disable=SC2086
    $cc -o "$out/run" "$out/$1.c" "$out/suite.o" "$out/record.o" \
        build/grade/libjudge.a -lcunit -lm 2>"$out/said" || return
    {
        printf '\nby %s\n' "$1"
        "$out/run" 0
        "$out/run" 1
    } >>"$out/results" 2>/dev/null
    built=$((built + 1))
}

[ $# -gt 0 ] || set -- $(ls solutions | grep '^[0-9]' | cut -c 1-3)
for ex; do
    suite=tests/exercises/$ex/suite.c
    stub=tests/exercises/$ex/stub.c
    : >"$out/results"
    built=0
    # shellcheck disable=SC2086
    $cc -c -o "$out/suite.o" "$suite" || continue
    cp "$stub" "$out/given.c"
    tried given
    for kind in filled deleted empty one; do
        variant $kind 0 "$stub" >"$out/$kind.c"
        tried $kind
    done
    for n in 1 2 3 4; do
        variant argument $n "$stub" >"$out/argument.c" || break
        tried argument
    done
    awk -v ex="$ex" -v built="$built" '
        $1 == "by" { who = $2 }
        NF < 3 { next }
        { idle[$1] = $2 }
        $3 == "passed" { by[$1] = who }
        END {
            for (t = 1; t in idle; ++t) {
                if (idle[t])
                    ++many
                if (!idle[t] && t in by && !why)
                    why = "test " t " is passed by the one that is " by[t] \
                        ", and is not idle"
                if (idle[t] && !(t in by) && !why)
                    why = "test " t " is idle, and none of them passes it"
            }
            if (built < 4)
                why = "only " built + 0 " of them build"
            if (many == t - 1)
                why = "no test shows that something was done"
            print (why ? "not ok" : "ok") " exercises: " ex \
                ": doing nothing earns nothing" (why ? " - " why : "")
        }' "$out/results"
done
echo 1..$# # one for each exercise
