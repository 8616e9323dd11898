#!/bin/sh
# The studies of stepping: the same bytes with clang as in the build that is
# there (bytes.sh has -O3 and the vector instructions of this machine); and
# commands that are wrong.
. tests/programs/common
s=build/bin/step-studies

studies $s >"$work/expected"
holds 'the studies run' test "$(wc -l <"$work/expected")" -gt 60000
# shellcheck disable=SC2086
clang -std=c11 -D_POSIX_C_SOURCE=200809L -ffp-contract=off -O2 \
    -fno-math-errno -Isrc -DBUILD_FLAGS='"test"' -o "$work/studies" \
    src/studies/step-studies.c src/forces/stepping.c \
    src/forces/methods.c src/forces/newton.c \
    src/forces/adaptive.c src/forces/reference.c \
    src/toolbox/*.c -lm || not_ok 'clang -O2' 'does not compile'
studies "$work/studies" >"$work/got"
holds 'clang -O2 gives the same bytes' cmp "$work/expected" "$work/got"

# Numbers of the book, to be had from the summaries.
$s --study area -o /dev/null --summary "$work/area"
awk '{ v[$1] = $2 } END { exit !(v["leapfrog"] > 0.99999 &&
    v["leapfrog"] < 1.00001 && v["rk4"] < 0.9995 && v["euler"] > 1.6) }' \
    "$work/area"
holds 'leapfrog keeps an area, RK4 and Euler do not' test $? -eq 0
$s --study energy --orbits 200 -o /dev/null --summary "$work/energy"
awk '{ v[$1] = $2 } END { exit !(v["leapfrog"] < 1e-3 && v["rk4"] > 5e-3 &&
    v["euler"] > 0.3 && v["pefrl"] < 2e-5) }' "$work/energy"
holds 'energies: leapfrog bounded, RK4 drifts' test $? -eq 0

refuses 2 'study is needed' $s
refuses 2 "'euler' is not methods" $s --study euler
refuses 2 'orbits: ' $s --study energy --orbits 0
refuses 2 'orbits: ' $s --study energy --orbits many
refuses 1 nowhere $s --study laws -o /nowhere/table
holds '--help lists the studies' sh -c "$s --help | grep -q friction"
echo 1..10
