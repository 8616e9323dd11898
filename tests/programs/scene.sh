#!/bin/sh
# The program that writes scenes: what it says of itself, what it refuses,
# and the same bytes each time. And the reader of scenes, fuzzed for a second.
. tests/programs/common
scene=build/bin/scene

$scene --help >"$work/help"
names=$(sed -n 's/^  \([a-z][a-z-]*\) .*/\1/p' "$work/help")
holds 'there are scenes' test "$(echo "$names" | wc -l)" -ge 10
for one in $names; do
    $scene "$one" >"$work/first" 2>"$work/errors"
    holds "scene $one writes bodies" grep -q '^pos 0 ' "$work/first"
    $scene "$one" -o "$work/second.plist" >>"$work/errors" 2>&1
    holds "scene $one: the same bytes in a file" \
        cmp "$work/first" "$work/second.plist"
    holds "scene $one: the head says how it was made" sh -c "
        sed -n 1p '$work/first' | grep -q '^# scene (Bonkers) ' &&
        sed -n 2p '$work/first' | grep -qx '# command: scene $one' &&
        sed -n 3p '$work/first' | grep -q '^# $one: '"
    $scene "$one" --help >"$work/own" 2>>"$work/errors"
    holds "scene $one --help lists its keys" sh -c "
        grep -c '^# --' '$work/first' >'$work/n'
        test \$(grep -c '^      --.* X\|^      --.* N' '$work/own') -eq \
            \$(cat '$work/n')"
    holds "scene $one says nothing else" sh -c "! test -s '$work/errors'"
    for key in $(sed -n 's/^# --\([a-z0-9-]*\) .*/\1/p' "$work/first"); do
        refuses 2 "--$key: 'x' is not a" $scene "$one" "--$key" x
    done
done

# A key changes what it says.
$scene sun-earth --mass 1e-5 >"$work/heavy"
holds 'a key reaches the scene' \
    sh -c "grep '^pos 1 ' '$work/heavy' | grep -q ' 1.0000000000000001e-05 '"
holds 'the command stands in the head' \
    grep -qx '# command: scene sun-earth --mass 1e-5' "$work/heavy"
$scene ring --particles 5 --seed 3 >"$work/a"
$scene ring --particles 5 --seed 3 >"$work/b"
holds 'the same seed, the same bytes' cmp "$work/a" "$work/b"

refuses 2 'which scene? see scene --help' $scene
refuses 2 "'trio' is no scene; there are sun-earth, " $scene trio
refuses 2 "'': no scene\|'' is no scene" $scene ''
refuses 2 "unknown option '--nx'; see scene --help" $scene sun-earth --nx 3
refuses 2 "'ring': the name of one scene comes first" $scene sun-earth ring
refuses 2 'the name of one scene comes first' $scene -o "$work/c" ring
refuses 2 "'2.5' is not a whole number from" $scene ring --particles 2.5
refuses 2 "'-1' is not a number" $scene oscillator --mass -1
refuses 2 'needs a value' $scene oscillator --mass
refuses 2 "'nan' is not a number" $scene oscillator --mass nan
refuses 1 'cannot write' $scene ring -o "$work/no/such/file"
refuses 1 'cannot write .*: No space' $scene ring -o /dev/full
holds 'nothing is left of what was refused' \
    sh -c "test ! -e '$work/c' && ! ls '$work' | grep -q bonkers"

# A million bodies in less than two seconds; it takes 0.7 on a slow machine.
build/bin/scene-speed -o "$work/speed"
seconds=$(sed -n 's/^scene 1000000 [0-9.]* //p' "$work/speed")
holds "a million bodies are read in $seconds s" \
    awk "BEGIN { exit !($seconds > 0 && $seconds < 2) }"

holds 'the reader of scenes, fuzzed' \
    ${MAKE:-make} -s fuzz-scenes TEXTS=20000
cc=${CC:-cc}
if $cc -std=c11 -D_POSIX_C_SOURCE=200809L -g -O1 -ffp-contract=off \
    -fsanitize=address,undefined -Isrc -o "$work/alone" tests/fuzz/scene.c \
    tests/fuzz/alone.c src/scenes/scene.c src/scenes/decimal.c src/toolbox/random.c src/toolbox/aligned.c \
    -lm; then
    holds 'and fuzzed without libFuzzer' \
        "$work/alone" -runs=10000 tests/fuzz/seeds
fi
keys=$(for one in $names; do $scene "$one" | grep '^# --'; done | wc -l)
echo "1..$((20 + 5 * $(echo "$names" | wc -l) + keys))"
