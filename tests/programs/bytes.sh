#!/bin/sh
# The same seed gives the same bytes: gcc and clang, -O2, -O3, and the
# vector instructions of this machine.
. tests/programs/common
all=$(ls src/*.c src/toolbox/*.c)

# run_all FOLDER: what the programs of the folder print, timings left out.
run_all() {
    "$1/collide" --tests 10 --dimensions 3 --seed 3 --mass-ratio 100 -o - \
        --restitution 0.7
    "$1/collide" --tests 20000 --mass-ratio 1e6 --form complement
    "$1/collide-forms" --study rounding --mass-ratio 2,1e6 --tests 20000
    "$1/collide-forms" --study drift --collisions 200000
    "$1/collide-forms" --study galperin --digits 4
    "$1/collide-forms" --study map --tests 50
}
run_all build/bin >"$work/expected"
holds 'the programs run' test "$(wc -l <"$work/expected")" -gt 100
for cc in gcc clang; do
    for level in '-O2' '-O3' '-O3 -march=native'; do
        mkdir -p "$work/bin"
        for program in collide collide-forms; do
            # shellcheck disable=SC2086
            $cc -std=c11 -D_POSIX_C_SOURCE=200809L -ffp-contract=off $level \
                -Isrc -o "$work/bin/$program" "src/programs/$program.c" $all \
                -lm || not_ok "$cc $level" 'does not build'
        done
        run_all "$work/bin" >"$work/got"
        holds "$cc $level gives the same bytes" \
            cmp "$work/expected" "$work/got"
        rm -r "$work/bin"
    done
done
